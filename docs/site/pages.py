"""The pages of the site that are made from the library: reference, glossary, errata, gallery."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from contextlib import redirect_stdout
from functools import cache
from io import StringIO
from itertools import chain
from operator import attrgetter
from pathlib import Path

import exactspline as xs
from docs.site.narrow import beside, narrowed, png, saved
from exactspline.cli import app
from exactspline.display.console import glossary
from exactspline.display.evidence import worded
from exactspline.display.figures import Drawn, figures, make
from exactspline.display.latex_prose import parts
from exactspline.display.numbers import Numbers
from exactspline.display.sheet import code_lines, in_markdown
from exactspline.errors import counted
from exactspline.papers import papers
from exactspline.verification.statement import Erratum, errata

#: The length of the lines of code on the page of errata.
CODE_WIDTH = 88

#: Pictures of the gallery besides the figures of the paper: a name, and the command that draws it.
DRAWN = {
    "vertices_of_an_ellipse": ("inspect", "ellipse_skew"),
    "a_straight_piece_between_arcs": ("inspect", "straight_between_arcs"),
    "a_cusp": ("inspect", "cusp"),
    "a_point_and_a_curve_in_the_plane": ("bisector", "cubic_s", "--point", "7/4,3/2"),
    "a_point_and_a_curve_in_space": ("bisector", "twisted_cubic", "--point", "1,0,1"),
}


def reference(folder: Path) -> list[str]:
    """One page per topic: the names of the front door under the headings of its stub, then those of each room."""
    folder.mkdir(parents=True, exist_ok=True)
    pages = []
    for number, (heading, names) in enumerate(topics().items(), 1):
        title = heading.capitalize()
        blocks = [f"# {title}", *map(_documented, names)]
        page = f"api/{number:02}-{'-'.join(re.findall('[a-z]+', heading.lower()))}"
        (folder.parent / f"{page}.md").write_text("\n\n".join(blocks) + "\n", encoding="utf-8")
        pages.append(page)
    return pages


def topics() -> dict[str, list[str]]:
    """The front door as its stub groups it: the comments are the headings; then the rooms that it names."""
    found: dict[str, list[str]] = {}
    rooms: list[str] = []
    for line in Path(xs.__file__).with_name("__init__.pyi").read_text(encoding="utf-8").splitlines():
        words = line.split()
        if line.startswith("# "):
            names = found.setdefault(line[2:], [])
        elif line.startswith("from . import"):
            rooms.append(words[-1])
        elif line.startswith("from "):
            names.append(words[-1])
    for room in rooms:
        found[room] = [f"{room}.{name}" for name in getattr(xs, room).__all__]
    return {heading: names for heading, names in found.items() if names}


def _documented(name: str) -> str:
    value = attrgetter(name)(xs)
    kind = "autoclass" if inspect.isclass(value) else "autofunction" if inspect.isroutine(value) else "autodata"
    options = "   :members:\n" if kind == "autoclass" else ""
    return f"## {name}\n\n```{{eval-rst}}\n.. {kind}:: exactspline.{name}\n{options}```"


def write_glossary(file: Path) -> None:
    """Every word and sign of the tables, by topic."""
    lines = ["# Glossary"]
    for topic, terms in glossary().items():
        lines += [f"## {topic.capitalize()}", *(f"{term}\n: {meaning}" for term, meaning in terms.items())]
    file.write_text("\n\n".join(lines) + "\n", encoding="utf-8")


def write_errata(file: Path) -> None:
    """What the sources say that is not so: an error a section, from the words to what holds instead."""
    lines = [
        "# Errata",
        "All refuted statements of the sources, each with its words, the claim that decides it, the finding, the "
        "correction and its reason, and Python code that shows the error. `./run errata` prints the same.",
    ]
    for source in papers():
        if found := errata([source]):
            statements = sum(len(error.statements) for error in found)
            told = f"{counted(len(found), 'error')}, {counted(statements, 'statement')} refuted."
            lines += [f"## {plain(source.title)}", told, *chain.from_iterable(map(_erratum, found))]
    file.write_text("\n\n".join(filter(None, lines)) + "\n", encoding="utf-8")


def _erratum(error: Erratum) -> Iterator[str]:
    """The section of one error, under an address of its own."""
    anchor = address_of(error)
    yield f"({anchor})=\n### {plain(error.title)}"
    for each in error.statements:
        words = f" “{typeset(each.words)}”" if each.words else ""
        yield f"> **{plain(each.place)}**{words}"
        told = {"Found": worded(each.found), "Witness": worded(each.witness, Numbers())}
        claim = f'<a href="play/claims.html?{each.key}">{plain(each.id)}</a>'
        decided = f"- Decided: {plain(each.statement)} ({claim})"
        yield "\n".join([decided, *(f"- {name}: {plain(text)}" for name, text in told.items() if text)])
    holds = [
        f'- Instead: {plain(str(each))} (<a href="play/claims.html?{each.key}">{plain(each.key)}</a>)'
        for each in error.truth
    ]
    yield "\n".join([*holds, *(f"- Why: {plain(line)}" for line in error.why)])
    code = list(dict.fromkeys(line for each in error.statements for line in each.check))
    yield "\n".join(["```python", *(part for line in code for part in code_lines(line, CODE_WIDTH)), "```"])
    yield f"[Permalink](#{anchor})"


def address_of(error: Erratum) -> str:
    """The fragment of the page of errata at which an error stands."""
    return f"{error.paper.replace('_', '-')}-{error.error}"


def plain(text: str) -> str:
    r"""A text in Markdown, where it means nothing but itself.

    >>> plain("2*x*y < z_1 | $5")
    '2\\*x\\*y &lt; z\\_1 \\| \\$5'
    """
    return in_markdown(re.sub(r"[\\*_$`]", r"\\\g<0>", text))


def typeset(words: str) -> str:
    r"""Words of a source in Markdown, their formulas between dollars.

    >>> typeset(r"\kappa = |x|")
    '$\\kappa = \\vert x\\vert $'
    """
    without_bars = ((f"${_without_bars(text)}$" if is_formula else plain(text)) for is_formula, text in parts(words))
    return "".join(without_bars)


def _without_bars(tex: str) -> str:
    """A bar would end the cell of a table."""
    return tex.replace(r"\|", r"\Vert ").replace("|", r"\vert ")


@cache
def figure(number: int) -> Drawn:
    """A figure of the paper: drawn once for all pages."""
    return figures()[number]()


def picture(file: str, alt: str) -> str:
    """A picture in a page; those that are drawn here have another one for narrow windows."""
    small = f"{file.removesuffix('.svg')}-narrow.png"
    source = f'<source media="(max-width: 700px)" srcset="{small}">' if file.endswith(".svg") else ""
    return f'<picture>{source}<img src="{file}" alt="{alt}" style="max-width:100%"></picture>'


def draw_gallery(folder: Path, page: Path) -> None:
    """The figures with their captions, and the page that shows them."""
    folder.mkdir(parents=True, exist_ok=True)
    made = {f"figure{number}": make(number, folder, figure(number), ("svg",)) for number in figures()}
    for number in figures():
        beside(folder / f"figure{number}.svg").write_bytes(png(narrowed(figure(number).figure)))
    for name, command in DRAWN.items():
        small = beside(folder / f"{name}.svg")
        with redirect_stdout(StringIO()), saved(lambda drawn, _, file=small: file.write_bytes(png(narrowed(drawn)))):
            app([*command, "--quiet", "--plot", str(folder / f"{name}.svg")], standalone_mode=False)
    lines = ["# Gallery", "Pictures drawn by `./run paper figures`, `inspect --plot` and `bisector --plot`."]
    for name in (*made, *DRAWN):
        title = name.replace("_", " ").replace("figure", "figure ").capitalize()
        lines += [f"## {title}", picture(f"gallery/{name}.svg", title)]
        if name in made:
            lines.append(plain(made[name].caption))
        if (folder / f"{name}.html").exists():
            lines.append(f'<a href="gallery/{name}.html">The same, to rotate</a>')
    page.write_text("\n\n".join(lines) + "\n", encoding="utf-8")
