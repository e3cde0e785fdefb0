"""A surface in the studio as a person uses it: from a formula, or a dropped mesh, to its shell."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING, Any

import numpy as np

from samples import thorough
from studio_pages import choose, drag, drawn, settle, take_family, type_into
from surface_files import obj
from viewer_pages import keep_picture, pixels, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Page

FEW = """() => {
    const store = window.__orishell.store;
    const few = { rows: 4, columns: 4, fold_deg: 90, direction_deg: 0 };
    store.set({ pattern: { ...store.design.value.pattern, ...few } }, "few");
}"""
"""So few panels, begun in one way, are fitted within a second."""


def state(page: Page, of: str) -> Any:
    return page.evaluate(f"window.__orishell.store.{of}")


def aim(page: Page, at: str) -> None:
    page.locator(f"label:has([data-testid=aim-{at}])").click()


def at_a_surface(page: Page) -> None:
    begin(page)
    page.evaluate(FEW)
    settle(page)


def begin(page: Page) -> None:
    choose(page, "parallel-repeating")
    aim(page, "surface")
    take_family(page, "flat-foldable")


@thorough  # a dropped mesh goes the same way
def test_from_a_formula_to_the_fitted_shell(page: Page) -> None:
    at_a_surface(page)
    assert state(page, "report.value.family") == "flat-foldable"
    assert page.get_by_test_id("overlay-surface").is_checked()
    assert not page.get_by_test_id("overlay-f").is_visible()
    first = state(page, "report.value.deviation.crests.max")
    assert first > 0
    assert np.ptp(pixels(page, ".scene canvas")) > 0.3
    # Another formula: the surface is drawn at once, the shell once it is fitted.
    type_into(page, "formula-surface-height-0", "(x**2 - y**2)/20")
    wait_until(page, "window.__orishell.store.surfaceAt.value.formula.includes('20')")
    settle(page)
    assert state(page, "fault.value") is None
    assert state(page, "report.value.deviation.crests.max") != first
    # A corner of the rectangle is dragged: ranges follow; undo brings back formula and all.
    drag(page, "handle-upper-right-corner", -20, 15)
    settle(page)
    surface = state(page, "design.value.target.surface")
    assert surface["x"][1] < 4
    assert surface["y"][1] < 4
    page.get_by_test_id("undo").click()
    assert state(page, "design.value.target.surface.x") == [-4, 4]
    settle(page)
    # Back to the curves as they were.
    aim(page, "curves")
    drawn(page)
    assert state(page, "report.value.family") == "parallel-repeating"
    assert "surface" not in state(page, "design.value.target")
    settle(page)


@thorough
def test_picture_of_a_fitted_shell(page: Page) -> None:
    begin(page)
    page.evaluate("window.__orishell.store.set({ 'pattern.rows': 8, 'pattern.columns': 8 }, 'few')")
    settle(page)
    assert state(page, "freshness.value") == "current"
    keep_picture(page, "studio-surface")
    assert np.ptp(pixels(page, ".scene canvas")) > 0.3


@thorough
def test_a_fit_can_be_stopped_and_begun_again(page: Page) -> None:
    at_a_surface(page)
    before = state(page, "report.value.sheet.area")
    many = "{ 'pattern.rows': 15, 'pattern.columns': 15 }"
    page.evaluate(f"window.__orishell.store.set({many}, 'many')")
    page.get_by_test_id("fit-work-stop").click()
    assert state(page, "freshness.value") == "outdated"
    page.get_by_test_id("fit-again").wait_for()
    page.evaluate(FEW)
    settle(page)
    assert state(page, "freshness.value") == "current"
    assert state(page, "report.value.sheet.area") == before


@thorough  # the same curves are written: tests/shell/test_families
def test_a_family_that_sweeps_gives_its_curves(page: Page) -> None:
    at_a_surface(page)
    take_family(page, "parallel-repeating")
    settle(page)
    before = state(page, "report.value.sheet.area")
    page.get_by_test_id("by-curves").click()
    settle(page)
    assert sorted(state(page, "design.value.target")) == ["f", "g"]
    assert state(page, "report.value.sheet.area") == before


@thorough  # the mesh is read: test_surfaces
def test_a_dropped_mesh_becomes_the_surface(page: Page) -> None:
    at_a_surface(page)
    drop(page, "roof.obj", obj())
    target = "window.__orishell.store.design.value.target"
    wait_until(page, f"{target}.surface.triangles?.length === 128")
    assert "128 triangles of roof.obj" in page.get_by_test_id("surface-editor").inner_text()
    settle(page)
    assert state(page, "fault.value") is None
    assert state(page, "report.value.deviation.surface.max") < 0.2
    drop(page, "hole.obj", obj(holes=1))
    page.locator(".surface-editor .note.error").wait_for()
    assert "holes" in page.get_by_test_id("surface-editor").inner_text()


def drop(page: Page, name: str, text: str) -> None:
    content = base64.b64encode(text.encode()).decode()
    page.evaluate(
        """([name, content]) => {
            const data = new DataTransfer();
            data.items.add(new File([atob(content)], name));
            const how = { dataTransfer: data, bubbles: true, cancelable: true };
            document.body.dispatchEvent(new DragEvent("drop", how));
        }""",
        [name, content],
    )
