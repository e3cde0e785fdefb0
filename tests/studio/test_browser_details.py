"""Small things that a person trips over: names cut off, words over controls, missing marks."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from node_tools import PACKAGES, lacking
from studio_pages import drawn, drop_file, in_bar, opened, settle, take_family
from surface_files import obj
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator

    from playwright.sync_api import Browser, FloatRect, Locator, Page

STORE = "window.__orishell.store"
WIDTHS = (1440, 820)
CUT = """() => [...document.querySelectorAll(".inputs .parameter-head")].flatMap((row) => {
    const [name] = row.children;
    if (!row.checkVisibility()) return [];
    const wrong = [];
    const { width } = name.getBoundingClientRect();
    if (width < 20 || name.scrollWidth > name.clientWidth + 1 && name.clientWidth) {
        wrong.push(`${name.textContent} is cut to ${width}`);
    }
    const box = row.querySelector("input.number"), unit = row.querySelector(".unit:not(:empty)");
    if (box && unit) {
        const words = document.createRange();
        words.selectNodeContents(unit);
        const style = getComputedStyle(box);
        const end = box.getBoundingClientRect().right - parseFloat(style.paddingRight);
        const gap = words.getBoundingClientRect().left - end;
        const within = words.getBoundingClientRect().right < box.getBoundingClientRect().right;
        if (gap < 3 || !within) wrong.push(`${name.textContent}: a unit ${gap} px off`);
    }
    return wrong;
})"""
"""Names of controls that are cut off, and units that touch the numbers before them."""
NO_ROWS = """() => {
    const { store } = window.__orishell, shell = { ...store.design.value.shell, family: "auto" };
    const design = { shell, target: { surface: window.mesh }, pattern: { rows: 0, columns: 9 } };
    store.change(design, "mesh");
}"""
"""A mesh in a design that is refused, whatever its family."""
LOADED = """
[shell]
family = "parallel-repeating"
unit = "m"

[target.f]
formula = "0.4*(1-x**2)"
range = [-1, 1]

[target.g]
formula = "0"
range = [0, 2]

[pattern]
rows = 5
columns = 5

[workshop]
areal_density = 1.9

[structure]
modulus = 270e6
thickness = 0.01
crease_stiffness = "rigid"
cells = 1
supports = [{ at = "feet", kind = "pinned" }]

[[load_case]]
name = "snow"
snow = { ground = 500, arrangement = "undrifted" }

