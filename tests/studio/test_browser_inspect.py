"""Looking closely in the studio: panels, distances, the motion, what stands around, comparing."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from node_tools import PACKAGES, lacking
from samples import led_by, thorough
from studio_pages import FREE, SIZES, TOUCHING, choose, drawn, fold, opened, settle
from viewer_pages import await_frames, keep_picture, pixels, require_apart, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

EXAMPLES = Path(__file__).parents[2] / "examples"
DROP = """([text, name]) => {
    const brought = new DataTransfer();
    brought.items.add(new File([text], name));
    document.dispatchEvent(
        new DragEvent("drop", { dataTransfer: brought, bubbles: true, cancelable: true }));
}"""
# Where the middle of a panel is in the window.
PANEL = """(() => {
    const { shell3d } = window.__orishell, place = () => shell3d.camera.position.clone();
    const corner = (k) => shell3d.motion.at(4 * 53 + k, place());
    return shell3d.onScreen(corner(0).add(corner(2)).multiplyScalar(0.5));
})()"""


# Where the line of the handle of the rows begins and ends in the window.
SPAN = """(() => {
    const { shell3d, store } = window.__orishell, { header } = store.view.value;
    const [rows, columns] = header.grid, place = () => shell3d.camera.position.clone();
    const at = (row) => {
        const vertex = row * columns + Math.floor(columns / 2);
        return shell3d.onScreen(shell3d.motion.at(shell3d.motion.faces.indexOf(vertex), place()));
    };
    const row = Math.floor(rows / 2);
    return [at(row), at(row + Math.ceil(rows / 5))];
})()"""


# Where feet are in the window.
FEET = """(() => {
    const { shell3d, shell3d: { motion, camera }, store } = window.__orishell;
    const { grid, report } = store.view.value.header;
    return report.deployment.ground.feet.map(({ at: [row, column] }) => shell3d.onScreen(
        motion.at(motion.faces.indexOf(row * grid[1] + column), camera.position.clone())));
})()"""


def bring(page: Page, name: str) -> None:
    """Drop an example's file on the page."""
    page.evaluate(DROP, [(EXAMPLES / name).read_text(), name])
    settle(page)


def middle(page: Page, test_id: str) -> tuple[float, float]:
    box = page.get_by_test_id(test_id).locator("canvas").first.bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def folds(page: Page) -> list[tuple[str, str]]:
    """Fold angles of the panel's creases, now and at the target, on its card."""
    now, target = (
        page.get_by_test_id("inspect-card").locator(f"td:nth-of-type({k})").all_inner_texts()
        for k in (2, 3)
    )
    return [pair for pair in zip(now, target, strict=True) if pair[0] != "edge"]


def leave(page: Page) -> None:
    """Take the focus from every control."""
    page.evaluate("document.activeElement.blur()")


def metres(page: Page, test_id: str) -> float:
    return float(page.get_by_test_id(test_id).inner_text().removesuffix(" m"))


CHIPS = """[...document.querySelectorAll('.verdict-chip')]
    .map(({ dataset, innerText }) =>
        [dataset.testid.slice(5), dataset.sign, innerText.replace(/\\s+/g, ' ')])"""
ROWS = """Object.fromEntries(
    [...document.querySelectorAll('[data-testid=verify-status] [data-row]')]
        .map((row) => [row.dataset.row, row.dataset.sign]))"""
PROOF = "(proof) => window.__orishell.store.proof.set(proof)"


