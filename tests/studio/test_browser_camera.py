"""The camera follows the fold in a real browser: what is drawn fills the view until it is moved."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from samples import thorough
from studio_pages import choose, fold, settle
from viewer_pages import await_frames

if TYPE_CHECKING:
    from playwright.sync_api import Page

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
