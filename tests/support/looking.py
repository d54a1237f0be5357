"""Pages as a careful reader sees them: in a browser, wide and narrow, by day and by night (see looking.js)."""

from __future__ import annotations

import shutil
from collections import defaultdict, deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any
from urllib.parse import unquote, urldefrag, urlsplit

CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
SCRIPT = (Path(__file__).parent / "looking.js").read_text(encoding="utf-8")
WIDE, NARROW, HEIGHT = 1280, 390, 900
#: The checks that depend on the width of the window, and those that depend on the colours of the day.
BY_WIDTH = ("tooWide", "brokenWords", "horizontalScroll", "smallText")
BY_COLOUR = ("poorContrast", "strangeGrounds")
ONCE = ("formulaErrors", "texAsText", "machineReprs", "withoutAlternative")
CHECKS = (*ONCE, *BY_WIDTH, *BY_COLOUR, "links")
PATIENCE = 120_000
#: In a page: the library does not start; its questions wait in `asked`, to be answered by hand.
HELD = """
window.asked = [];
window.Worker = class {
  constructor() { window.worker = this; }
  postMessage(message) { window.asked.push(message); }
};
"""
#: What waits for a page (a tab, and the path of the page) and opens what is folded.
Ready = Callable[[Any, str], None]


class Quiet(SimpleHTTPRequestHandler):
    """A server that does not print every request."""

    def log_message(self, *_: object) -> None:
        """Nothing."""


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """The address of a local server of a folder."""
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder))) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@contextmanager
def started(player: Any) -> Iterator[Any]:
    """A browser, in which pages of one context share a process, and so what is compiled of the library."""
    options = ["--no-sandbox", "--disable-background-networking", "--process-per-site"]
    browser = player.chromium.launch(executable_path=CHROMIUM, args=options)
    yield browser
    browser.close()


@dataclass
class Seen:
    """What was noticed on each page, by check; where the pages lead; the anchors that they have."""

    wrong: dict[str, dict[str, list[str]]] = field(default_factory=lambda: defaultdict(dict))
    links: dict[str, list[str]] = field(default_factory=dict)
    anchors: dict[str, set[str]] = field(default_factory=dict)

    def note(self, check: str, page: str, lines: Iterable[str], when: str = "") -> None:
        """Keep what a check says, each line once."""
        told = self.wrong[check].setdefault(page, [])
        told += [line for each in lines if (line := f"{when}{each}") not in told]
        if not told:
            del self.wrong[check][page]

    def add(self, other: Seen) -> None:
        """Take over what was noticed on other pages."""
        for check, told in other.wrong.items():
            self.wrong[check].update(told)
        self.links.update(other.links)
        self.anchors.update(other.anchors)


def look(browser: Any, address: str, pages: Iterable[str], ready: Ready | None = None) -> Seen:
    """Visit each page once, wide and narrow, by day and by night; `ready` waits for what a page itself computes, and
    opens what is folded. While one page is looked at the next one loads in another tab.
    """
    seen = Seen()
    # each laid out in a process of its own
    idle, loading = [_context(browser).new_page() for _ in range(2)], deque[tuple[str, Any]]()
    for page in pages:
        loading.append((page, _opened(idle.pop(), address, page)))
        if len(loading) > 1:
            idle.append(looked_at(*loading.popleft(), seen, ready))
    for page, tab in loading:
        looked_at(page, tab, seen, ready)
    for context in browser.contexts:
        context.close()
    return seen


def look_side_by_side(address: str, pages: list[str], ready: Ready | None = None) -> Seen:
    """The same in two browsers, each with every second page."""
    from playwright.sync_api import sync_playwright

    def share(own: list[str]) -> Seen:
        with sync_playwright() as player, started(player) as browser:
            return look(browser, address, own, ready)

    found = Seen()
    with ThreadPoolExecutor() as pool:
        for seen in pool.map(share, (pages[::2], pages[1::2])):
            found.add(seen)
    return found


def _context(browser: Any) -> Any:
    size = {"width": WIDE, "height": HEIGHT}
    context = browser.new_context(reduced_motion="reduce", viewport=size, color_scheme="light")
    context.set_default_timeout(PATIENCE)
    # pages show their first answers without it
    context.add_init_script(HELD)
    return context


def _opened(tab: Any, address: str, page: str) -> Any:
    """The tab, in which a page begins to load."""
    tab.goto(f"{address}/{page}", wait_until="commit")
    return tab