def test_chips_on_the_canvas_say_what_the_rows_say_and_where(page: Page) -> None:
    choose(page, "orthodiagonal")
    settle(page)
    chips, rows = page.evaluate(CHIPS), page.evaluate(ROWS)
    assert [name for name, _, _ in chips] == ["folds", "locks"]
    assert all(rows[name] == sign for name, sign, _ in chips)
    chip = page.get_by_test_id("chip-locks")
    row = page.get_by_test_id("verdict-locks")
    fold(page, 0.3)
    chip.click()
    await_frames(page)
    assert page.evaluate("window.__orishell.fold") == 1  # where it locks
    assert chip.get_attribute("aria-pressed") == "true"
    assert row.evaluate("row => row.parentElement.open")
    legend = page.locator(".orishell-legend")
    assert "of the verdict" in legend.inner_text()
    page.keyboard.press("Escape")
    await_frames(page)
    assert "of the verdict" not in legend.inner_text()
    # While the proof runs they say no more than the rows do.
    done = page.evaluate("window.__orishell.store.proof.value")
    page.evaluate(PROOF, {"state": "running", "share": 0.4, "what": "verifying", "found": False})
    chips, rows = page.evaluate(CHIPS), page.evaluate(ROWS)
    assert all(sign == rows[name] == "pending" for name, sign, _ in chips)
    assert chips[0][2].endswith("Folds not yet known")
    page.evaluate(PROOF, {"state": "failed", "fault": {"message": "no", "remedies": []}})
    assert page.evaluate(CHIPS) == [["verdict", "fails", "\u2715 Verdict not verified"]]
    page.evaluate(PROOF, done)


def test_rows_and_depth_are_handles_at_the_shell(page: Page) -> None:
    choose(page, "orthodiagonal")
    settle(page)
    pattern = "window.__orishell.store.design.value.pattern"
    before = page.evaluate(pattern)
    for key in ("rows", "depth"):
        handle = page.get_by_test_id(f"handle-{key}")
        handle.focus()
        page.keyboard.press("ArrowUp")
        drawn(page)
        assert page.evaluate(pattern)[key] > before[key]
        assert float(handle.get_attribute("aria-valuenow") or "") == page.evaluate(pattern)[key]
        page.get_by_test_id("undo").click()
        drawn(page)
        assert page.evaluate(pattern) == before
    # Longer panels are fewer; the whole drag is one step.
    start, end = page.evaluate(SPAN)
    x, y = (end[k] + 0.6 * (end[k] - start[k]) for k in (0, 1))
    page.mouse.move(*end)
    page.mouse.down()
    page.mouse.move((end[0] + x) / 2, (end[1] + y) / 2)
    await_frames(page)
    page.mouse.move(x, y)
    await_frames(page)
    page.mouse.up()
    drawn(page)
    assert page.evaluate(pattern)["rows"] < before["rows"]
    page.get_by_test_id("undo").click()
    drawn(page)
    # The profile is drawn wider at its foot, and no higher.
    foot = page.get_by_test_id("handle-f")
    span = float(foot.get_attribute("aria-valuenow") or "")
    foot.focus()
    page.keyboard.press("ArrowUp")
    drawn(page)
    assert span < float(foot.get_attribute("aria-valuenow") or "") < 1.2 * span
    wide, high = page.evaluate("window.__orishell.store.design.value.target.f.scale")
    assert wide > high == 1
    page.get_by_test_id("undo").click()
    drawn(page)
    assert page.evaluate(pattern) == before


def test_the_free_edge_of_a_flap_goes_where_it_is_drawn(page: Page) -> None:
    """Of the flap nearest to the eye; both flaps are as wide, and the drag is one step."""
    choose(page, "orthodiagonal")
    settle(page)
    pattern = "window.__orishell.store.design.value.pattern"
    before = page.evaluate(pattern)
    handle = page.get_by_test_id("handle-flap")

    def middle() -> tuple[float, float]:
        box = handle.bounding_box()
        assert box is not None
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    first = middle()
    handle.focus()
    page.keyboard.press("ArrowDown")
    drawn(page)
    assert page.evaluate(pattern)["flap"] < before["flap"]
    less = middle()
    page.get_by_test_id("undo").click()
    drawn(page)
    wanted = tuple(a + 8 * (b - a) for a, b in zip(first, less, strict=True))
    assert math.dist(wanted, first) > 8
    page.mouse.move(*first)
    page.mouse.down()
    for share in (0.5, 1.0):
        page.mouse.move(*(a + share * (b - a) for a, b in zip(first, wanted, strict=True)))
        await_frames(page)
    page.mouse.up()
    drawn(page)
    # Pixels: the width is rounded to three digits.
    assert math.dist(middle(), wanted) < 2
    page.get_by_test_id("undo").click()
    drawn(page)
    assert page.evaluate(pattern) == before


