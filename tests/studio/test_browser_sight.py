"""What is to be seen is in sight: a person in every state, a pattern that keeps its place."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest
from scipy import ndimage

from samples import thorough
from studio_pages import drawn, drop_file, fold, opened, settle
from viewer_pages import await_frames, pixels, wait_until

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from playwright.sync_api import Browser, Page

STORE = "window.__orishell.store"
SHELTER = Path(__file__).parents[2] / "examples" / "shelter.toml"
HEADROOM = "document.querySelector('[data-figure=headroom]')?.textContent"
MEASURED = f"!/not yet/.test({HEADROOM} ?? 'not yet')"
"""The room inside is measured, and so the person placed."""


RED = """(ink) => {
    const { style } = document.documentElement;
    for (const name of ["--person", "--person-behind"]) style.setProperty(name, ink);
    document.dispatchEvent(new Event("themechange"));
}"""


def rest(page: Page) -> None:
    """Wait until the camera stands and the picture is as fine as can be."""
    await_frames(page)
    wait_until(page, "window.__orishell.shell3d.uniforms.shadowTaps.value === 12")
    await_frames(page)


def the_person(page: Page) -> tuple[NDArray[np.bool_], float]:
    """Where the picture is another with a red person, and how far that is from what is around."""
    rest(page)
    there = pixels(page, ".scene")
    page.evaluate(RED, "#f00")
    rest(page)
    seen = np.abs(there - pixels(page, ".scene")).max(axis=-1) > 0.1
    page.evaluate(RED, "")
    around = ndimage.binary_dilation(seen, iterations=4) & ~seen
    return seen, float(np.abs(there[seen].mean(axis=0) - there[around].mean(axis=0)).max())


def test_a_person_is_seen_in_every_state(browser: Browser, address: str) -> None:
    phone = {"width": 390, "height": 844, "has_touch": True, "is_mobile": True}
    with opened(browser, address, **phone, color_scheme="dark") as page:
        drop_file(page, "shelter.toml", SHELTER.read_text())
        wait_until(page, f"{STORE}.name.value === 'shelter'")
        drawn(page)
        wait_until(page, MEASURED)
        page.get_by_test_id("sizes").tap()  # their boxes come and go as they are known
        for share in (None, 0.05, 0.8):
            if share is not None:
                fold(page, share)
            seen, contrast = the_person(page)
            rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
            # Whole, not behind buttons and not beyond the rim: 2.8 times as tall as wide.
            assert 2.2 < np.ptp(rows) / np.ptp(columns) < 3.4
            assert 0 < columns[0] < columns[-1] < seen.shape[1] - 1
            assert 0 < rows[0] < rows[-1] < seen.shape[0] - 1
            assert np.ptp(rows) > 40
            assert contrast > 0.15


@thorough
def test_the_pattern_keeps_its_place(browser: Browser, address: str) -> None:
    with opened(browser, address) as page:
        sheet = page.get_by_test_id("pattern")
        before = sheet.bounding_box()
        # Nothing of the sheet lies under its scale.
        bar = page.locator(".sheet .orishell-bar")
        bar.evaluate("(each) => { each.style.color = each.style.borderColor = 'transparent'; }")
        assert np.ptp(pixels(page, ".sheet .orishell-bar"), axis=(0, 1)).max() < 0.02
        # Where creases are dense, mountains and valleys are still told apart.
        page.evaluate(f"{STORE}.set({{ 'pattern.rows': 29, 'pattern.columns': 30 }}, 'dense')")
        drawn(page)
        red, _, blue = np.moveaxis(pixels(page, ".sheet canvas"), -1, 0)
        ink = np.abs(red - blue) > 0.1
        assert np.mean(red[ink] > blue[ink]) == pytest.approx(0.5, abs=0.4)
        assert sheet.bounding_box() == before
        # What is said below it, long or short, leaves it where it is.
        page.evaluate(f"{STORE}.set({{ 'pattern.rows': 5, 'pattern.xi_deg': 120 }}, 'refused')")
        settle(page)
        assert sheet.bounding_box() == before
        # The tour leaves all as it was.
        inputs = page.locator(".inputs")
        inputs.evaluate("(room) => { room.scrollTop = 600; }")
        page.keyboard.press("?")
        for _ in range(5):
            page.keyboard.press("ArrowLeft")
        await_frames(page)
        scrolled = "document.querySelector('.inputs').scrollTop"
        assert page.evaluate(scrolled) < 500
        page.keyboard.press("Escape")
        wait_until(page, f"Math.abs({scrolled} - 600) < 20", 20)