def looked_at(page: str, tab: Any, seen: Seen, ready: Ready | None = None) -> Any:
    """Note what is seen on the page of a tab, and leave the tab to another. A tab keeps the width and the colours in
    which the last page was seen, and begins with these: to lay a page out again takes longest.
    """
    tab.wait_for_load_state("load")
    if ready:
        ready(tab, page)
    tab.evaluate(SCRIPT)
    tab.evaluate("looking.settled()")
    for check, lines in _asked(tab, ONCE).items():
        seen.note(check, page, lines)
    _note_by_width(tab, page, seen)
    _note_by_colour(tab, page, seen)
    tab.emulate_media(color_scheme="light" if _is_dark(tab) else "dark")
    _note_by_colour(tab, page, seen)
    tab.set_viewport_size({"width": NARROW if tab.viewport_size["width"] != NARROW else WIDE, "height": HEIGHT})
    tab.evaluate("looking.settled()")
    _note_by_width(tab, page, seen)
    seen.links[page], anchors = tab.evaluate("[looking.links(), looking.anchors()]")
    seen.anchors[page] = set(anchors)
    return tab


def _is_dark(tab: Any) -> bool:
    return bool(tab.evaluate("matchMedia('(prefers-color-scheme: dark)').matches"))


def _note_by_width(tab: Any, page: str, seen: Seen) -> None:
    for check, lines in _asked(tab, BY_WIDTH).items():
        seen.note(check, page, lines, f"at {tab.viewport_size['width']}: ")


def _note_by_colour(tab: Any, page: str, seen: Seen) -> None:
    scheme = "dark" if _is_dark(tab) else "light"
    for check, lines in _asked(tab, BY_COLOUR).items():
        seen.note(check, page, lines, f"{scheme}: ")


def _asked(tab: Any, checks: Iterable[str]) -> dict[str, list[str]]:
    return dict(tab.evaluate("names => names.map(name => [name, looking.checks[name]()])", list(checks)))


def broken_links(seen: Seen, address: str, folder: Path, state: Iterable[str] = ()) -> dict[str, list[str]]:
    """By page, the links into the folder that lead to no file or to no anchor; fragments of the pages in `state` are
    data (a curve that is restored), not anchors.
    """
    state = set(state)
    broken: dict[str, list[str]] = {}
    for page, targets in seen.links.items():
        for target in dict.fromkeys(targets):
            whole, fragment = urldefrag(target)
            if not whole.startswith(address):
                continue
            path = unquote(urlsplit(whole).path).lstrip("/") or "index.html"
            if not (folder / path).exists():
                broken.setdefault(page, []).append(f"no file: {path}")
            elif fragment and path not in state and unquote(fragment) not in seen.anchors.get(path, {fragment}):
                broken.setdefault(page, []).append(f"no anchor: {path}#{fragment}")
    return broken


#: The column of the written pages, in pixels, and the least height of letters there.
COLUMN, LEAST_TEXT = 736, 9


def laid_out(figure: Any) -> Any:
    """The figure, laid out as it is for a page."""
    from exactspline.display.plot.canvas import settle

    settle(figure)
    figure.draw_without_rendering()
    return figure


def unreadable(figure: Any) -> list[str]:
    """What cannot be read in a figure that was drawn, shown in the column of a page: words that are cut at its edge or
    too small, titles that run into each other.
    """
    width, height = figure.get_window_extent().size
    scale = min(80 / 72, COLUMN / 72 / figure.get_figwidth())
    found, titles = [], []
    texts = [ax.title for ax in figure.axes] + [
        text for ax in figure.axes if ax.get_legend() for text in ax.get_legend().get_texts()
    ]
    for text in (each for each in texts if each.get_visible() and each.get_text()):
        box, said = text.get_window_extent(), text.get_text()
        if box.x0 < -1 or box.y0 < -1 or box.x1 > width + 1 or box.y1 > height + 1:
            found.append(f"cut: {said}")
        if text.get_fontsize() * scale < LEAST_TEXT:
            found.append(f"{text.get_fontsize() * scale:.1f} px high: {said}")
        if text in [ax.title for ax in figure.axes]:
            found += [f"over each other: {other}; {said}" for other, taken in titles if box.overlaps(taken)]
            titles.append((said, box))
    return found