def test_panels_and_creases_are_inspected(page: Page) -> None:
    """A panel is chosen in the figures, in the pattern and in space, and by keys."""
    choose(page, "orthodiagonal")
    settle(page)
    card = page.get_by_test_id("inspect-card")
    areas = page.evaluate(
        """(({ flat, faces }) => Array.from({ length: faces.length / 4 }, (_, panel) => {
            const at = (k) => 2 * faces[4 * panel + k];
            const across = (a, b, axis) => flat[b + axis] - flat[a + axis];
            return Math.abs(across(at(0), at(2), 0) * across(at(1), at(3), 1)
                - across(at(0), at(2), 1) * across(at(1), at(3), 0)) / 2;
        }))(window.__orishell.store.view.value)"""
    )
    columns = page.evaluate("window.__orishell.store.view.value.header.grid[1]") - 1
    for name, wanted in (("smallest", min(areas)), ("largest", max(areas))):
        page.get_by_test_id(f"figure-{name}").click()
        await_frames(page)
        row, column = map(int, card.locator("h3").inner_text().removeprefix("Panel ").split(","))
        assert areas[row * columns + column] == pytest.approx(wanted, rel=1e-6)
        assert f"{name} panel" in card.inner_text().lower()
    assert column + 1 < columns
    pattern = page.get_by_test_id("pattern").locator("canvas").first
    pattern.focus()
    page.keyboard.press("ArrowRight")
    await_frames(page)
    assert card.locator("h3").inner_text() == f"Panel {row},{column + 1}"
    angles = folds(page)
    assert len(angles) >= 3
    assert all(now == target for now, target in angles)
    fold(page, 0)
    await_frames(page)
    assert folds(page) == [("0.0\u00b0", target) for _, target in angles]
    page.keyboard.press("Escape")
    await_frames(page)
    assert card.is_hidden()
    fold(page, 1)
    x, y = page.evaluate(FREE)
    page.mouse.click(x, y)
    await_frames(page)
    assert "Panel" in card.inner_text() or "crease" in card.inner_text()
    page.get_by_test_id("inspect-close").click()
    await_frames(page)
    page.mouse.move(1, 1)
    # Turning the shell chooses nothing.
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y + 10, steps=4)
    page.mouse.up()
    await_frames(page)
    assert page.get_by_test_id("inspect-close").count() == 0


@thorough
def test_play_stops_where_ties_hold(page: Page) -> None:
    bring(page, "shelter.toml")
    target = page.evaluate("window.__orishell.fold")
    assert 0 < target < 1
    put = "window.__orishell.shell3d.clipped.solids.children.filter((each) => each.visible).length"
    parts = page.evaluate(put)
    page.get_by_test_id("play").click()
    # What is clipped on appears one after the other, once the shell stands.
    wait_until(page, f"window.__orishell.fold === {target} && {put} < {parts}")
    wait_until(page, "document.querySelector('[data-testid=play]').ariaLabel !== 'Pause'")
    assert page.evaluate("window.__orishell.fold") == target
    assert page.evaluate(put) == parts
    page.get_by_test_id("untie").click()
    page.get_by_test_id("play").click()
    wait_until(page, "window.__orishell.fold === 1")
    assert page.get_by_test_id("untie").is_hidden()
    # From the pack again ties are hooked in again.
    page.get_by_test_id("play").click()
    wait_until(page, f"window.__orishell.fold === {target}")
    wait_until(page, "document.querySelector('[data-testid=play]').ariaLabel !== 'Pause'")
    assert page.get_by_test_id("untie").inner_text() == "Untie"
    feet = page.evaluate(FEET)
    page.mouse.click(*feet[-3])
    await_frames(page)
    card = page.get_by_test_id("inspect-card")
    assert card.locator("h3").inner_text() == f"Foot {len(feet) - 2}"
    assert "not known without loads" in card.inner_text()
    card.get_by_test_id("set-structure-material").click()
    assert page.evaluate("document.activeElement.dataset.testid") == "structure-material"
    leave(page)
    page.keyboard.press("Escape")


