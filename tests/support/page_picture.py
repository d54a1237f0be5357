"""The picture of a page in the README: ``python -m tests.support.page_picture``, where the site is built.

The file says in itself what words the page had, so that a test notices when it has others.
"""

from __future__ import annotations

from io import BytesIO
from pathlib import Path
from typing import Any

from tests.support.looking import HEIGHT, PATIENCE, WIDE, served, started

ROOT = Path(__file__).parents[2]
PICTURE = ROOT / "docs" / "pictures" / "page.png"
PAGE = "play/curve.html"


def words(tab: Any) -> str:
    """The words of the page, without how far the library has started and how long an answer took."""
    tab.wait_for_selector("#features td")
    tab.wait_for_selector("#forms svg")
    said: str = tab.evaluate("document.getElementById('status').textContent = '', document.body.innerText")
    return said


def take() -> None:
    """Open the page, wait for the answers of the library and keep what is seen."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo
    from playwright.sync_api import sync_playwright

    with served(ROOT / "build" / "site" / "html") as address, sync_playwright() as player, started(player) as browser:
        tab = browser.new_page(viewport={"width": WIDE, "height": HEIGHT})
        tab.goto(f"{address}/{PAGE}")
        # the second answer, which does not wait for the library to start
        for _ in range(2):
            tab.wait_for_function("document.body.dataset.degrees", timeout=PATIENCE)
            tab.evaluate("delete document.body.dataset.degrees")
            tab.select_option("#examples", "0")
        tab.wait_for_function("document.body.dataset.degrees", timeout=PATIENCE)
        said = PngInfo()
        # how long the answer took depends on what else the machine does: it goes before the picture is taken
        said.add_itxt("Description", words(tab))
        seen = Image.open(BytesIO(tab.screenshot()))
        seen.save(PICTURE, optimize=True, pnginfo=said)


if __name__ == "__main__":
    take()