[[load_case]]
name = "wind"
wind = { speed = 20, direction_deg = 90, terrain = "II" }
"""
ARROWS = """(() => {
    const { motion, loaded, camera } = window.__orishell.shell3d;
    const { geometry } = loaded.marks.arrows;
    const ends = ["from", "to"].map((name) => geometry.getAttribute(name)), found = [];
    // Each is a shaft and two lines of its head.
    for (let k = 0; k < ends[0].count; k += 12) {
        const [tail, tip] = ends.map((end) => camera.position.clone().fromBufferAttribute(end, k));
        const { x, y, z } = tail.clone().add(tip).multiplyScalar(0.5);
        const covered = motion.hit(x, y, z, 0, 0, 1) !== null;
        found.push({ y, size: tip.distanceTo(tail), up: tip.z - tail.z, covered });
    }
    return found;
})()"""
"""Arrows of loads: the middle of each, its size, how far up it points, whether a panel is above."""
MOVED = """(() => {
    const { shell3d, store } = window.__orishell, { loaded } = store.view.value;
    const { deflection, scale } = shell3d.load, place = shell3d.camera.position.clone();
    for (let k = 0; k < loaded.ofPanels; k++) {
        place.set(0, 0, 0);
        for (const node of loaded.triangles.slice(3 * k, 3 * k + 3)) {
            for (const axis of [0, 1, 2]) {
                const moved = scale * deflection.displacements[3 * node + axis];
                const at = place.getComponent(axis);
                place.setComponent(axis, at + (loaded.points[3 * node + axis] + moved) / 3);
            }
        }
        const [x, y] = shell3d.onScreen(place), panel = loaded.panels[k];
        if (document.elementFromPoint(x, y) !== shell3d.canvas) continue;
        const { origin: o, direction: d } = shell3d.eye.ray(x, y);
        const before = shell3d.motion.hit(o.x, o.y, o.z, d.x, d.y, d.z)?.panel;
        if (before !== panel && shell3d.under(x, y)?.panel === panel) return [x, y, panel];
    }
})()"""
"""The middle of a triangle that is seen where its panel was not without loads, and the panel."""
FOOT = """(() => {
    const { shell3d, store } = window.__orishell, { header } = store.view.value;
    for (const { at: [row, column] } of header.report.deployment.ground.feet) {
        const corner = shell3d.motion.faces.indexOf(row * header.grid[1] + column);
        const [x, y] = shell3d.onScreen(shell3d.corner(corner));
        if (document.elementFromPoint(x, y) === shell3d.canvas) return [x, y];
    }
})()"""
CARD = "document.querySelector('[data-testid=inspect-card] h3').textContent"
AXE = """axe.run({ runOnly: ["target-size"] }).then(({ violations }) =>
    violations.flatMap(({ nodes }) => nodes.map(({ html }) => html.slice(0, 160))))"""


@pytest.fixture(scope="module")
def page(browser: Browser, address: str) -> Iterator[Page]:
    """One page for all, which may be given axe-core."""
    with opened(browser, address, width=1440, height=900, bypass_csp=True) as shared:
        yield shared


def resize(page: Page, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 844 if width < 500 else 1000})
    await_frames(page)


def box_of(element: Locator) -> FloatRect:
    box = element.bounding_box()
    assert box is not None
    return box


def load_example(page: Page, name: str) -> None:
    in_bar(page, "examples").click()
    page.get_by_test_id(f"example-{name}").click()
    drawn(page)


def test_names_and_units_of_controls_are_whole(page: Page) -> None:
    load_example(page, "shelter")
    page.get_by_test_id("structure-material").select_option("birch plywood")
    drawn(page)
    for width in WIDTHS:
        resize(page, width)
        assert page.evaluate(CUT) == []
    # What is typed in another unit is said below the box, and moves nothing.
    page.get_by_test_id("structure-snow").fill("500 N/m\u00b2")
    assert page.locator("output.echo").inner_text() == "= 0.5 kN/m\u00b2"
    assert page.evaluate(CUT) == []
    page.get_by_test_id("structure-snow").fill("")


def test_words_at_the_edge_lie_over_no_control(page: Page) -> None:
    for width in (*WIDTHS, 390):
        resize(page, width)
        page.evaluate(f"{STORE}.said.set('')")
        page.evaluate(f"{STORE}.said.set('Undo brings back your unsaved work on a shell')")
        await_frames(page)
        said = box_of(page.get_by_test_id("said"))
        bar = box_of(page.locator(".fold-bar"))
        assert said["y"] + said["height"] <= bar["y"] or bar["y"] + bar["height"] <= said["y"]
        assert said["x"] >= 0
        assert said["x"] + said["width"] <= width
    page.evaluate(f"{STORE}.said.set('')")


def test_controls_are_large_enough_to_be_hit(page: Page) -> None:
    axe = PACKAGES / "axe-core" / "axe.min.js"
    if not axe.is_file():
        lacking("axe-core is not installed: make node")
    page.add_script_tag(path=str(axe))
    for width in WIDTHS:
        resize(page, width)
        found: list[str] = page.evaluate(AXE)
        assert found == []


def test_a_line_goes_from_the_last_point_to_the_pointer(page: Page) -> None:
    resize(page, 1440)
    in_bar(page, "new").click()
    plane = box_of(page.get_by_test_id("curve-f"))
    at = [(plane["x"] + x * plane["width"], plane["y"] + 0.6 * plane["height"]) for x in (0.3, 0.6)]
    page.mouse.click(*at[0])
    page.mouse.move(*at[1])
    await_frames(page)
    band = box_of(page.get_by_test_id("curve-f").locator(".plot-band"))
    assert band["x"] == pytest.approx(at[0][0], abs=12)
    assert band["x"] + band["width"] == pytest.approx(at[1][0], abs=12)
    page.get_by_test_id("sketch-cancel").click()
    await_frames(page)


def test_automatic_waits_for_curves(page: Page) -> None:
    in_bar(page, "new").click()
    page.get_by_test_id("sketch-cancel").click()
    page.evaluate(f"{STORE}.redo()")
    take_family(page, "auto")
    await_frames(page)
    assert page.get_by_test_id("blank").is_visible()
    assert not page.get_by_text("was stopped").is_visible()


def test_a_mesh_is_drawn_once_its_design_is_mended(page: Page) -> None:
    drop_file(page, "roof.obj", obj())
    wait_until(page, f"{STORE}.surface.value !== null")
    page.evaluate(f"window.mesh = {STORE}.design.value.target.surface")
    load_example(page, "parallel-repeating")
    assert page.evaluate(f"{STORE}.surface.value") is None
    assert page.evaluate(f"{STORE}.surfaceAt.value") is None
    page.evaluate(NO_ROWS)
    wait_until(page, f"{STORE}.surfaceAt.value === window.mesh")
    assert page.evaluate(f"{STORE}.surface.value") is None
    page.evaluate(f"{STORE}.set({{ 'pattern.rows': 9 }}, 'rows')")
    wait_until(page, f"{STORE}.surface.value !== null")
    assert page.get_by_test_id("surface-editor").locator(".handle").count() == 4
    load_example(page, "parallel-repeating")


def test_arrows_of_loads_stand_outside_at_both_ends(page: Page) -> None:
    page.evaluate(f"(design) => {STORE}.change(design, 'loaded')", tomllib.loads(LOADED))
    settle(page)
    page.get_by_test_id("load-case").select_option("snow")
    page.get_by_test_id("load-scale").fill("0")
    await_frames(page)
    snow = page.evaluate(ARROWS)
    assert len(snow) > 20
    assert not any(each["covered"] for each in snow)
    # The shell is the same from both ends, and so is its snow.
    sizes = [each["size"] for each in sorted(snow, key=lambda each: each["y"])]
    half = len(sizes) // 2
    assert sum(sizes[:half]) == pytest.approx(sum(sizes[half:]), rel=0.05)
    page.get_by_test_id("load-case").select_option("wind")
    page.get_by_test_id("load-scale").fill("0")
    await_frames(page)
    wind = page.evaluate(ARROWS)
    assert any(each["up"] > 0 for each in wind)  # suction
    assert not any(each["covered"] for each in wind)
    page.get_by_test_id("load-case").select_option("")


def test_what_is_picked_under_a_load_is_what_is_drawn_there(page: Page) -> None:
    """At a place where the panel was not before it moved; feet, too."""
    page.evaluate(f"(design) => {STORE}.change(design, 'loaded')", tomllib.loads(LOADED))
    settle(page)
    page.get_by_test_id("load-case").select_option("wind")
    await_frames(page)
    x, y, panel = page.evaluate(MOVED)
    columns = page.evaluate(f"{STORE}.view.value.header.grid[1]") - 1
    page.mouse.click(x, y)
    wait_until(page, f"{CARD} === 'Panel {panel // columns},{panel % columns}'")
    assert "Stress, wind" in page.get_by_test_id("inspect-card").inner_text()
    x, y = page.evaluate(FOOT)
    page.mouse.click(x, y)
    wait_until(page, f"{CARD}.startsWith('Foot ')")
    page.keyboard.press("Escape")
    page.get_by_test_id("load-case").select_option("")


def test_a_warning_names_the_window_of_its_settings(page: Page) -> None:
    load_example(page, "parallel-repeating")
    settle(page)
    said = page.locator(".results").text_content() or ""
    assert "say how large your boards are" in said
    assert "under Workshop" not in said
    in_bar(page, "export").click()
    assert page.locator("[data-key=stock]").is_visible()
    page.keyboard.press("Escape")


def test_what_is_seldom_asked_for_is_folded_away(page: Page) -> None:
    load_example(page, "shelter")
    # Families: the chosen one, and the others when they are asked for.
    cards = page.locator(".family:visible")
    assert cards.count() == 1
    more = page.get_by_test_id("families-more")
    more.click()
    assert cards.count() > 4
    more.click()
    assert cards.count() == 1
    page.get_by_test_id("family-orthodiagonal").focus()
    page.keyboard.press("ArrowUp")
    assert cards.count() > 4
    page.keyboard.press("ArrowDown")
    settle(page)
    page.keyboard.press("Enter")
    assert cards.count() == 1
    assert page.evaluate(f"{STORE}.design.value.shell.family") == "orthodiagonal"
    # An end at pi is called so, and stays the number that it was.
    end = page.get_by_test_id("range-f-high")
    before = page.evaluate(f"{STORE}.design.value.target.f.range")
    assert end.input_value() == "pi"
    page.get_by_test_id("range-f-low").fill("0.1")
    page.keyboard.press("Tab")
    drawn(page)
    assert page.evaluate(f"{STORE}.design.value.target.f.range") == [0.1, before[1]]
    page.get_by_test_id("undo").click()
    # A row says what was found, and not to how many digits.
    settle(page)
    assert "e-1" not in (page.get_by_test_id("verify-status").text_content() or "")
    in_bar(page, "export").click()
    page.locator("label:has([data-testid=task-kit])").click()
    hinges = page.locator("[data-key=row_hinge]")
    assert hinges.is_hidden()
    page.get_by_test_id("workshop-seldom").locator("summary").click()
    assert hinges.is_visible()
    page.keyboard.press("Escape")


HALL = """
[shell]
family = "orthodiagonal"
unit = "m"

