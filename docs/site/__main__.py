"""Build the site: ``./run site [FOLDER]``; without a folder into ``build/site/html``."""

from __future__ import annotations

import re
import shutil
import sys
import tarfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from fcntl import LOCK_EX, LOCK_NB, flock
from pathlib import Path
from time import monotonic

from sphinx.cmd.build import build_main

from docs.site import along, benchmarks, executed, kept, navigation, page_data, pages
from docs.site.vendor import lay_out_mathjax, vendor
from exactspline.verification.combined import computed_once

HERE = Path(__file__).parent
DOCS = HERE.parent
PROJECT = DOCS.parent
BUILD = PROJECT / "build" / "site"

#: What is said of the pages that are listed.
NOTEBOOKS = "Lessons that run: `./run notebooks` opens the first, `./run notebooks 01` number 01."
REFERENCE = "All public names: first those of `exactspline` itself, by topic, then those of its public modules."
#: What the archive of the source holds.
SOURCE = (
    *(
        "README.md",
        "LICENSE",
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        "SECURITY.md",
        "CITATION.cff",
        "pyproject.toml",
        "run",
    ),
    *("exactspline", "docs", "notebooks", "proofs", "reading", "stubs", "tests", "workshop"),
)


def main() -> int:
    """Build the site, where no other build of this checkout is under way: both would write the same folder."""
    BUILD.mkdir(parents=True, exist_ok=True)
    with (BUILD / "lock").open("w", encoding="utf-8") as lock:
        try:
            flock(lock, LOCK_EX | LOCK_NB)
        except BlockingIOError:
            print("error: another ./run site is building this site; wait until it has ended", file=sys.stderr)
            return 2
        return build()


