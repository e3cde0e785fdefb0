"""Curves in their planes: drawn, dropped, dragged by their handles, sized."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from ezdxf.filemanagement import new

from samples import thorough
from studio_pages import SIZES, choose, drawn, in_bar, opened
from viewer_pages import await_frames, keep_picture, require_apart, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, FloatRect, Locator, Page

TARGET = "window.__orishell.store.design.value.target"


def target(page: Page, name: str) -> Any:
    return page.evaluate(f"{TARGET}.{name}")


def plane(page: Page, name: str) -> FloatRect:
    curve = page.get_by_test_id(f"curve-{name}")
    curve.scroll_into_view_if_needed()
    return place(curve)


def place(element: Locator) -> FloatRect:
    box = element.bounding_box()
    assert box is not None
    return box


def put(page: Page, name: str, *places: tuple[float, float]) -> None:
    """Click at shares of a plane, from its upper left corner."""
    box = plane(page, name)
    for x, y in places:
        page.mouse.click(box["x"] + x * box["width"], box["y"] + y * box["height"])
        await_frames(page)


def stroke(page: Page, name: str) -> None:
    """Half a circle in one go, with a trembling hand."""
    box = plane(page, name)
    x, y, radius = box["x"] + box["width"] / 2, box["y"] + 0.75 * box["height"], 70
    page.mouse.move(x - radius, y)
    page.mouse.down()
    for step in range(1, 41):
        turn, tremble = math.pi * step / 40, step % 2
        page.mouse.move(x - radius * math.cos(turn), y - radius * math.sin(turn) + tremble)
    page.mouse.up()
    await_frames(page)


def hold(page: Page, test_id: str, right: float, down: float) -> None:
    """Drag a handle by so many pixels, and keep it held."""
    box = place(page.get_by_test_id(test_id))
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + right / 2, y + down / 2)
    page.mouse.move(x + right, y + down)
    await_frames(page)


@thorough  # likewise on the canvas: test_browser_sketch
def test_from_empty_planes_to_a_shell(page: Page) -> None:
    choose(page, "orthodiagonal")
    page.get_by_test_id("new").click()
    await_frames(page)
    assert target(page, "f") == target(page, "g") == {"points": [], "smooth": True}
    stroke(page, "f")
    assert 4 <= len(target(page, "f")["points"]) <= 9
    page.get_by_test_id("sketch-finish").click()
    # Each click goes to the end, whichever way it lies; undo takes one back.
    put(page, "g", (0.2, 0.6), (0.8, 0.6), (0.5, 0.4))
    xs = [x for x, _ in target(page, "g")["points"]]
    assert xs[0] < xs[2] < xs[1]
    page.keyboard.press("Control+z")
    assert [x for x, _ in target(page, "g")["points"]] == xs[:2]
    page.keyboard.press("Enter")
    assert page.get_by_test_id("draw-g").get_attribute("aria-pressed") == "false"
    page.get_by_test_id("sketch-finish").click()
    drawn(page)
    # From left to right between two ends: the order stays what it was.
    page.get_by_test_id("draw-g").click()
    put(page, "g", (0.2, 0.6), (0.4, 0.62), (0.6, 0.6), (0.8, 0.62))
    page.keyboard.press("Escape")
    page.get_by_test_id("sketch-finish").click()
    xs = [x for x, _ in target(page, "g")["points"]]
    assert xs == sorted(xs)
    # A double click puts a point where the curve is nearest.
    box = plane(page, "g")
    page.mouse.dblclick(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    drawn(page)
    assert len(target(page, "g")["points"]) == 5
    assert [x for x, _ in target(page, "g")["points"]] == sorted(
        x for x, _ in target(page, "g")["points"]
    )


def test_a_curve_drawn_with_keys(page: Page) -> None:
    choose(page, "orthodiagonal")
    page.get_by_test_id("curve-f").focus()
    page.keyboard.press("d")
    drawn(page)  # the plane has its new size, and with it the step of a key
    for keys in (
        ["ArrowLeft"] * 6,
        ["ArrowRight"] * 6 + ["ArrowUp"] * 4,
        ["ArrowRight"] * 6 + ["ArrowDown"] * 4,
    ):
        for key in keys:
            page.keyboard.press(key)
        page.keyboard.press("Space")
    page.keyboard.press("Enter")
    points = target(page, "f")["points"]
    assert len(points) == 3
    assert points[0][1] == pytest.approx(points[2][1])
    assert points[1][0] - points[0][0] == pytest.approx(points[2][0] - points[1][0])
    page.keyboard.press("Enter")
    assert page.get_by_test_id("sketch").is_hidden()
    drawn(page)


@thorough
def test_points_are_caught_by_mirror_images_axes_and_the_grid(page: Page) -> None:
    choose(page, "orthodiagonal")
    table = {"points": [[-2, 0], [-1, 1.3], [0.9, 1.2], [2, 0]], "smooth": True}
    page.evaluate("table => window.__orishell.store.setCurve('f', table, 'f')", table)
    page.get_by_role("button", name="Fit f into view").click()
    drawn(page)
    hint = page.locator("[data-curve=f] .plot-hint")
    first, last = (place(page.get_by_test_id(f"point-f-{k}")) for k in (0, 3))
    pixels = (last["x"] - first["x"]) / 4
    hold(page, "point-f-2", 0.1 * pixels + 2, -0.1 * pixels - 2)
    assert target(page, "f")["points"][2] == [1, 1.3]
    assert "mirror image" in hint.inner_text()
    keep_picture(page, "studio-snapping")
    page.mouse.up()
    assert hint.is_hidden()
    # With Alt nothing is caught.
    page.keyboard.down("Alt")
    hold(page, "point-f-2", 3, 0)
    page.mouse.up()
    page.keyboard.up("Alt")
    assert target(page, "f")["points"][2] != [1, 1.3]


def half_circle(directory: Path) -> Path:
    document = new("R2000", units=6)
    document.modelspace().add_arc((0, 0), 3, 0, 180)
    path = directory / "half.dxf"
    document.saveas(path)
    return path


@thorough
def test_a_dropped_half_circle_stays_an_arc(page: Page, tmp_path: Path) -> None:
    choose(page, "orthodiagonal")
    with page.expect_file_chooser() as chooser:
        page.get_by_test_id("file-f").click()
    chooser.value.set_files(half_circle(tmp_path))
    wait_until(page, f"{TARGET}.f.path !== undefined")
    drawn(page)
    assert target(page, "f") == {"path": "M-3 0 A3 3 0 0 0 3 0"}
    assert page.get_by_test_id("banner").is_hidden()
    assert page.get_by_test_id("span-f").input_value() == "6"
    assert page.get_by_test_id("height-f").input_value() == "3"
    # All of it is in view, and stands on the ground beside a person.
    box = plane(page, "f")
    ground, person, line = (
        place(page.locator(f"[data-curve=f] .plot-{each}")) for each in ("ground", "person", "line")
    )
    assert box["x"] <= line["x"]
    assert line["x"] + line["width"] <= box["x"] + box["width"]
    assert person["height"] / line["height"] == pytest.approx(1.75 / 3, rel=0.1)
    assert person["y"] + person["height"] == pytest.approx(ground["y"], abs=2)
    keep_picture(page, "studio-arc")
    # Proportions are kept, or not: half an ellipse is an arc, too.
    page.get_by_test_id("span-f").fill("4")
    drawn(page)
    assert target(page, "f")["scale"] == pytest.approx(4 / 6)
    assert page.get_by_test_id("height-f").input_value() == "2"
    page.get_by_test_id("proportional-f").click()
    page.get_by_test_id("height-f").fill("2.5")
    drawn(page)
    assert target(page, "f")["scale"] == pytest.approx([4 / 6, 2.5 / 3])
    page.get_by_test_id("proportional-f").click()
    # Its bulge is dragged; flat, it is a straight line.
    bulge = page.get_by_test_id("bulge-f-0")
    bulge.focus()
    page.keyboard.press("Shift+ArrowDown")
    assert target(page, "f")["path"].count("A") == 1
    assert page.get_by_test_id("banner").is_hidden()
    page.keyboard.press("Delete")
    assert target(page, "f")["path"] == "M-3 0 L3 0"
    page.get_by_test_id("undo").click()
    page.get_by_test_id("undo").click()
    # The person goes, and comes again.
    page.get_by_test_id("person").click()
    assert page.locator("[data-curve=f] .plot-person").count() == 0
    page.get_by_test_id("person").click()
    assert page.locator("[data-curve=f] .plot-person").count() == 1


@thorough
def test_a_spline_as_a_path_keeps_its_shape_and_has_tangents(page: Page) -> None:
    choose(page, "orthodiagonal")
    page.locator("label:has([data-testid=mode-f-spline])").click()
    drawn(page)
    height = page.get_by_test_id("height-f").input_value()
    page.locator("label:has([data-testid=mode-f-path])").click()
    drawn(page)
    assert page.get_by_test_id("height-f").input_value() == height
    before = target(page, "f")["path"]
    page.get_by_test_id("tangent-f-1").focus()
    page.keyboard.press("Shift+ArrowUp")
    drawn(page)
    after = target(page, "f")["path"]
    assert after != before
    assert after.count("C") == before.count("C")
    page.get_by_test_id("add-f").click()
    assert target(page, "f")["path"].count("C") == before.count("C") + 1
    page.locator("label:has([data-testid=mode-f-formula])").click()
    drawn(page)


def test_ends_of_a_range_are_not_cut(page: Page) -> None:
    choose(page, "orthodiagonal")
    for end, number in (("low", "-3.14159265"), ("high", "3.14159265")):
        box = page.get_by_test_id(f"range-f-{end}")
        box.fill(number)
        drawn(page)
        assert box.evaluate("box => box.scrollWidth <= box.clientWidth")


@thorough
def test_tools_of_the_curves_have_room(page: Page) -> None:
    choose(page, "orthodiagonal")
    page.locator("label:has([data-testid=mode-f-path])").click()
    drawn(page)
    for size in SIZES.values():
        page.set_viewport_size({"width": size["width"], "height": size["height"]})
        for name in "fg":
            controls = page.locator(
                f"[data-curve={name}] :is(.curve-tools :is(button, .number), .curve-head label)"
            )
            require_apart(page, controls.all(), size["width"])
    page.set_viewport_size({"width": 1280, "height": 720})


@thorough
def test_curves_are_drawn_with_a_finger(browser: Browser, address: str) -> None:
    with opened(browser, address, **SIZES["phone"], color_scheme="dark") as page:
        in_bar(page, "new").tap()
        drawings = {"f": ((0.3, 0.7), (0.5, 0.4), (0.7, 0.7)), "g": ((0.1, 0.5), (0.9, 0.5))}
        for name, places in drawings.items():
            box = plane(page, name)
            for x, y in places:
                page.touchscreen.tap(box["x"] + x * box["width"], box["y"] + y * box["height"])
            await_frames(page)
            points = target(page, name)["points"]
            assert len(points) == len(places)
            assert points[0][1] == points[-1][1]
            page.get_by_test_id("sketch-finish").tap()
        drawn(page)
        keep_picture(page, "studio-phone")
        reach = place(page.locator("[data-testid=point-f-1] .handle-reach"))
        assert min(reach["width"], reach["height"]) >= 44
        page.get_by_test_id("add-g").tap()
        assert len(target(page, "g")["points"]) == 3
