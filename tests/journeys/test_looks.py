"""Every page that a reader is given, looked at in a browser; and that each look notices what it is there for.

The pages of the site are looked at where it was built (`./run site`).
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from exactspline.display.plot import new_figure
from tests.support.command import run
from tests.support.looking import (
    CHECKS,
    CHROMIUM,
    Ready,
    Seen,
    broken_links,
    laid_out,
    look,
    look_side_by_side,
    served,
    started,
    unreadable,
)

ROOT = Path(__file__).parents[2]
SITE = ROOT / "build" / "site" / "html"


def in_a_browser(test: Any) -> Any:
    """A test that needs a browser."""
    return pytest.mark.browser(pytest.mark.skipif(CHROMIUM is None, reason="no Chromium here")(test))


#: A good page, into which one defect at a time is put.
GOOD = """<!doctype html><html lang="en"><meta name="viewport" content="width=device-width"><title>good</title>
<style>:root{color-scheme:light dark}</style><p id="here">The curve costs 5 $, or <code>$HOME and $PATH</code>.
<a href="#here">here</a><img alt="nothing" src="data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA=">%s</html>"""
PICTURE = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' width='40' height='40'>%s</svg>"
WHITE = PICTURE % "<rect width='40' height='40' fill='white'/>"
#: What each look must notice, in several disguises.
DEFECTS = {
    "formulaErrors": [
        '<span class="katex-error" title="double subscript">P_2_{[0]}</span>',
        '<mjx-container><svg aria-hidden="true"><g data-mml-node="merror"></g></svg></mjx-container>',
        '<mjx-container><svg aria-hidden="true"><g data-mml-node="mtext" fill="red"></g></svg></mjx-container>',
    ],
    "texAsText": ["<table><td>$s = \\tfrac{1}{2}$</table>", "<pre>$x$</pre>", "<p>\\(x\\)", "<p>\\frac{1}{2}"],
    "machineReprs": [
        "<pre>&lt;a.Analysis object at 0x7f00a1&gt;</pre>",
        "<p>Proof(left='f1', right='f2')",
        "<pre>&gt;&gt;&gt; proof\nProof(left='f1')</pre>",
        "<td>&lt;Jump at 1: from -8 to 0&gt;</td>",
        "<p>error: &lt;Nurbs ellipse: rational, degree 2&gt;</p>",
        "<td>&lt;formula parabolic_lifted, lifted&gt;</td>",
        "<p>&lt;Verdict.PROVED: 'PROVED'&gt;</p>",
    ],
    "tooWide": [
        '<div style="overflow-x:auto"><div style="width:1700px">scrolled</div></div>',
        '<div style="overflow:hidden"><div style="width:1700px">clipped</div></div>',
        '<div style="width:300px"><table style="width:420px"><td>stands out</table></div>',
        '<pre style="width:200px;overflow:auto">a line that is a good deal longer than its frame is wide</pre>',
    ],
    "brokenWords": ['<table style="width:50px;table-layout:fixed;overflow-wrap:anywhere"><td>PROVED</table>'],
    "horizontalScroll": ['<div style="width:1500px">wide</div>', '<div style="width:430px">wide on a telephone</div>'],
    "poorContrast": [
        '<p style="color:#999">pale by day',
        '<p style="color:#555">dim by night',
        '<p style="opacity:0.4">faded',
        '<svg aria-label="a picture"><text y="20" fill="#bbb">pale</text></svg>',
    ],
    "smallText": [
        '<p style="font-size:6px">a caption',
        '<svg aria-label="a picture" viewBox="0 0 900 900" width="300" height="300" fill="currentColor">'
        '<text y="90" font-size="18">a caption</text></svg>',
    ],
    "strangeGrounds": [f'<img alt="white by night" src="{WHITE}">'],
    "withoutAlternative": [
        f'<img src="{PICTURE}">',
        f'<img alt="picture_1.png" src="{PICTURE}">',
        '<svg><path d="M0 0h9"/></svg>',
        "<canvas></canvas>",
    ],
    "links": ['<a href="#there">there</a>', '<a href="nowhere.html">nowhere</a>'],
}


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as player, started(player) as found:
        yield found


def planted(folder: Path) -> dict[str, str]:
    """The good page and the bad ones as files: the check that must notice each (none for the good one)."""
    pages = {"good.html": ""}
    (folder / "good.html").write_text(GOOD % "", encoding="utf-8")
    for check, defects in DEFECTS.items():
        for number, defect in enumerate(defects):
            pages[f"{check}{number}.html"] = check
            (folder / f"{check}{number}.html").write_text(GOOD % defect, encoding="utf-8")
    return pages


@in_a_browser
def test_every_look_notices_the_defect_it_is_there_for_and_no_other_does(browser, tmp_path):
    pages = planted(tmp_path)
    assert set(pages.values()) == {"", *CHECKS}
    with served(tmp_path) as address:
        seen = look(browser, address, pages)
        seen.wrong["links"] = broken_links(seen, address, tmp_path)
    # what is too wide for a telephone makes its window scroll, too
    also = {page: {"tooWide"} for page in pages if page.startswith("horizontalScroll")}
    also["tooWide2.html"] = {"horizontalScroll"}
    noticed = {page: {check for check in CHECKS if page in seen.wrong[check]} - also.get(page, set()) for page in pages}
    assert noticed == {page: {check} - {""} for page, check in pages.items()}


# ---- the pages of the project


def write_by_commands(folder: Path) -> None:
    """The pages that the commands write."""
    for name, chosen in {
        "paper": ("--section", "4.2"),
        "primer": ("--paper", "primer_on_bezier_curves", "--claim", "PB4"),
    }.items():
        pages = [f"{option}={folder / name}_{option.strip('-')}.html" for option in ("--html", "--report")]
        assert run("prove", *chosen, "--curve", "cubic_s", *pages, "--quiet").returncode == 0
    made = {
        "triangle": run("teach", "triangle", "cubic_s", "--at", "1/3", "--html", "--quiet").stdout,
        "exercises": run("teach", "exercise", "all", "--html", "--solutions", "--quiet").stdout,
    }
    for name, text in made.items():
        (folder / f"{name}.html").write_text(text, encoding="utf-8")


#: Pages whose fragment is what they show (a curve), not an anchor.
STATEFUL = ("play/curve.html",)
#: Where pages that compute show their first answer, which comes with them; what the library answers in them is looked
#: at in the tests that ask it.
ANSWERS = {
    "curve": "#features td",
    "reduce": "#found .card",
    "bisector": "#pieces td",
    "pair": "#points td",
    "de-boor": "#triangle td",
    "surface": "canvas",
}


def ready(tab: Any, page: str) -> None:
    """Wait for the first answer of a page that computes, and open what is folded."""
    name = Path(page).stem
    if page.startswith("play/"):
        tab.wait_for_selector("main")
        if name in ANSWERS:
            tab.wait_for_selector(ANSWERS[name])
        if name == "claims":
            tab.wait_for_selector("details")
            tab.evaluate("document.querySelectorAll('details').forEach((each) => { each.open = true; })")
            tab.wait_for_function("document.querySelectorAll('details:not(:has(.opened))').length === 0")
    if page == "index.html":
        tab.frame_locator("iframe").locator(ANSWERS["curve"]).first.wait_for()


@pytest.fixture(scope="module")
def seen(tmp_path_factory) -> Seen:
    """The site and what the commands write, looked at once for all tests."""
    if not (SITE / "index.html").exists():
        pytest.skip("the site is not built: ./run site")
    pytest.importorskip("playwright.sync_api")
    commands = tmp_path_factory.mktemp("written")
    write_by_commands(commands)
    found = looked_at(SITE, ready)
    for check, told in looked_at(commands).wrong.items():
        # the ledgers of commands have up to nine columns, which break words where the window is narrow
        if check != "brokenWords":
            found.wrong[check].update(told)
    return found


def looked_at(folder: Path, prepare: Ready | None = None) -> Seen:
    """All pages of a folder; those of other projects in it are theirs."""
    pages = sorted(file.relative_to(folder).as_posix() for file in folder.rglob("*.html") if "vendor" not in file.parts)
    with served(folder) as address:
        found = look_side_by_side(address, pages, prepare)
        found.wrong["links"] = broken_links(found, address, folder, STATEFUL)
    return found


@in_a_browser
@pytest.mark.parametrize("check", CHECKS)
def test_nothing_is_wrong_with_any_page(seen, check):
    assert seen.wrong[check] == {}


@in_a_browser
def test_every_formula_of_the_ledger_is_valid_tex(browser):
    """The page of the ledger shows some of its formulas at a time: here are all."""
    if not (SITE / "index.html").exists():
        pytest.skip("the site is not built: ./run site")
    with served(SITE) as address:
        tab = browser.new_page()
        tab.goto(f"{address}/play/claims.html")
        assert tab.evaluate(INVALID, [{"latex": r"P_2_{[0]}", "sides": [], "quoted": []}]) == [r"P_2_{[0]}"]
        assert tab.evaluate(f"fetch('data/claims.json').then((got) => got.json()).then({INVALID})") == []
        tab.close()


#: In a page with KaTeX: the formulas of claims that it refuses.
INVALID = """(claims) => claims
  .flatMap((c) => [c.latex, ...c.sides.map((s) => s.latex), ...c.quoted.filter((p) => p[0]).map((p) => p[1])])
  .filter((latex) => { try { katex.renderToString(latex); return false; } catch { return true; } })"""


# ---- pictures


def test_what_cannot_be_read_in_a_picture_is_noticed():
    good = new_figure(9.2, 4)
    for place in (1, 2):
        good.add_subplot(1, 2, place).set_title("a title")
    assert unreadable(laid_out(good)) == []
    bad = {"cut": (9.2, "a long title " * 9), "over each other": (9.2, "a long title " * 5), "px high": (18, "a title")}
    for what, (width, title) in bad.items():
        assert any(what in line for line in unreadable(laid_out(titled(width, title))))


def titled(width: float, title: str) -> Any:
    """Three small graphs side by side with one title each."""
    figure = new_figure(width, 4)
    for place in (1, 2, 3):
        figure.add_subplot(1, 3, place).set_title(title)
    return figure
