"""Build the site: ``./run site [FOLDER]``; without a folder into ``build/site/html``."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path
from typing import Any

from sphinx.cmd.build import build_main

from docs.site import along, benchmarks, executed, page_data, pages
from docs.site.vendor import lay_out_mathjax, vendor
from exactspline.verification.combined import computed_once

HERE = Path(__file__).parent
DOCS = HERE.parent
PROJECT = DOCS.parent
BUILD = PROJECT / "build" / "site"

#: The pages that are written by hand, in reading order.
WRITTEN = (
    "first-hour",
    "concepts",
    "teaching",
    "what-is-trusted",
    "ten-claims",
    "your-own-paper",
    "degree-theorem",
    "surfaces",
    "bisectors",
    "bisectors-of-surfaces",
    "two-parameters",
    "conditioning",
    "approximated",
    "certified-filter",
    "scoreboard",
)


def main() -> int:
    """Lay out the sources, make what is made, and run Sphinx with warnings as errors."""
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else BUILD / "html"
    source = BUILD / "source"
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    play = source / "_extra" / "play"
    shutil.copytree(DOCS / "play", play, ignore=shutil.ignore_patterns("__pycache__"))
    for kind in ("js", "css"):
        shutil.copy(PROJECT / "exactspline" / "display" / "plot" / f"turning.{kind}", play / "js")
    vendor(PROJECT / ".site-cache", play / "vendor", PROJECT)
    lay_out_mathjax(play / "vendor", source / "_static" / "mathjax")
    for name in ("pages.css", "pages.js"):
        shutil.copy(HERE / name, source / "_static")
    with computed_once():
        claims = page_data.claims()
        page_data.write(play / "data", claims)
        _lay_out(source, claims)
    return int(
        build_main(["-b", "html", "-W", "--keep-going", "-q", "-d", str(BUILD / "doctrees"), str(source), str(target)])
    )


def _lay_out(source: Path, claims: list[dict[str, Any]]) -> None:
    """All pages and their contents list."""
    for file in (HERE / "conf.py", HERE / "icon.svg", *DOCS.glob("*.md")):
        shutil.copy(file, source)
    shutil.copytree(DOCS / "pictures", source / "pictures")
    # with new times: outputs of a notebook depend on the library, which Sphinx does not watch
    shutil.copytree(
        PROJECT / "notebooks", source / "notebooks", ignore=shutil.ignore_patterns("*.toml"), copy_function=shutil.copy
    )
    executed.execute(source / "notebooks")
    for page in source.glob("*.md"):
        page.write_text(_linked(page.read_text(encoding="utf-8")), encoding="utf-8")
    notebooks = sorted(f"notebooks/{file.stem}" for file in (source / "notebooks").glob("*.ipynb"))
    reference = pages.reference(source / "reference")
    pages.write_glossary(source / "glossary.md")
    pages.write_errata(source / "errata.md")
    ledgers = pages.write_ledgers(source / "ledger", claims)
    benchmarks.write_page(source / "benchmarks.md")
    pages.draw_gallery(source / "_extra" / "gallery", source / "gallery.md")
    read = along.write_reading(source / "reading-along", source / "_extra" / "gallery")
    written = [page for page in WRITTEN if (source / f"{page}.md").exists()]
    house = sorted(file.stem for file in DOCS.glob("*.md") if file.stem not in WRITTEN)
    contents = {
        "To read": [*written, "gallery", "benchmarks", "glossary"],
        "Reading along": read,
        "Notebooks": notebooks,
        "Ledgers": ["errata", *ledgers],
        "Reference": reference,
        "The house": house,
    }
    index = (HERE / "index.md").read_text(encoding="utf-8")
    for caption, names in contents.items():
        index += "\n```{toctree}\n:hidden:\n:caption: " + caption + "\n\n" + "\n".join(names) + "\n```\n"
    (source / "index.md").write_text(index, encoding="utf-8")


def _linked(text: str) -> str:
    """Notebooks lie beside the pages here; links into the repository that no page stands behind become plain words."""
    text = text.replace("](../notebooks/", "](notebooks/")
    return re.sub(r"\[([^\]]+)\]\(\.\./[^)]*\)", r"\1", text)


if __name__ == "__main__":
    sys.exit(main())