[target.f]
formula = "2.6*(1 - (x/2)**2)"
range = [-2, 2]

[target.g]
formula = "0.1*cos(2*pi*x/0.75)"
range = [0, 1.5]

[pattern]
rows = 7
columns = 5
flap = 0
depth = 0.12
heading_deg = 90
spacing = "equal"
"""


def test_an_end_is_closed_by_a_wall_with_a_door(page: Page) -> None:
    """It stands in the scene; a door that is too high is lowered by the button that says so."""
    drop_file(page, "hall.toml", HALL)
    settle(page)
    strips = "window.__orishell.store.view.value.clipped.flatMap((part) => part.header.names ?? [])"
    wall = "window.__orishell.store.report.value.end_walls"
    assert page.evaluate(strips) == []
    assert page.get_by_test_id("end-wall-last-wall").is_hidden()
    page.get_by_test_id("end-walls").click()
    page.get_by_test_id("end-wall-last-wall").check()
    settle(page)
    names = page.evaluate(strips)
    assert len(names) == page.evaluate(wall)[0]["panels"]
    assert all(name.startswith("last wall ") for name in names)
    page.get_by_test_id("end-wall-last-door").check()
    page.get_by_test_id("end-wall-last-height").fill("300 cm")
    settle(page)
    page.get_by_test_id("use-nearest").click()
    settle(page)
    assert page.get_by_test_id("banner").is_hidden()
    door = page.evaluate(wall)[0]["door"]
    assert door["width"] == 0.9
    assert 2 < door["height"] < 2.6  # of the profile
    page.get_by_test_id("end-wall-last-wall").uncheck()
    assert page.evaluate("window.__orishell.store.design.value.end_wall") is None


def test_a_second_skin_follows_a_gap_or_a_curve_of_its_own(page: Page) -> None:
    path = Path(__file__).parents[2] / "examples" / "two_skins.toml"
    drop_file(page, "two_skins.toml", path.read_text("utf-8"))
    design = "window.__orishell.store.design.value"
    wait_until(page, f"{design}.target.inner")
    formula = page.get_by_test_id("formula-inner")
    assert formula.input_value() == "-0.128*x**2 - 0.8"
    assert page.get_by_test_id("skin-curve").is_hidden()
    page.get_by_test_id("stiffeners-gap").fill("25 cm")
    assert page.evaluate(f"[{design}.stiffeners.gap, {design}.target.inner]") == [0.25, None]
    assert formula.is_hidden()
    drawn(page)
    # Ten percent of the 8.4 m of f below it.
    page.get_by_test_id("skin-curve").click()
    assert formula.input_value() == "-0.16*x**2 - 0.84"
    assert page.evaluate(f"{design}.stiffeners") == {"kind": "skin", "walls": "all"}
    page.locator("label:has([data-testid='stiffeners-kind-'])").click()
    assert page.evaluate(f"[{design}.stiffeners, {design}.target.inner]") == [None, None]
    drawn(page)
