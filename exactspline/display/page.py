"""Self-contained HTML pages: one frame, and the lists and tables that pages share."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from importlib.resources import files

#: The colours and fonts that these pages share with the site.
SHARED = files("exactspline.display").joinpath("page.css").read_text(encoding="utf-8")
_PARTS = files("exactspline.display").joinpath("pages.css").read_text(encoding="utf-8")


def style(part: str) -> str:
    """A part of ``pages.css``.

    >>> style("lines")[:20]
    '\\n.line{border-bottom'
    """
    return _PARTS.partition(f"/* {part} */")[2].partition("\n/*")[0]


def page(title: str, body: str, own: str) -> str:
    """A page for any browser, without a network: `body` and `own` are HTML and CSS, the title is plain text.

    >>> page("a < b", "<p>c</p>", "p{margin:0}").splitlines()[1:3]
    ['<html lang="en">', '<meta charset="utf-8">']
    """
    return (
        '<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>{SHARED}{style('page')}{own}</style>\n{body}\n</html>\n"
    )


def cells(texts: Iterable[str], tag: str = "td") -> str:
    """The cells of a row, of plain text.

    >>> cells(["a < b", "c"])
    '<td>a &lt; b</td><td>c</td>'
    """
    return "".join(f"<{tag}>{escape(text)}</{tag}>" for text in texts)


def table(rows: Iterable[Sequence[str]]) -> str:
    """A table of plain text."""
    return f"<table>{''.join(f'<tr>{cells(row)}</tr>' for row in rows)}</table>"


def definitions(entries: Iterable[tuple[str, str]]) -> str:
    """A list of terms (plain text) with their definitions (HTML)."""
    return f"<dl>{''.join(f'<dt>{escape(term)}</dt><dd>{shown}</dd>' for term, shown in entries)}</dl>"
