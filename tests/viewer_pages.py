"""The viewer in a real browser, for the tests that ask it: Debian's chromium, driven by playwright.

The shell without windows takes half the time of the whole browser, which has pages of its own.

Without the built viewer or the browser a test is skipped, or fails if the environment has
``ORISHELL_REQUIRE_NODE=1``, as in ``.ci/run``, so that nothing is skipped there unnoticed.
"""

from __future__ import annotations

import io
import shutil
from collections.abc import Iterator
from contextlib import closing, contextmanager
from itertools import combinations
from typing import TYPE_CHECKING, Any

import matplotlib.image
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from node_tools import lacking
from orishell.io.formats.html import viewer_is_built
from orishell.io.html_pages import place_of
from screenshots import PICTURES, ROOT, WRITES

if TYPE_CHECKING:
    from playwright.sync_api import Browser, ConsoleMessage, Frame, Locator, Page

BUILT = ROOT / "build" / "pictures"
LARGEST = 400_000
"""Bytes of a picture."""
WEBGL = (
    *("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    "--disable-gpu-compositing",  # without a card, pages are put together in a third less time
)
"""WebGL without a graphics card."""
ROUGHLY = ("--webgl-antialiasing-mode=none",)
"""Smooth edges take a quarter of the time of a frame; only pictures for the guide need them."""


def require_viewer() -> None:
    """The test ends here if the viewer and the page of a search have not been built."""
    if not (viewer_is_built() and place_of("front.js").is_file()):
        lacking("the pages have not been built: make pages")


@contextmanager
def running_browser() -> Iterator[Browser]:
    """A headless browser."""
    require_viewer()
    chromium = shutil.which("chromium-headless-shell") or shutil.which("chromium")
    if chromium is None:
        lacking("no browser is installed: on Debian, apt-get install chromium-headless-shell")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        lacking("playwright is not installed")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium, args=[*WEBGL, *(() if WRITES else ROUGHLY)]
        )
        yield browser
        browser.close()


@contextmanager
def watched_page(browser: Browser, **options: Any) -> Iterator[Page]:
    """A page; at the end it must have printed nothing and asked for nothing but its own address."""
    asked: list[str] = []
    size: Any = {"width": 1280, "height": 720}
    with closing(browser.new_page(viewport=size, **options)) as page:
        said = listen(page)
        page.on("request", lambda request: asked.append(request.url))
        yield page
        own = page.url
    assert said == []
    assert [url for url in asked if url != own and not url.startswith("http://viewer.test/")] == []


def listen(page: Page, *kinds: str) -> list[str]:
    """Errors in a page and what it prints (of some kinds, if they are named), as they come.

    What the browser says of drawing without a card is not the page's.
    """
    said: list[str] = []

    def hear(message: ConsoleMessage) -> None:
        if (not kinds or message.type in kinds) and "GL Driver Message" not in message.text:
            said.append(f"{message.type}: {message.text}")

    page.on("console", hear)
    page.on("pageerror", lambda error: said.append(str(error)))
    return said


def require_apart(page: Page, elements: list[Locator], width: int) -> None:
    """Elements lie within the page and on no other of them."""
    await_frames(page)
    boxes = [box for each in elements if (box := each.bounding_box())]
    spans = [
        ((box["x"], box["x"] + box["width"]), (box["y"], box["y"] + box["height"])) for box in boxes
    ]
    assert all(0 <= left <= right <= width for (left, right), _ in spans)
    for one, other in combinations(spans, 2):
        assert any(
            first[1] <= second[0] + 0.5 or second[1] <= first[0] + 0.5
            for first, second in zip(one, other, strict=True)
        )


def wait_until(page: Page | Frame, expression: str, seconds: float = 60.0) -> None:
    """Wait for a condition; the page's own policy forbids playwright to wait inside it."""
    for _ in range(int(20 * seconds)):
        if page.evaluate(expression):
            return
        page.wait_for_timeout(50)
    raise AssertionError(expression)


def pixels(page: Page, selector: str) -> NDArray[np.float64]:
    """What an element looks like: (height, width, 3), 0 to 1."""
    picture = matplotlib.image.imread(io.BytesIO(page.locator(selector).first.screenshot()))
    return np.asarray(picture[..., :3], dtype=np.float64)


def await_frames(page: Page | Frame) -> None:
    """Wait until what has been asked for so far is drawn, however slow the machine is."""
    page.evaluate(
        "new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame("
        "() => setTimeout(drawn, 0))))"
    )


def keep_picture(page: Page, name: str) -> None:
    """Keep what a page looks like in ``build/pictures``.

    ``make screenshots`` writes it into the documentation, in 256 colours if it is large otherwise.
    """
    await_frames(page)
    place = PICTURES if WRITES else BUILT
    place.mkdir(parents=True, exist_ok=True)
    with Image.open(io.BytesIO(page.screenshot())) as picture:
        whole = picture.convert("RGB")
    whole.save(place / f"{name}.png", optimize=True)
    if (place / f"{name}.png").stat().st_size > LARGEST:
        # This way of choosing colours keeps those of thin lines; shading is mixed of them.
        few = whole.quantize(256, Image.Quantize.MAXCOVERAGE)
        mixed = whole.quantize(palette=few, dither=Image.Dither.FLOYDSTEINBERG)
        mixed.save(place / f"{name}.png", optimize=True)
