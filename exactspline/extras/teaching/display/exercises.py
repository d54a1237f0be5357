"""Sheets of exercises and of solutions: as text, as a LaTeX document, as an HTML page, as data. Triangles of fractions
and tables of products: as tables of text, as LaTeX, as HTML with MathML, as data.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from html import escape

from exactspline.display import mathml
from exactspline.display.forms import Data, picked
from exactspline.display.latex import fraction, latex, mathematics, unicode_latex
from exactspline.display.latex_prose import prose
from exactspline.display.numbers import polynomial_text
from exactspline.display.page import page, style
from exactspline.display.sheet import Sheet, hanging
from exactspline.extras.teaching import differences as wrong
from exactspline.extras.teaching.parts import Math, Part, Polynomial, Value
from exactspline.extras.teaching.topics import Exercise, about
from exactspline.extras.teaching.triangles import ProductTable, Row, Triangle
from exactspline.numbers.exact import point_text, text
from exactspline.verification.evidence import Phrase, Said

#: The name of a scheme.
_TITLES = {"de Boor": "De Boor's triangle", "insertion": "Knot insertion", "elevation": "Degree elevation"}
Scheme = Triangle | ProductTable


def _title(scheme: Scheme) -> str:
    """The title of a scheme.

    >>> from exactspline import BSpline
    >>> from exactspline.extras.teaching import de_boor_triangle
    >>> _title(de_boor_triangle(BSpline.bezier([0, 1, 3]), "1/2"))
    "De Boor's triangle at t = 1/2 in [0, 1], degree 2"
    """
    a, b = map(text, scheme.span)
    if isinstance(scheme, ProductTable):
        return f"Product on [{a}, {b}] of degrees {len(scheme.left) - 1} and {len(scheme.right) - 1}"
    at = "" if scheme.parameter is None else f" at t = {text(scheme.parameter)}"
    coordinates = ", points multiplied by their weights, then the weight" if scheme.rational else ""
    degree = f"degree {scheme.degree}"
    if scheme.method == "elevation":
        degree = f"Bézier points of degree {scheme.degree} to {scheme.degree + len(scheme.ratios)}"
    return f"{_TITLES[scheme.method]}{at} in [{a}, {b}], {degree}{coordinates}"


def _rule(scheme: Scheme) -> str:
    """The rule by which the entries are computed, in words."""
    if isinstance(scheme, ProductTable):
        return (
            "Bézier points times binomial coefficients are multiplied; the sum of a diagonal, divided by the binomial "
            "coefficient of the product's degree, is a Bézier point of the product."
        )
    if scheme.method == "elevation":
        return "An entry is s times the entry above it in the previous column plus 1 − s times the entry to its left."
    return "An entry is 1 − s times the entry above it in the previous column plus s times the entry to its left."


def sheets(scheme: Scheme) -> list[Sheet]:
    """The points, below them the weights with which neighbours were combined, and the result."""
    return _product_sheets(scheme) if isinstance(scheme, ProductTable) else _triangle_sheets(scheme)


def _triangle_sheets(triangle: Triangle) -> list[Sheet]:
    steps = [f"step {r}" for r in range(1, len(triangle.columns))]
    cells, heading = _grid(triangle, triangle.columns, point_text), _title(triangle)
    points = Sheet("point", "given", *steps, rows=cells, title=heading, name=heading)
    ratios = ([label, *rest] for label, _, *rest in _grid(triangle, ((), *triangle.ratios), text) if any(rest))
    shares = Sheet("point", *steps, rows=ratios, title=f"Weights s. {_rule(triangle)}", name="shares")
    made = [points, shares] if triangle.ratios else [points]
    return [*made, *_result_sheets(triangle)]


def _result_sheets(triangle: Triangle) -> list[Sheet]:
    if triangle.method == "de Boor":
        if not triangle.rational:
            return []
        tip = [[point_text(triangle.tip)]]
        return [Sheet("point of the curve", rows=tip, title="Divided by its weight", name="tip")]
    if not triangle.made or triangle.knots is None:
        return []
    cells = [(f"e{i}", point_text(row)) for i, row in enumerate(triangle.made)]
    knots = ", ".join(map(text, triangle.knots))
    return [Sheet("point", "is", rows=cells, title=f"Knots: {knots}", name="result")]


def _product_sheets(table: ProductTable) -> list[Sheet]:
    columns = [f"·{text(b)} [{k}]" for k, b in enumerate(table.right)]
    products = [(text(a), *map(text, row)) for a, row in zip(table.left, table.table, strict=True)]
    pairs = enumerate(zip(table.sums, table.points, strict=True))
    sums = [(m, text(total), text(point)) for m, (total, point) in pairs]
    return [
        Sheet("times", *columns, rows=products, title=_title(table), name=_title(table)),
        Sheet("diagonal", "sum", "Bézier point", rows=sums, title=_rule(table), name="diagonals"),
    ]


def _grid(triangle: Triangle, columns: Sequence[Sequence[object]], written: Callable[..., str]) -> Iterable[list[str]]:
    """Labelled rows of cells. Each column begins one row lower than the one before, so that an entry is next to the
    lower of the two entries from which it is computed; in elevation each column ends one row lower.
    """
    bezier = triangle.first < 0
    first, letter = (0, "b") if bezier else (triangle.first, "d")
    height = max(map(len, columns)) if bezier else len(triangle.columns[0])
    for i in range(height):
        cells = []
        for column in columns:
            k = i if bezier else i - (height - len(column))
            cells.append(written(column[k]) if 0 <= k < len(column) else "")
        yield [f"{letter}{first + i}", *cells]


# ---- LaTeX


def scheme_latex(scheme: Triangle | ProductTable) -> str | None:
    """A triangle or a table of products for a notebook."""
    return latex(scheme)


def _point_latex(row: Row) -> str:
    """A value, or a point between parentheses."""
    inner = r",\ ".join(map(fraction, row))
    return inner if len(row) == 1 else rf"\left({inner}\right)"


@mathematics.register
def _(triangle: Triangle) -> str:
    lines = [
        " & ".join([f"{label[0]}_{{{label[1:]}}}", *cells])
        for label, *cells in _grid(triangle, triangle.columns, _point_latex)
    ]
    rows = " \\\\[4pt]\n".join(lines)
    return f"\\begin{{array}}{{l|{'l' * len(triangle.columns)}}}\n{rows}\n\\end{{array}}"


@mathematics.register
def _(table: ProductTable) -> str:
    head = " & ".join(["", *map(fraction, table.right)])
    pairs = zip(table.left, table.table, strict=True)
    rows = " \\\\[4pt]\n".join(" & ".join(map(fraction, (a, *row))) for a, row in pairs)
    return f"\\begin{{array}}{{r|{'r' * len(table.right)}}}\n{head} \\\\ \\hline\n{rows}\n\\end{{array}}"


def latex_text(schemes: Sequence[Scheme]) -> str:
    """Display formulas for a document that loads amsmath, each under a comment with its title."""
    return "\n\n".join(f"% {_title(s)}\n\\[\n{mathematics(s)}\n\\]" for s in schemes)


# ---- HTML


def _point_mathml(row: Row) -> str:
    """A value, or a point between parentheses."""
    return mathml.number(row[0]) if len(row) == 1 else mathml.tuple_of(map(mathml.number, row))


def _scheme_mathml(scheme: Scheme) -> str:
    """The table as one MathML formula."""
    if isinstance(scheme, ProductTable):
        head = ["", *map(mathml.number, scheme.right)]
        pairs = zip(scheme.left, scheme.table, strict=True)
        return mathml.table([head, *[[mathml.number(x) for x in (a, *row)] for a, row in pairs]])
    grid = _grid(scheme, scheme.columns, _point_mathml)
    return mathml.table([[mathml.name(f"{label[0]}_{label[1:]}"), *cells] for label, *cells in grid])


def schemes_page(schemes: Sequence[Scheme], heading: str) -> str:
    """A printable page."""
    parts = [
        f"<h2>{escape(_title(s))}</h2><p>{escape(_rule(s))}</p>"
        f'<div class="wide">{mathml.math(_scheme_mathml(s), block=True)}</div>{_weights_html(s)}{_result_html(s)}'
        for s in schemes
    ]
    return page(heading, f"<h1>{escape(heading)}</h1>{''.join(parts)}", style("mathematics"))


def _weights_html(scheme: Scheme) -> str:
    """The weights s of the rule, each at the place of its entry."""
    if isinstance(scheme, ProductTable) or not scheme.ratios:
        return ""
    grid = _grid(scheme, ((), *scheme.ratios), mathml.number)
    rows = [[mathml.name(f"{label[0]}_{label[1:]}"), *rest] for label, _, *rest in grid if any(rest)]
    return f'<p>Weights s:</p><div class="wide">{mathml.math(mathml.table(rows), block=True)}</div>'


def _result_html(scheme: Scheme) -> str:
    if isinstance(scheme, ProductTable):
        return _listed("Bézier points of the product", [(x,) for x in scheme.points])
    if scheme.method == "de Boor":
        return _listed("The point of the curve", [scheme.tip]) if scheme.rational else ""
    return _listed("Control points of the result", scheme.made) if scheme.made else ""


def _listed(what: str, rows: Sequence[Row]) -> str:
    point_text = "<mo>,</mo><mspace width='0.6em'/>".join(map(_point_mathml, rows))
    return f"<p>{escape(what)}: {mathml.math(f'<mrow>{point_text}</mrow>')}</p>"


# ---- data


def scheme_data(scheme: Scheme) -> Data:
    """A scheme as data: numbers as text."""
    data: Data = {"key": _title(scheme)} | picked(scheme, "span")
    if isinstance(scheme, ProductTable):
        return data | {"method": "product"} | picked(scheme, "left", "right", "table", "sums", "points")
    data |= picked(scheme, "method", "degree", "parameter", "rational", "first", "columns", "ratios")
    if scheme.method == "de Boor":
        data |= picked(scheme, "tip")
    return data | picked(scheme, "knots", "made") if scheme.made and scheme.knots is not None else data


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
        return f'<div class="wide">{mathml.math(_scheme_mathml(part), block=True)}</div>'
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
    return page("Exercises", body, style("mathematics") + style("lines"))


# ---- answers


#: Sentences without the right value, in place of those that name it.
_HINTS: dict[object, Callable[..., str]] = {
    wrong.other_number: lambda name, right, given: f"{name} is not {given}",
    wrong.other_point: lambda index, right, given: f"control point {index} is not {given}",
    wrong.other_coefficient: lambda name, power, right, given: f"{name}: the coefficient of t^{power} is not {given}",
    wrong.other_value: lambda name, at, right, given: f"{name or 'it'} is not {given} at t = {at}",
    wrong.missing: lambda parameter: "a parameter is missing",
}


def hinted(difference: wrong.Difference) -> str:
    """An error in words, without the right value.

    >>> from exactspline.numbers.exact import mpq
    >>> hinted(wrong.other_number("x", mpq(1), mpq(2)))
    'x is not 2'
    """
    if isinstance(difference, Said) and (hint := _HINTS.get(difference.phrase)):
        return str(Phrase(hint)(*difference.about))
    return str(difference)


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