def build() -> int:
    """Lay out the sources, make what is made, and run Sphinx with warnings as errors."""
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else BUILD / "html"
    source = BUILD / "source"
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    play = source / "_extra" / "play"
    shutil.copytree(DOCS / "play", play, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(PROJECT / "exactspline" / "display" / "page.css", play / "site.css")
    for kind in ("js", "css"):
        shutil.copy(PROJECT / "exactspline" / "extras" / "pictures3d" / f"turning.{kind}", play / "js")
    shutil.copytree(HERE / "templates", source / "_templates")
    # other programs download and pack while the pages are computed here
    with ThreadPoolExecutor(1) as other:
        vendored = other.submit(_vendor, play / "vendor", source / "_static")
        with computed_once(kept.proofs()):
            with _step("claims, curves and surfaces"):
                claims = page_data.claims()
                page_data.write(play / "data", claims)
            _lay_out(source)
        with _step("the library for the browser (downloads once)"):
            vendored.result()
    for page in play.glob("*.html"):
        navigation.fill(page, source)
    with _step("pages"):
        status = build_main(
            ["-b", "html", "-W", "--keep-going", "-q", "-d", str(BUILD / "doctrees"), str(source), str(target)]
        )
    if not status:
        own = f"python -m http.server --bind 127.0.0.1 --directory {target}"
        serve = "./run serve" if target == BUILD / "html" else own
        print(f"The site is in {target}\n{serve} shows it at http://localhost:8000")
    return int(status)


def _vendor(target: Path, static: Path) -> None:
    """What the pages need of others, and what is shown next to it."""
    vendor(PROJECT / ".site-cache", target, PROJECT)
    lay_out_mathjax(target, static / "mathjax")
    for name in ("pages.css", "pages.js"):
        shutil.copy(HERE / name, static)


@contextmanager
def _step(doing: str) -> Iterator[None]:
    """Say what is done, and how long it took."""
    print(f"{doing} … ", end="", flush=True)
    start = monotonic()
    yield
    print(f"{monotonic() - start:.0f} s", flush=True)


def _lay_out(source: Path) -> None:
    """All pages, in sections."""
    for file in (
        HERE / "conf.py",
        HERE / "icon.svg",
        HERE / "index.md",
        *DOCS.glob("*.md"),
        *HERE.glob("sections/*.md"),
    ):
        shutil.copy(file, source)
    shutil.copytree(DOCS / "pictures", source / "pictures")
    shutil.copytree(DOCS / "how-to", source / "how-to")
    # with new times: outputs of a notebook depend on the library, which Sphinx does not watch
    shutil.copytree(
        PROJECT / "notebooks", source / "notebooks", ignore=shutil.ignore_patterns("*.toml"), copy_function=shutil.copy
    )
    with _step("notebooks, executed"):
        executed.execute(source / "notebooks")
    with _step("reference, errata"):
        _collect(
            source / "notebooks.md",
            "Notebooks",
            NOTEBOOKS,
            sorted(f"notebooks/{n.stem}" for n in source.glob("*/*.ipynb")),
        )
        _collect(source / "api.md", "Every public name", REFERENCE, pages.reference(source / "api"))
        pages.write_glossary(source / "glossary.md")
        pages.write_errata(source / "errata.md")
        benchmarks.add_tables(source / "measurements.md", source / "_extra" / "gallery")
    with _step("gallery"):
        pages.draw_gallery(source / "_extra" / "gallery", source / "gallery.md")
    first, *others = along.write_reading(source / "reading-along", source / "_extra" / "gallery")
    _append_contents(source / f"{first}.md", [Path(name).name for name in others], hidden=True)
    _pack(source / "_extra" / "source" / "exactspline.tar.gz")
    for page in source.glob("*.md"):
        page.write_text(_linked(page.read_text(encoding="utf-8")), encoding="utf-8")
    for page in source.glob("how-to/*.md"):
        page.write_text(page.read_text(encoding="utf-8").replace("](../../", "](../"), encoding="utf-8")
    for book in source.glob("notebooks/*.ipynb"):
        # pages lie beside the folder of notebooks here, and anchors are in small letters
        text = book.read_text(encoding="utf-8").replace("](../docs/", "](../")
        book.write_text(re.sub(r"\]\(#[\w-]+\)", lambda m: m[0].lower(), text), encoding="utf-8")
    for section in HERE.glob("sections/*.md"):
        _add_contents(source / section.name)
    _append_contents(source / "index.md", list(navigation.SECTIONS), hidden=True)


def _collect(page: Path, title: str, what: str, names: list[str]) -> None:
    """A page that lists others, and says what they are."""
    page.write_text(f"# {title}\n\n{what}\n", encoding="utf-8")
    _append_contents(page, names, hidden=False)


def _add_contents(page: Path) -> None:
    """The pages to which a section links are its contents."""
    names = re.findall(r"\]\(([\w/-]+)\.md\)", page.read_text(encoding="utf-8"))
    _append_contents(page, names, hidden=True)


def _append_contents(page: Path, names: list[str], *, hidden: bool) -> None:
    options = ":hidden:\n" if hidden else ":maxdepth: 1\n"
    with page.open("a", encoding="utf-8") as file:
        file.write("\n```{toctree}\n" + options + "\n" + "\n".join(names) + "\n```\n")


def _pack(archive: Path) -> None:
    """The source, as the front page offers it."""
    archive.parent.mkdir(parents=True)
    with tarfile.open(archive, "w:gz") as packed:
        for name in SOURCE:
            packed.add(PROJECT / name, f"exactspline/{name}", filter=_without_bytecode)


def _without_bytecode(entry: tarfile.TarInfo) -> tarfile.TarInfo | None:
    return None if "__pycache__" in entry.name or "/." in entry.name else entry


def _linked(text: str) -> str:
    """Notebooks lie beside the pages here; links into the repository that no page stands behind become plain words."""
    text = text.replace("](../notebooks/", "](notebooks/")
    return re.sub(r"\[([^\]]+)\]\(\.\./[^)]*\)", r"\1", text)


if __name__ == "__main__":
    sys.exit(main())