@thorough
def test_distances_follow_the_motion(page: Page) -> None:
    choose(page, "orthodiagonal")
    settle(page)
    leave(page)
    page.keyboard.press("m")
    x, y = middle(page, "pattern")
    page.mouse.click(x - 50, y - 40)
    page.mouse.click(x + 50, y + 40)
    await_frames(page)
    flat = metres(page, "measure-sheet")
    assert metres(page, "measure-space") < 0.98 * flat
    keep_picture(page, "studio-measure")
    fold(page, 0)
    assert metres(page, "measure-space") == metres(page, "measure-sheet") == flat
    # By keys, from vertex to vertex: the distance of two that are one edge apart does not change.
    fold(page, 1)
    page.get_by_test_id("pattern").locator("canvas").first.focus()
    for key in ("ArrowUp", "Enter", "ArrowRight", "Enter"):
        page.keyboard.press(key)
    await_frames(page)
    assert 0 < metres(page, "measure-space") == metres(page, "measure-sheet") < flat
    page.keyboard.press("Escape")
    assert page.get_by_test_id("measure-card").is_hidden()
    assert page.get_by_test_id("measure").get_attribute("aria-pressed") == "false"


@thorough
def test_the_motion_rests_where_panels_touch(page: Page) -> None:
    choose(page, "parallel-repeating")
    leave(page)
    page.evaluate(TOUCHING)
    settle(page)
    page.keyboard.press("Home")
    assert page.evaluate("window.__orishell.fold") == 0
    page.keyboard.press("ArrowRight")
    assert page.evaluate("window.__orishell.fold") == pytest.approx(0.01)
    page.keyboard.press("PageUp")
    drives, contact = page.evaluate(
        "(({ header }) => [header.drives_deg, header.contact])(window.__orishell.store.view.value)"
    )
    touches = contact["drive_deg"] / drives[-1]
    assert 0.05 < touches < 0.99
    assert page.evaluate("window.__orishell.fold") == pytest.approx(touches, abs=1e-6)
    touching = "window.__orishell.shell3d.u.touching.value.toArray()"
    assert page.evaluate(touching) == contact["panels"]
    await_frames(page)
    keep_picture(page, "studio-contact")
    # The place is a dot of the colour of what touches (its width tells it from other dots).
    assert page.evaluate(
        "window.__orishell.shell3d.guests.some(({ drawn }) => drawn.some(({ visible, material }) =>"
        " visible && material.uniforms.width?.value === 11))"
    )
    contact = page.evaluate(
        "getComputedStyle(document.documentElement).getPropertyValue('--contact').trim()"
    )
    colour = [int(contact[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    away = abs(pixels(page, "canvas")[..., :3] - colour).max(axis=-1)
    assert (away < 0.03).mean() > 1e-5
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("ArrowRight")
    assert page.evaluate("window.__orishell.fold") == pytest.approx(touches, abs=1e-6)
    page.keyboard.press("End")
    assert page.evaluate("window.__orishell.fold") == 1


@thorough
def test_what_stands_around_a_shell(page: Page) -> None:
    bring(page, "shelter.toml")
    wait_until(page, "document.querySelector('[data-figure=headroom] .orishell-number') !== null")
    figures = page.get_by_test_id("figures").inner_text()
    room = re.search(r"Headroom\s+([\d.]+) m", figures)
    assert room is not None
    assert 1.9 < float(room[1]) < page.evaluate("window.__orishell.report.deployed.height")
    legend = page.get_by_test_id("standing-legend").inner_text()
    assert legend.split() == ["feet", "ties"]
    for name in ("person", "ties"):
        switch = page.locator(f"label:has([data-testid={name}])")
        on = pixels(page, "canvas")
        switch.click()
        await_frames(page)
        assert (np.abs(on - pixels(page, "canvas")).max(axis=2) > 0.1).mean() > 2e-4
        switch.click()
    keep_picture(page, "studio-shelter")
    choose(page, "orthodiagonal")
    settle(page)
    assert page.locator("label:has([data-testid=ties])").is_hidden()
    page.get_by_test_id("unit").select_option("mm")
    settle(page)
    wait_until(page, "document.querySelector('[data-testid=person]').closest('label').hidden")


@thorough
def test_designs_are_compared(page: Page) -> None:
    choose(page, "orthodiagonal")
    settle(page)
    page.get_by_test_id("pin").click()
    assert page.get_by_test_id("change-panels").count() == 0
    first = page.evaluate("JSON.stringify(window.__orishell.store.design.value)")
    page.evaluate("window.__orishell.store.setPattern('columns', 17)")
    settle(page)
    assert page.get_by_test_id("change-panels").inner_text() == "+40"
    on = pixels(page, "canvas")
    page.get_by_test_id("past").click()
    strip = page.get_by_test_id("past-strip").get_by_role("button")
    assert strip.last.get_attribute("aria-current") == "true"
    keep_picture(page, "studio-compare")
    strip.nth(strip.count() - 2).click()
    settle(page)
    assert page.evaluate("JSON.stringify(window.__orishell.store.design.value)") == first
    page.get_by_test_id("undo").click()
    settle(page)
    assert page.evaluate("window.__orishell.store.design.value.pattern.columns") == 17
    page.get_by_test_id("past").click()
    page.get_by_test_id("pin").click()
    page.get_by_test_id("figures").get_by_text("pinned").wait_for(state="detached")
    await_frames(page)
    assert (np.abs(on - pixels(page, "canvas")).max(axis=2) > 0.05).mean() > 1e-3


@thorough
@pytest.mark.parametrize("size", led_by(SIZES, 2))
def test_cards_and_tools_lie_apart(browser: Browser, address: str, size: str) -> None:
    with opened(browser, address, **SIZES[size], color_scheme="dark", bypass_csp=True) as page:
        choose(page, "parallel-repeating")
        page.get_by_test_id("pin").click()
        page.get_by_test_id("past").click()
        x, y = page.evaluate(PANEL)
        (page.touchscreen.tap if SIZES[size].get("has_touch") else page.mouse.click)(x, y)
        await_frames(page)
        assert page.get_by_test_id("inspect-close").is_visible()
        page.get_by_test_id("measure").click()
        require_apart(
            page,
            [
                page.get_by_test_id("inspect-card"),
                page.get_by_test_id("measure-card"),
                page.locator(".scene-tools"),
                page.get_by_test_id("past-strip"),
                page.get_by_test_id("standing-legend"),
                page.locator(".fold-bar"),
                page.locator(".stage-tools"),
            ],
            SIZES[size]["width"],
        )
        if size == "laptop":
            axe = PACKAGES / "axe-core" / "axe.min.js"
            if not axe.is_file():
                lacking("axe-core is not installed: make node")
            page.add_script_tag(path=str(axe))
            for _ in ("dark", "light"):
                found = page.evaluate("axe.run().then((result) => result.violations)")
                assert [e["id"] for e in found if e["impact"] in {"serious", "critical"}] == []
                page.get_by_test_id("theme").click()
                await_frames(page)
