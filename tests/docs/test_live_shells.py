"""Shells of the site's pages fold where they stand, from disk and from a server."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from contextlib import closing, contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib import import_module
from pathlib import Path
from threading import Thread
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from PIL import Image

from orishell.io.formats.html import read_viewer
from posters import NOTED, POSTERS, SIZE, designs, digest
from viewer_pages import await_frames, listen, pixels, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Frame, Page

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
CHANGED = 0.02
"""Mean difference of two pictures of a stage, from 0 to 1, that shows different shells."""
OVERFLOW = "document.documentElement.scrollWidth - document.documentElement.clientWidth"

pytestmark = pytest.mark.slow


def live_names(page: Path) -> list[str]:
    """Names of the shells that a page shows."""
    return re.findall(r'class="live-poster" href="[^"]*?live/(\w+)\.html"', page.read_text("utf-8"))


def test_every_example_of_the_gallery_folds(site: Path) -> None:
    pages = sorted((site / "gallery").glob("plot_*.html"))
    assert len(pages) == len(list((EXAMPLES / "gallery").glob("plot_*.py")))
    names = [live_names(page) for page in pages]
    assert all(names)
    assert {name for each in names for name in each} == {p.stem for p in EXAMPLES.glob("*.toml")}


def test_pages_share_one_program(site: Path) -> None:
    live = site / "live"
    program = (live / "viewer.js").stat().st_size
    assert len(read_viewer().encode()) - 100 < program < len(read_viewer().encode()) + 5000
    for page in live.glob("*.html"):
        text = page.read_text("utf-8")
        head, rest = re.split(r'id="orishell-(?:view|variants)">', text)
        view, _, tail = rest.partition("</script>")
        assert len(head) + len(tail) < 2000, page
        assert len(view) > 10_000, page
        assert 'src="viewer.js"' in tail


def extension(monkeypatch: pytest.MonkeyPatch) -> tuple[Any, Any]:
    """The part of the build that is tested, and its errors."""
    errors = pytest.importorskip("sphinx.errors")
    monkeypatch.syspath_prepend(str(ROOT / "docs" / "_ext"))
    return import_module("live_shells"), errors


def test_a_site_without_the_viewer_says_what_to_build(monkeypatch: pytest.MonkeyPatch) -> None:
    live_shells, errors = extension(monkeypatch)
    html = SimpleNamespace(builder=SimpleNamespace(format="html"))
    monkeypatch.setattr(live_shells, "viewer_is_built", lambda: True)
    live_shells.require_viewer(html)
    monkeypatch.setattr(live_shells, "viewer_is_built", lambda: False)
    with pytest.raises(errors.ExtensionError, match="has not been built: make pages"):
        live_shells.require_viewer(html)
    live_shells.require_viewer(SimpleNamespace(builder=SimpleNamespace(format="")))  # of another


def test_the_program_of_all_pages_is_the_viewer_without_exports(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    live_shells, errors = extension(monkeypatch)
    program = live_shells.shared_program("const a={};export{a as default};\n")
    assert "const a={};" in program
    assert "export" not in program
    with pytest.raises(errors.ExtensionError, match="no module that ends with its exports"):
        live_shells.shared_program("const a = 1;")


def test_pictures_are_of_the_designs_as_they_are() -> None:
    """`python tests/posters.py NAME` takes one anew."""
    noted = json.loads(NOTED.read_text("utf-8"))
    assert noted == {name: digest(path) for name, path in designs().items()}
    for name in noted:
        for colours in ("light", "dark"):
            with Image.open(POSTERS / f"{name}-{colours}.webp") as picture:
                assert picture.size == (SIZE["width"], SIZE["height"])
    assert sum(path.stat().st_size for path in POSTERS.iterdir()) < 1_300_000


def test_code_of_an_example_is_folded_away(site: Path) -> None:
    text = (site / "gallery" / "plot_canopy.html").read_text("utf-8")
    blocks = text.count('class="highlight-Python ')
    assert blocks == text.count('<details class="folded-code">') == text.count("</details>") > 2
    assert "sphx-glr-thumbcontainer" not in (site / "gallery" / "index.html").read_text("utf-8")


def test_the_site_has_the_colours_of_the_studio(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "docs" / "_ext"))
    light, dark = import_module("looks").variables()
    assert light["color-brand-primary"] == light["accent"] != dark["accent"]
    assert dark["color-brand-primary"] == dark["accent"]
    assert set(light) == set(dark)


class Quiet(SimpleHTTPRequestHandler):
    """Serves files and says nothing of it."""

    def log_message(self, *_: object) -> None:
        """Say nothing."""


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """The address of a folder that is served."""
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder))) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


@contextmanager
def opened(browser: Browser, base: str, path: str, **options: Any) -> Iterator[Page]:
    """A page of the site; at the end it must have printed nothing and asked for nothing else."""
    asked: list[str] = []
    with closing(browser.new_page(**options)) as page:
        said = listen(page)
        page.on("request", lambda request: asked.append(request.url))
        page.goto(base + path)
        yield page
    assert said == []
    assert [url for url in asked if not url.startswith(base)] == []


def shell_of(page: Page) -> Frame:
    """The viewer on a page, once it is there."""
    wait_until(page, "document.querySelector('.live-on') !== null")
    wait_until(page.frames[1], "window.orishell !== undefined")
    return page.frames[1]


def assert_folds(page: Page, frame: Frame) -> None:
    """The picture changes with the slider, which keys move."""
    await_frames(frame)
    before = pixels(page, ".live-stage")
    slider = frame.locator(".player input[type=range]")
    slider.focus()
    page.keyboard.press("Home")
    assert frame.evaluate("orishell.shell.fold") == 0
    await_frames(frame)
    assert np.abs(pixels(page, ".live-stage") - before).mean() > CHANGED


def swipe(page: Page, right: float, down: float) -> None:
    """Move a finger from the middle of the shell."""
    box = page.locator(".live-stage").bounding_box()
    assert box is not None
    x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.6 * box["height"]
    session = page.context.new_cdp_session(page)
    for step in range(21):
        finger = {"x": x + right * step / 20, "y": y + down * step / 20}
        kind = "touchMove" if step else "touchStart"
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [finger]})
        page.wait_for_timeout(16)
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    page.wait_for_timeout(300)


def test_an_example_is_opened_by_a_key_and_folds_from_disk(browser: Browser, site: Path) -> None:
    base = site.as_uri() + "/"
    size = {"width": 1280, "height": 720}
    with opened(browser, base, "gallery/plot_canopy.html", viewport=size) as page:
        assert len(page.frames) == 1  # a picture, until the viewer is asked for
        poster = page.locator(".live-poster img:visible")
        assert poster.evaluate("image => image.naturalWidth") == 720
        page.locator(".live-poster").focus()
        page.keyboard.press("Enter")
        frame = shell_of(page)
        assert page.evaluate("document.activeElement.tagName") == "IFRAME"
        assert_folds(page, frame)
        for theme in ("dark", "light"):
            page.evaluate("theme => { document.body.dataset.theme = theme; }", theme)
            wait_until(frame, f"document.documentElement.dataset.theme === '{theme}'")
        page.emulate_media(media="print")
        assert poster.is_visible()
        assert not page.locator(".live iframe").is_visible()


def test_the_front_page_folds_by_itself(browser: Browser, site: Path) -> None:
    phone: dict[str, Any] = {
        "viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True,
        "color_scheme": "dark",
    }  # fmt: skip
    with served(site) as base, opened(browser, base, "index.html", **phone) as page:
        page.locator(".live-stage").scroll_into_view_if_needed()
        frame = shell_of(page)
        assert frame.evaluate("document.documentElement.dataset.theme") == "dark"
        assert page.evaluate(OVERFLOW) == 0
        assert frame.evaluate(OVERFLOW) == 0
        assert_folds(page, frame)
        drawn = "orishell.shell.camera.position.toArray().map((x) => x.toFixed(6)).join()"
        stood = frame.evaluate(drawn)
        swipe(page, 0, -150)
        assert page.evaluate("scrollY") > 100  # up or down: the page's, wherever it begins
        assert frame.evaluate(drawn) == stood
        page.evaluate("scrollTo(0, 0)")
        swipe(page, -150, 0)
        assert page.evaluate("scrollY") == 0
        assert frame.evaluate(drawn) != stood
        frame.locator(".variant input").first.focus()
        page.keyboard.press("End")
        wait_until(frame, "orishell.idle && orishell.chosen !== orishell.page.first")
        assert "1.3" in frame.locator(".variant-value").first.inner_text()
        assert page.locator(".ways li").count() == 3
        assert page.locator("article .toctree-wrapper li").count() == 0


def test_the_wheel_scrolls_a_page_until_its_shell_is_used(browser: Browser, site: Path) -> None:
    base = site.as_uri() + "/"
    with opened(browser, base, "index.html", viewport={"width": 1280, "height": 720}) as page:
        frame = shell_of(page)
        box = page.locator(".live-stage").bounding_box()
        assert box is not None
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 3)
        page.mouse.wheel(0, 60)
        wait_until(page, "scrollY > 0")
        distance = "orishell.shell.camera.position.length()"
        page.mouse.down()
        page.mouse.up()
        before, at = frame.evaluate(distance), page.evaluate("scrollY")
        page.mouse.wheel(0, -60)
        wait_until(frame, f"{distance} !== {before}")
        assert page.evaluate("scrollY") == at
