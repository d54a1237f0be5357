"""Sheets of exercises and of solutions: as text, as a LaTeX document, as an HTML page, as data."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape

from exactspline.display import mathml
from exactspline.display.evidence import filled
from exactspline.display.latex import fraction, mathematics, unicode_latex
from exactspline.display.latex_prose import prose
from exactspline.display.numbers import polynomial_text
from exactspline.display.page import page
from exactspline.display.sheet import hanging
from exactspline.extras.teaching.differences import Difference
from exactspline.extras.teaching.display.triangles import scheme_mathml, sheets
from exactspline.extras.teaching.exercises import Exercise
from exactspline.extras.teaching.parts import Math, Part, Polynomial, Value
from exactspline.extras.teaching.topics import about
from exactspline.extras.teaching.triangles import Triangle
from exactspline.numbers.exact import point_text, text


def _title_of(made: Exercise) -> str:
    """The identification of an exercise: topic and seed."""
    return f"{made.topic}, seed {made.seed}"


# ---- text


def _value_text(value: Value) -> str:
    if isinstance(value, Polynomial):
        return polynomial_text(value.coefficients)
    return point_text(value) if isinstance(value, tuple) else text(value)


def _math_text(math: Math) -> str:
    values = ", ".join(map(_value_text, math.values))
    return f"{math.name} = {values}" if math.name and values else math.name or values


def _plain(parts: Sequence[Part]) -> str:
    """Prose and formulas in one line; triangles are omitted."""
    said = [part if isinstance(part, str) else _math_text(part) for part in parts if not isinstance(part, Triangle)]
    return " ".join("".join(said).split())


def text_lines(made: Sequence[Exercise], width: int, *, solutions: bool) -> list[str]:
    """The numbered exercises under the headings of their topics, followed by the solutions."""
    lines: list[str] = []
    for i, (heading, each) in enumerate(_with_headings(made), 1):
        lines += [heading, ""] if heading else []
        lines += _paragraph(f"{i}. {_plain(each.task)} [{_title_of(each)}]", width)
        lines += [*_paragraph(f"   Answer: {each.answer.form}.", width, 3), ""]
    if solutions:
        lines += ["Solutions", ""]
        for i, each in enumerate(made, 1):
            lines += [*solution_lines(each, width, f"{i}. "), ""]
    return lines[:-1]


def _with_headings(made: Sequence[Exercise]) -> list[tuple[str, Exercise]]:
    """Exercises of several topics, each topic with a heading; exercises of one topic have no heading."""
    several = len({each.topic for each in made}) > 1
    before = ["", *(each.topic for each in made)]
    return [
        (about(each.topic) if several and each.topic != last else "", each)
        for last, each in zip(before, made, strict=False)
    ]


def solution_lines(made: Exercise, width: int, number: str = "   ") -> list[str]:
    """The answer of an exercise and the way to it."""
    lines = _paragraph(f"{number}{_plain(made.answer.parts)}", width)
    # a triangle in text has its own title
    said = _plain(made.solution).removesuffix("De Boor's triangle:").rstrip()
    lines += _paragraph(f"   {said}", width, 3) if said else []
    for part in made.solution:
        if isinstance(part, Triangle):
            lines += [f"   {line}" for line in sheets(part)[0].text(max(20, width - 3)).splitlines()]
    return lines


def _paragraph(said: str, width: int, first: int = 0) -> list[str]:
    return hanging(said, width, indent=3, first=first)


# ---- LaTeX


def _value_latex(value: Value) -> str:
    if isinstance(value, Polynomial):
        parts = [(c, "" if not i else "t" if i == 1 else f"t^{{{i}}}") for i, c in enumerate(value.coefficients) if c]
        terms = "".join(
            ("-" if c < 0 else "+") + ("" if abs(c) == 1 and power else fraction(abs(c))) + power for c, power in parts
        )
        return terms.removeprefix("+") or "0"
    if not isinstance(value, tuple):
        return fraction(value)
    inner = r",\; ".join(map(fraction, value))
    return rf"\left({inner}\right)"


def _symbol_latex(name: str) -> str:
    return rf"\text{{{prose(name)}}}" if re.search("[a-z]{3}", name) else unicode_latex(name)


def _part_latex(part: Part) -> str:
    if isinstance(part, str):
        return prose(part)
    if isinstance(part, Triangle):
        return f"\\[\n{mathematics(part)}\n\\]"
    # allow a line break after a comma
    values = ",$ $".join(map(_value_latex, part.values))
    name = _symbol_latex(part.name)
    return f"${name} = {values}$" if name and values else f"${name or values}$"


def latex_document(made: Sequence[Exercise], *, solutions: bool) -> str:
    """A complete document; the solutions begin on a new page."""
    tasks: list[str] = []
    for heading, each in _with_headings(made):
        tasks += [rf"\item[] \textbf{{{_part_latex(heading)}}}"] if heading else []
        tasks.append(f"\\item {''.join(map(_part_latex, each.task))} {{\\small [{_title_of(each)}]}}")
        tasks.append(rf"\\ {{\small Answer: {_part_latex(each.answer.form)}}} \hrulefill")
    lines = [
        r"\documentclass{article}",
        r"\usepackage[utf8]{inputenc}",
        r"\usepackage{amsmath}",
        r"\begin{document}",
        r"\section*{Exercises}",
        r"\noindent Name: \hrulefill\quad Date: \underline{\hspace{4cm}}",
        r"\begin{enumerate}",
        *tasks,
        r"\end{enumerate}",
    ]
    if solutions:
        lines += [r"\newpage", r"\section*{Solutions}", r"\begin{enumerate}"]
        for each in made:
            answer, way = ("".join(map(_part_latex, parts)) for parts in (each.answer.parts, each.solution))
            lines.append(f"\\item \\textbf{{Answer:}} {answer}.\n\n{way}")
        lines.append(r"\end{enumerate}")
    return "\n".join([*lines, r"\end{document}"]) + "\n"


# ---- HTML

#: Lines to write on.
LINES = """
.line{border-bottom:1px solid var(--soft);margin:1.6rem 0 .6rem;display:flex}.line span{margin-left:60%}
"""


def _value_mathml(value: Value) -> str:
    if isinstance(value, Polynomial):
        terms = ""
        for i, c in enumerate(value.coefficients):
            if c:
                terms += f"<mo>{'−' if c < 0 else '+'}</mo>" if terms or c < 0 else ""
                terms += "" if abs(c) == 1 and i else mathml.number(abs(c))
                terms += "" if not i else "<mi>t</mi>" if i == 1 else f"<msup><mi>t</mi><mn>{i}</mn></msup>"
        return f"<mrow>{terms or '<mn>0</mn>'}</mrow>"
    return mathml.tuple_of(map(mathml.number, value)) if isinstance(value, tuple) else mathml.number(value)


def _part_html(part: Part) -> str:
    if isinstance(part, str):
        return escape(part)
    if isinstance(part, Triangle):
        return f'<div class="wide">{mathml.math(scheme_mathml(part), block=True)}</div>'
    # lines may be broken between formulas, not inside one
    shown = [mathml.math(_value_mathml(value)) for value in part.values]
    name = f"<i>{escape(part.name)}</i>" if part.name else ""
    values = ", ".join(shown)
    return f"{name} = {values}" if name and values else name or values


def task_html(made: Exercise) -> str:
    """The question, and the format of the answer."""
    return f"<p>{''.join(map(_part_html, made.task))}</p><p><small>Answer: {escape(made.answer.form)}</small></p>"


def html_page(made: Sequence[Exercise], *, solutions: bool) -> str:
    """A printable page with lines for name, date and answers; the solutions begin on a new sheet."""
    tasks = []
    for number, (heading, each) in enumerate(_with_headings(made), 1):
        said = f"{''.join(map(_part_html, each.task))} <small>[{escape(_title_of(each))}]</small>"
        answer = f'<p class="line"><small>Answer: {escape(each.answer.form)}</small></p>'
        tasks.append(f"<h2>{escape(heading)}</h2>" if heading else "")
        tasks.append(f'<ol start="{number}"><li>{said}{answer}</li></ol>')
    body = f'<h1>Exercises</h1><p class="line">Name: <span>Date:</span></p>{"".join(tasks)}'
    if solutions:
        ways = [
            f"<li><b>{''.join(map(_part_html, e.answer.parts))}</b><p>{''.join(map(_part_html, e.solution))}</p></li>"
            for e in made
        ]
        body += f'<section class="solutions"><h1>Solutions</h1><ol>{"".join(ways)}</ol></section>'
    return page("Exercises", body, mathml.STYLE + LINES)


# ---- answers


def hinted(difference: Difference) -> str:
    """An error in words, without the right value.

    >>> from exactspline.extras.teaching.differences import OtherNumber
    >>> from exactspline.numbers.exact import mpq
    >>> hinted(OtherNumber("x", mpq(1), mpq(2)))
    'x is not 2'
    """
    return filled(difference.hint, difference) or str(difference)


# ---- data


def exercise_data(made: Exercise, *, solutions: bool) -> dict[str, object]:
    """An exercise as data; answer and solution on request."""
    data: dict[str, object] = {
        "key": _title_of(made),
        "topic": made.topic,
        "seed": made.seed,
        "task": _plain(made.task),
        "form": made.answer.form,
    }
    return data | ({"answer": made.answer.written, "solution": _plain(made.solution)} if solutions else {})
