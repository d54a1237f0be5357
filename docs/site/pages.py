"""The pages of the site that are made from the library: reference, glossary, errata, gallery."""

from __future__ import annotations

import inspect
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable
from itertools import groupby
from pathlib import Path
from typing import Any

import exactspline as xs
from exactspline.display.glossary import glossary
from exactspline.display.sheet import Sheet

#: What stands in the place of words that the source does not have.
STATUS = {"ours": "goes beyond the source", "meant": "as the printed statement must read"}

#: Pictures of the gallery besides the figures of the paper: a name, and the command that draws it.
DRAWN = {
    "vertices_of_an_ellipse": ("inspect", "ellipse_skew"),
    "a_straight_piece_between_arcs": ("inspect", "straight_between_arcs"),
    "a_cusp": ("inspect", "cusp"),
    "a_point_and_a_curve_in_the_plane": ("bisector", "cubic_s", "--point", "7/4,3/2"),
    "a_point_and_a_curve_in_space": ("bisector", "twisted_cubic", "--point", "1,0,1"),
}


def reference(folder: Path) -> list[str]:
    """A page a topic: the names of the front door under the headings that they have there."""
    folder.mkdir(parents=True, exist_ok=True)
    pages = []
    for number, (heading, names) in enumerate(topics().items(), 1):
        title = heading.capitalize()
        blocks = [f"# {title}", *(_documented(name) for name in names)]
        page = f"reference/{number:02}-{'-'.join(re.findall('[a-z]+', heading.lower()))}"
        (folder.parent / f"{page}.md").write_text("\n\n".join(blocks) + "\n", encoding="utf-8")
        pages.append(page)
    return pages


def topics() -> dict[str, list[str]]:
    """The front door as its source groups it: the comments are the headings."""
    source = inspect.getsource(xs).partition("_HOMES = {")[2].partition("\n}")[0]
    found: dict[str, list[str]] = {}
    for line in map(str.strip, source.splitlines()):
        if line.startswith("# "):
            names = found.setdefault(line[2:], [])
        elif line.startswith('"'):
            names.append(line.split('"')[1])
    return found


def _documented(name: str) -> str:
    value = getattr(xs, name)
    kind = "autoclass" if inspect.isclass(value) else "autofunction" if inspect.isroutine(value) else "autodata"
    options = "   :members:\n" if kind == "autoclass" else ""
    return f"## {name}\n\n```{{eval-rst}}\n.. {kind}:: exactspline.{name}\n{options}```"


def write_glossary(file: Path) -> None:
    """Every word and sign of the tables, by topic."""
    lines = ["# Glossary"]
    for topic, terms in glossary().items():
        lines += [f"## {topic.capitalize()}", *(f"{term}\n: {meaning}" for term, meaning in terms.items())]
    file.write_text("\n\n".join(lines) + "\n", encoding="utf-8")


def write_ledgers(folder: Path, claims: Iterable[dict[str, Any]]) -> list[str]:
    """A page a source: its words beside the statement that is decided, and the verdict for all curves."""
    folder.mkdir(parents=True, exist_ok=True)
    by_source: dict[str, list[dict[str, Any]]] = {}
    for claim in claims:
        by_source.setdefault(claim["paper"], []).append(claim)
    for name, told in by_source.items():
        counts = Counter(claim["verdict"] for claim in told)
        tally = ", ".join(f"{count} {verdict}" for verdict, count in counts.most_common())
        lines = [f"# {told[0]['title']}", f"{tally}."]
        lines.append(
            "What was found for all curves; verdicts are explained in the [glossary](../glossary.md). Formulas, "
            'degrees and witnesses of each claim: <a href="../play/claims.html">the ledger that is searched</a>.'
        )
        for place, group in groupby(told, lambda claim: claim["source"]):
            sheet = Sheet("claim", "the source's words", "as it is decided", "verdict", "what is true")
            for c in group:
                words = f"“{c['words']}” ({c['place']})" if c["words"] else STATUS.get(c["status"], "–")
                found = "" if c["computed"] == c["claimed"] else c["computed"] or c["witness"]
                decided = f"{c['statement']}: {c['claimed']}" if c["kind"] in ("degree", "count") else c["statement"]
                sheet.add_row(c["id"], words, decided, c["verdict"], found)
            lines += [f"## {place}", sheet.markdown()]
        (folder / f"{name}.md").write_text("\n\n".join(lines) + "\n", encoding="utf-8")
    return [f"{folder.name}/{name}" for name in by_source]


def write_errata(file: Path) -> None:
    """What the sources say that is not so, in the words of the command."""
    told = _run("errata", "--paper", "all", "--markdown")
    file.write_text(f"# Errata\n\n{told}\n", encoding="utf-8")


def draw_gallery(folder: Path, page: Path) -> None:
    """The figures, and the page that shows them."""
    _run("figures", "--out", str(folder))
    for name, command in DRAWN.items():
        _run(*command, "--plot", str(folder / f"{name}.svg"))
    lines = ["# Gallery", "What `exactspline figures`, `inspect --plot` and `bisector --plot` draw."]
    pictures = [*sorted(folder.glob("figure?.svg")), *(folder / f"{name}.svg" for name in DRAWN)]
    for picture in pictures:
        title = picture.stem.replace("_", " ").replace("figure", "figure ").capitalize()
        lines += [f"## {title}", f'<img src="gallery/{picture.name}" alt="{title}" style="max-width:100%">']
        turning = picture.with_suffix(".html")
        if turning.exists():
            lines.append(f'<a href="gallery/{turning.name}">The same, to be turned</a>')
    page.write_text("\n\n".join(lines) + "\n", encoding="utf-8")


def _run(*arguments: str) -> str:
    command = [sys.executable, "-m", "exactspline", *arguments, "--quiet"]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout
