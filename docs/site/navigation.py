"""The side bar, the same on written pages and on interactive ones."""

from __future__ import annotations

from html import escape
from pathlib import Path

#: The sections of the side bar, in order: pages of these names.
SECTIONS = ("tutorials", "how-to", "reference", "explanation", "contributors")
#: The interactive pages, in order, with their names.
INTERACTIVE = {
    "curve": "A curve, exactly",
    "de-boor": "De Boor’s triangle",
    "degrees": "Degrees, side by side",
    "reduce": "What cancels",
    "claims": "What is true",
    "bisector": "Point and curve",
    "pair": "Two curves",
    "surface": "Surfaces",
}
#: What an interactive page has in the place of the side bar.
PLACE = '<nav aria-label="pages"></nav>'


def title(page: Path) -> str:
    """The heading of a page of Markdown."""
    return page.read_text(encoding="utf-8").partition("\n")[0].removeprefix("# ")


def fill(page: Path, source: Path) -> None:
    """Put the side bar into an interactive page; the written pages lie in `source`."""
    sections = "\n".join(f'<a href="../{name}.html">{escape(title(source / f"{name}.md"))}</a>' for name in SECTIONS)
    text = page.read_text(encoding="utf-8")
    page.write_text(text.replace(PLACE, _bar(sections, page.stem)), encoding="utf-8")


def _bar(sections: str, here: str) -> str:
    search = '<input type="search" name="q" placeholder="Search" aria-label="Search" />'
    others = "\n".join(
        f'<a href="{name}.html"{" aria-current=page" if name == here else ""}>{escape(shown)}</a>'
        for name, shown in INTERACTIVE.items()
    )
    return f"""<nav aria-label="pages">
<a class="brand" href="../index.html">exactspline</a>
<form action="../search.html">{search}</form>
{sections}
<b>Interactive pages</b>
{others}
</nav>"""


def context() -> dict[str, dict[str, str]]:
    """The interactive pages for the template of the written ones, by address."""
    return {"interactive": {f"play/{name}": shown for name, shown in INTERACTIVE.items()}}
