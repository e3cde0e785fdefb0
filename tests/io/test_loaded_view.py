"""A shell under load in viewer.html: what stands in the view, and what a browser makes of it."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loaded_shells import LARGEST, loaded_document
from orishell.document.loaded import LoadedCreases
from orishell.io.format import DEFAULT_SETTINGS
from orishell.io.formats.html import write_html
from orishell.io.view import dump_view
from viewer_pages import await_frames, pixels, wait_until, watched_page

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


def parts_of(view: bytes) -> tuple[dict[str, Any], bytes]:
    (size,) = struct.unpack("<I", view[:4])
    return json.loads(view[4 : 4 + size]), view[4 + size :]


def test_the_view_has_the_mesh_and_all_cases_in_single_precision() -> None:
    document = loaded_document()
    loaded = document.loaded
    assert loaded is not None
    header, blocks = parts_of(dump_view(document))
    arrays = {
        name: np.frombuffer(
            blocks, place["type"], int(np.prod(place["shape"])), place["offset"]
        ).reshape(place["shape"])
        for name, place in header["arrays"].items()
    }
    assert header["cases"] == [
        {
            "name": each.name,
            "sign": each.sign,
            "balanced": each.balanced,
            "strength": None,
            "parts_strength": None,
        }
        for each in loaded.cases
    ]
    np.testing.assert_array_equal(arrays["loaded_triangles"], loaded.triangles)
    np.testing.assert_array_equal(arrays["loaded_panels"], loaded.panels)
    np.testing.assert_array_equal(arrays["loaded_ties"], loaded.ties)
    placed = arrays["loaded_points"] + np.array(header["origin"]) - document.origin
    assert np.abs(placed - loaded.points).max() < 1e-6
    for number, case in enumerate(loaded.cases):
        moved = arrays["displacements"][number]
        assert np.abs(moved - case.displacements).max() <= 1e-7 * np.abs(case.displacements).max()
        # Newtons per square metre, and 1e6 of them in a megapascal.
        stresses = case.stresses * 1e-6
        np.testing.assert_allclose(arrays["stresses"][number], stresses, rtol=1e-6)
        # No load is lost where panels share nodes.
        total = arrays["panel_loads"][number].sum(axis=0)
        np.testing.assert_allclose(total, case.forces.sum(axis=0), rtol=1e-5, atol=1e-4)
    # The largest force along every crease, in newtons per metre as the document is in metres.
    pairs, forces = np.array([[0, 1], [1, 2]]), np.array([1500.0, 0.0])
    creases = LoadedCreases(pairs, forces, ("pull", ""), ("snow", ""))
    header, blocks = parts_of(dump_view(replace(document, loaded=replace(loaded, creases=creases))))
    assert header["creases"] == {"what": ["pull", ""], "cases": ["snow", ""]}
    for name, kind, written in (("panels", "u4", pairs), ("forces", "f4", forces)):
        offset = header["arrays"][f"crease_{name}"]["offset"]
        found = np.frombuffer(blocks, f"<{kind}", written.size, offset)
        np.testing.assert_array_equal(found, written.ravel())
    strengths = (16e6, 24e6, None)
    known = tuple(map(lambda case, each: replace(case, strength=each), loaded.cases, strengths))
    header, _ = parts_of(dump_view(replace(document, loaded=replace(loaded, cases=known))))
    assert [case["strength"] for case in header["cases"]] == [16, 24, None]
    known = tuple(replace(each, parts_strength=9e6) for each in loaded.cases)
    header, _ = parts_of(dump_view(replace(document, loaded=replace(loaded, cases=known))))
    assert [case["parts_strength"] for case in header["cases"]] == [9, 9, 9]
    assert "stiffeners" not in header


@pytest.mark.parametrize("cells", [1, 2])
def test_loads_on_panels_are_as_these_are_large(cells: int) -> None:
    """Own weight at nodes that panels share is of each as much as it has there."""
    document = loaded_document("parallel-repeating", cells)
    loaded = document.loaded
    assert loaded is not None
    a, b, c = np.moveaxis(loaded.points[loaded.triangles], 1, 0)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    nodes = np.bincount(loaded.triangles.ravel(), np.repeat(areas / 3, 3), len(loaded.points))
    weight = replace(loaded.cases[0], forces=np.outer(nodes, [0, 0, -60.0]))
    header, blocks = parts_of(dump_view(replace(document, loaded=replace(loaded, cases=(weight,)))))
    place = header["arrays"]["panel_loads"]
    loads = np.frombuffer(blocks, "<f4", int(np.prod(place["shape"])), place["offset"])
    expected = -60 * np.bincount(loaded.panels, areas)
    np.testing.assert_allclose(loads.reshape(-1, 3)[:, 2], expected, rtol=1e-5)


def test_the_view_says_how_nodes_are_held() -> None:
    """Held up only, pinned, clamped: by the translations (0 to 2) and turns (3 to 5) held."""
    document = loaded_document()
    assert document.loaded is not None
    ways = [[1, 2], *([4, axis] for axis in range(3)), *([7, axis] for axis in range(6))]
    held = replace(document.loaded, restrained=np.array(ways))
    header, blocks = parts_of(dump_view(replace(document, loaded=held)))
    place = header["arrays"]["held"]
    found = np.frombuffer(blocks, "u4", 6, place["offset"]).reshape(place["shape"])
    assert found.tolist() == [[1, 0], [4, 1], [7, 2]]


def test_a_view_without_loads_says_nothing_of_them() -> None:
    header, _ = parts_of(dump_view(replace(loaded_document(), loaded=None)))
    assert "cases" not in header
    assert not {"loaded_points", "displacements", "stresses", "held"} & set(header["arrays"])


def choose(page: Page, what: str, value: str) -> None:
    page.get_by_test_id(f"load-{what}").select_option(value)
    await_frames(page)


def differing(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    """Share of the pixels that are not the same."""
    return float((np.abs(one - other).max(axis=-1) > 0.1).mean())


def test_a_case_is_chosen_and_drawn(browser: Browser, tmp_path: Path) -> None:
    """Displaced and coloured at the target, where the fold stays meanwhile."""
    write_html(tmp_path / "viewer.html", loaded_document(), DEFAULT_SETTINGS)
    with watched_page(browser) as page:
        page.goto((tmp_path / "viewer.html").as_uri())
        wait_until(page, "window.orishell !== undefined")
        page.evaluate("orishell.player.set(0.5)")
        await_frames(page)
        half = pixels(page, ".stage canvas")
        choose(page, "case", "snow")
        assert page.evaluate("orishell.shell.fold") == 1
        legend = page.locator(".orishell-legend").inner_text()
        assert "snow: displacement; displacements \u00d7 5" in legend
        assert f"{1000 * LARGEST:g} mm" in legend
        snow = pixels(page, ".stage canvas")
        page.evaluate("orishell.player.toggle()")  # held: it does not move
        assert not page.evaluate("orishell.player.bar.querySelector('.playing') !== null")

        page.get_by_test_id("load-scale").fill("4")
        await_frames(page)
        assert "displacements \u00d7 20" in page.locator(".orishell-legend").inner_text()
        larger = pixels(page, ".stage canvas")
        choose(page, "measure", "stress")
        assert "MPa" in page.locator(".orishell-legend").inner_text()
        choose(page, "case", "own weight")
        assert "unstable: nothing resists this" in page.locator(".orishell-legend").inner_text()
        assert page.get_by_test_id("load-measure").is_disabled()
        moves = pixels(page, ".stage canvas")

        choose(page, "case", "")
        assert page.locator(".orishell-legend").inner_text().split() == [
            "upper",
            "side",
            "underside",
            "feet",
        ]
        bare = pixels(page, ".stage canvas")
        pictures = (half, snow, larger, moves, bare)
        for k, one in enumerate(pictures):
            for other in pictures[:k]:
                assert differing(one, other) > 0.005
        page.evaluate("orishell.player.set(0.5)")
        wait_until(page, "orishell.shell.quality.taps === 12")  # at rest, it is drawn finely again
        await_frames(page)
        # But for the tools, where one now has the focus.
        assert differing(pixels(page, ".stage canvas"), half) < 0.001


def test_a_shell_that_was_not_analysed_offers_no_loads(browser: Browser, tmp_path: Path) -> None:
    document = replace(loaded_document(), loaded=None)
    write_html(tmp_path / "viewer.html", document, DEFAULT_SETTINGS)
    with watched_page(browser) as page:
        page.goto((tmp_path / "viewer.html").as_uri())
        wait_until(page, "window.orishell !== undefined")
        assert page.get_by_test_id("load-case").count() == 0
