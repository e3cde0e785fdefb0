"""The camera follows the fold in a real browser: what is drawn fills the view until it is moved."""

from __future__ import annotations

import random
from contextlib import ExitStack, closing
from itertools import cycle
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import pytest

from node_tools import lacking
from orishell.design_file import starter_file
from orishell.studio.app import PAGES
from patterns import miura, svg_of
from samples import THOROUGH, thorough
from studio_pages import choose, drawn, drop_file, fold, in_bar, settle
from studio_server import running_studio
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

REACH = """(() => {
    const { shell3d } = window.__orishell, box = shell3d.canvas.getBoundingClientRect();
    const { motion, camera } = shell3d, at = camera.position.clone();
    let reach = 0;
    for (let corner = 0; corner < 4 * motion.panels; corner++) {
        const [x, y] = shell3d.onScreen(motion.at(corner, at));
        reach = Math.max(reach, Math.abs((2 * (x - box.left)) / box.width - 1),
                         Math.abs((2 * (y - box.top)) / box.height - 1));
    }
    return reach;
})()"""
"""How far the shell reaches in the picture, from its middle (0) to its rim (1)."""
CAMERA = "window.__orishell.shell3d.camera.position.toArray()"
# placeCamera leaves a tenth of the half picture around what it fits.
FULL = pytest.approx(1 / 1.1, abs=0.03)


@thorough
def test_the_camera_follows_the_fold_until_it_is_moved(page: Page) -> None:
    choose(page, "parallel-repeating")
    page.get_by_test_id("person").uncheck()
    page.evaluate("window.__orishell.store.set({ 'deployment.from': 'pack' }, 'pack')")
    settle(page)
    canvas = page.locator(".scene canvas")
    reaches = {}
    for share in (0, 0.3, 0.7, 1):
        fold(page, share)
        reaches[share] = page.evaluate(REACH)
    assert reaches == dict.fromkeys(reaches, FULL)
    # One turns it: it still follows, from there.
    canvas.focus()
    page.keyboard.press("ArrowLeft")
    fold(page, 0)
    assert page.evaluate(REACH) == FULL
    # One comes nearer: it stays.
    page.keyboard.press("+")
    await_frames(page)
    near = page.evaluate(CAMERA)
    fold(page, 1)
    assert page.evaluate(CAMERA) == pytest.approx(near, rel=1e-9)
    page.keyboard.press("f")
    await_frames(page)
    assert page.evaluate(REACH) == FULL
    fold(page, 0.5)
    assert page.evaluate(REACH) == FULL


IN_PICTURE = """(() => {
    const { canvas, motion, camera } = window.__orishell.shell3d;
    const at = camera.position.clone(), { width, height } = canvas.getBoundingClientRect();
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let corner = 0; corner < 4 * motion.panels; corner++) {
        motion.at(corner, at);
        at.project(camera).toArray().forEach((value, axis) => {
            low[axis] = Math.min(low[axis], value);
            high[axis] = Math.max(high[axis], value);
        });
    }
    return { low, high, stretched: (camera.aspect * height) / width };
})()"""
"""The box of the shell in the picture, whose sides are at -1 and 1, as near and far are."""
STORE = "window.__orishell.store"
WINDOWS = [(1600, 560), (1440, 900), (390, 844), (820, 1180), (1024, 700)]
EXAMPLES = ["parallel-repeating", "orthodiagonal", "pattern", "shelter"]


class Visit:
    """A page of a studio of its own, which can be ended and started again."""

    def __init__(self, browser: Browser, studio: ExitStack, chance: random.Random) -> None:
        self.context = browser.new_context(viewport={"width": 1440, "height": 900})
        self.page = self.context.new_page()
        self.studio = studio
        self.chance = chance
        self.windows = cycle(WINDOWS)
        self.first = studio.enter_context(running_studio())
        self.page.goto(self.first.entrance)
        wait_until(self.page, "window.__orishell !== undefined")

    def close(self) -> None:
        self.context.close()

    def resize(self) -> None:
        width, height = next(self.windows)
        self.page.set_viewport_size({"width": width, "height": height})

    def undo(self) -> None:
        self.page.evaluate(f"{STORE}.undo()")

    def refuse(self) -> None:
        """No sheet has no rows: a banner comes, and goes with the value."""
        self.page.evaluate(f"{STORE}.set({{ 'pattern.rows': 0 }}, 'rows')")
        wait_until(self.page, f"{STORE}.fault.value !== null")
        self.require_seen()
        self.undo()

    def drop(self) -> None:
        """A pattern in pixels, or a shell of some millimetres."""
        if self.chance.random() < 0.5:
            drop_file(self.page, "own.svg", svg_of(miura()))
            name = "own"
        else:
            text = starter_file("orthodiagonal").replace('unit = "m"', 'unit = "mm"')
            drop_file(self.page, "small.toml", text)
            name = "small"
        wait_until(self.page, f"{STORE}.name.value === '{name}'")

    def example(self) -> None:
        in_bar(self.page, "examples").click()
        self.page.get_by_test_id(f"example-{self.chance.choice(EXAMPLES)}").click()

    def restart(self) -> None:
        self.studio.close()
        # What is asked of no server has no answer, and is taken back meanwhile.
        self.page.evaluate(f"{STORE}.set({{ 'pattern.rows': 0 }}, 'rows')")
        wait_until(self.page, f"{STORE}.fault.value?.kind === 'network'")
        self.undo()
        self.require_seen()
        port = urlsplit(self.first.address).port
        again = self.studio.enter_context(running_studio(port=port))
        # It has another key, which the browser is given in another tab.
        with closing(self.context.new_page()) as other:
            other.goto(again.entrance)
        wait_until(self.page, f"{STORE}.fault.value === null")

    def require_seen(self) -> None:
        await_frames(self.page)
        seen: dict[str, Any] = self.page.evaluate(IN_PICTURE)
        assert all(
            -1 <= low < high <= 1 for low, high in zip(seen["low"], seen["high"], strict=True)
        ), seen
        assert max(seen["high"][axis] - seen["low"][axis] for axis in (0, 1)) > 0.6, seen
        assert seen["stretched"] == pytest.approx(1, abs=0.01)


def test_the_shell_is_in_the_picture_whatever_is_done(browser: Browser) -> None:
    if not (PAGES / "index.html").is_file():
        lacking("the studio's pages have not been built: make pages")
    chance = random.Random(54)
    kinds = ["resize", "example", "resize", "drop", "refuse", "restart", "undo"]
    more = chance.choices(
        ["drop", "example", "resize", "resize", "refuse", "undo", "restart"], k=43
    )
    with ExitStack() as studio, closing(Visit(browser, studio, chance)) as visit:
        for done in [*kinds, *(more if THOROUGH else [])]:
            getattr(visit, done)()
            drawn(visit.page)
            visit.require_seen()
