"""What stiffens a shell is in its loaded view and its VTK file, displaced and stressed as it is."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import meshio
import numpy as np
import pytest

from design_tables import Tables, formula, tables
from orishell import Shell
from orishell.design_file import check_design
from orishell.io.format import DEFAULT_SETTINGS
from orishell.io.formats.html import write_html
from orishell.io.formats.vtk import write_vtk
from orishell.io.view import dump_view
from orishell.numerics.arrays import Array
from orishell.plot import DrawnCase, plot_structure
from orishell.shell.make import make_shell
from orishell.structure.mesh.stresses import facet_stresses, panel_stresses
from orishell.structure.solve.active_set import respond
from viewer_pages import await_frames, pixels, wait_until, watched_page

if TYPE_CHECKING:
    from playwright.sync_api import Browser

KINDS = {"gussets": {"kind": "gussets"}, "boxes": {"kind": "boxes", "columns": "all"}}


def arch(kind: str, **asked: Any) -> Shell:
    """A small arch with flaps, its creases free, under its own weight."""
    f, g = formula("-x**2", -1, 1), formula("0.1*cos(2*pi*x)", 0, 1.5)
    pattern = {"rows": 3, "columns": 4, "heading_deg": 90, "spacing": "equal"}
    design: Tables = {
        **tables("orthodiagonal", f, g, **pattern),
        "workshop": {"areal_density": 5},
        "stiffeners": {"share": 0.7, **KINDS[kind]},
        "structure": {
            "modulus": 8e9,
            "thickness": 0.002,
            "supports": [{"at": "feet", "kind": "pinned", "edges": True}],
            "crease_stiffness": "free",
            "nonlinear": False,
            "cells": 4,
            **asked,
        },
        "load_case": [{"name": "weight", "self_weight": True}],
    }
    file = check_design(design, Path("x.toml"))
    return make_shell(file, clash="unexamined", skip=("remedies", "verification"))


def expected(shell: Shell) -> tuple[list[str], list[Array], list[Array], list[Array]]:
    """Names, corners, their displacements (t, 3, 3) and stresses (t,) of every part by itself.

    From dofs of the model, as its parts have them, not from the points of its mesh.
    """
    assert shell.analysis is not None
    model, (case,) = shell.analysis.model, shell.analysis.cases
    found = model.factorised(0.0)
    loads = found.free_loads(case.forces)
    moved = found.moved(respond(found, loads).displacements)
    names = [name for part in shell.document.attached if part.kind != "flap" for name in part.names]
    corners, displaced, stressed = [], [], []
    for plates, section in zip(model.plates, model.stiffened.sections, strict=True):
        own, count = plates.own, len(plates.own.nodes)
        straight = moved[plates.dofs[: 3 * own.node_count]].reshape(-1, 3)
        borne = facet_stresses(own.facets, section, plates.corners_moved(moved))
        stresses = panel_stresses(own, section, borne).von_mises().max(axis=1)
        for number in range(count):
            mine = own.panels == number
            corners.append(own.facets.points[own.facets.triangles[mine]])
            displaced.append(straight[own.facets.triangles[mine]])
            stressed.append(stresses[mine])
    return names, corners, displaced, stressed


def agree(
    shell: Shell,
    numbers: dict[str, int],
    read: tuple[Array, Array, Array, Array, Array],
    accuracy: float,
) -> None:
    """Every part by its name: where it is, how it is displaced and stressed.

    read: Points (N, 3), triangles (T, 3), their panels (T,), displacements (N, 3), stresses (T,).
    """
    names, corners, displaced, stressed = expected(shell)
    points, triangles, panels, moves, stresses = read
    assert list(numbers) == names
    first = len(shell.document.mesh.faces)
    assert list(numbers.values()) == list(range(first, first + len(names)))
    most = max(float(np.abs(each).max()) for each in displaced)
    assert most > 0
    for name, place, move, stress in zip(names, corners, displaced, stressed, strict=True):
        mine = panels == numbers[name]
        np.testing.assert_allclose(points[triangles[mine]], place, rtol=0, atol=accuracy)
        np.testing.assert_allclose(moves[triangles[mine]], move, rtol=0, atol=accuracy * most)
        np.testing.assert_allclose(stresses[mine], stress, rtol=1e-4, atol=1e-4 * stress.max())


@pytest.mark.parametrize("kind", KINDS)
def test_all_of_it_is_in_the_file_for_paraview(kind: str, tmp_path: Path) -> None:
    shell = arch(kind)
    write_vtk(tmp_path / "shell.vtu", shell.document, DEFAULT_SETTINGS)
    mesh = meshio.read(tmp_path / "shell-structure.vtu")
    known = {"metres_per_unit", "drive_deg"}
    numbers = {
        name: int(number[0]) for name, number in mesh.field_data.items() if name not in known
    }
    (cells,) = mesh.cells
    read = (
        shell.document.in_world(np.zeros(3)) * -1 + mesh.points,
        cells.data,
        mesh.cell_data["panel"][0],
        mesh.point_data["displacement: weight"],
        mesh.cell_data["von Mises: weight"][0],
    )
    agree(shell, numbers, read, 1e-8)


@pytest.mark.parametrize("kind", KINDS)
def test_it_is_there_in_states_as_it_is_in_them(kind: str, tmp_path: Path) -> None:
    """Where it is joined to the sheet, and nowhere else."""
    document = arch(kind).document
    write_vtk(tmp_path / "shell.pvd", document, DEFAULT_SETTINGS)
    sheet = len(document.mesh.faces)
    for number in (0, len(document.states) - 1):
        mesh = meshio.read(tmp_path / f"shell-{number:04d}.vtu")
        found = [
            (name, corners)
            for part, state in document.parts_in(number)[1:]
            for name, corners in zip(part.names, state.positions[part.mesh.faces], strict=True)
        ]
        (cells,) = mesh.cells
        assert len(cells.data) == sheet + len(found)
        assert bool(found) == (number > 0)
        for k, (name, corners) in enumerate(found, sheet):
            assert int(mesh.field_data[name][0]) == k == mesh.cell_data["panel"][0][k]
            placed = document.in_world(corners)
            np.testing.assert_allclose(mesh.points[cells.data[k]], placed, rtol=0, atol=1e-9)


@pytest.mark.parametrize("kind", KINDS)
def test_all_of_it_is_in_the_view(kind: str) -> None:
    shell = arch(kind)
    view = dump_view(shell.document)
    (size,) = struct.unpack("<I", view[:4])
    header: dict[str, Any] = json.loads(view[4 : 4 + size])
    arrays = {
        name: np.frombuffer(
            view[4 + size :], place["type"], int(np.prod(place["shape"])), place["offset"]
        ).reshape(place["shape"])
        for name, place in header["arrays"].items()
    }
    read = (
        arrays["loaded_points"] + np.array(header["origin"]) - shell.design.origin,
        arrays["loaded_triangles"],
        arrays["loaded_panels"],
        arrays["displacements"][0],
        1e6 * arrays["stresses"][0],
    )
    agree(shell, header["stiffeners"], read, 1e-6)
    assert len(arrays["panel_loads"][0]) <= len(shell.document.mesh.faces)


@pytest.mark.parametrize("kind", KINDS)
def test_panels_have_the_numbers_of_the_sheet(kind: str) -> None:
    """Flaps counted, that fold with it and have no mesh: each is where the sheet has its number."""
    document = arch(kind).document
    assert document.loaded is not None
    points, panels = document.loaded.points, document.loaded.panels
    middles = document.shell.positions[document.mesh.faces].mean(axis=1)
    corners = points[document.loaded.triangles].mean(axis=1)
    for panel in np.unique(panels):
        away = np.linalg.norm(middles - corners[panels == panel].mean(axis=0), axis=1)
        assert int(np.argmin(away)) == panel


@pytest.mark.parametrize("kind", KINDS)
def test_it_is_drawn_displaced(kind: str, tmp_path: Path) -> None:
    """The picture changes with what only parts do, and is the same without a change."""
    loaded = arch(kind).document.loaded
    assert loaded is not None
    (case,) = loaded.cases
    own = np.setdiff1d(loaded.all_triangles, loaded.triangles)
    assert len(own)
    other = case.displacements.copy()
    other[own] += [0.0, 0.0, 0.5 * np.abs(other).max()]
    pictures = []
    for number, moved in enumerate((case.displacements, case.displacements, other)):
        path = tmp_path / f"{number}.png"
        drawn = DrawnCase(
            type(case)(case.name, case.sign, case.balanced, case.forces, moved, case.stresses),
            np.zeros(0, bool),
            "",
        )
        plot_structure(path, loaded, [drawn], title="Arch", sign="holds", unit="m")
        pictures.append(path.read_bytes())
    assert pictures[0] == pictures[1]
    assert pictures[0] != pictures[2]


@pytest.mark.parametrize("kind", KINDS)
def test_a_browser_draws_it(kind: str, browser: Browser, tmp_path: Path) -> None:
    """Displaced, with what has the largest stress in the legend, no complaint."""
    document = arch(kind, strength=20e6).document
    loaded = document.loaded
    assert loaded is not None
    assert loaded.parts is not None
    (case,) = loaded.cases
    weaker = np.append(case.stresses[: len(loaded.panels)], 2 * case.stresses.max())
    stresses = np.zeros_like(case.stresses)
    stresses[: len(weaker)] = weaker
    cases = (replace(case, stresses=stresses),)
    write_html(
        tmp_path / "viewer.html",
        replace(document, loaded=replace(loaded, cases=cases)),
        DEFAULT_SETTINGS,
    )
    with watched_page(browser) as page:
        page.goto((tmp_path / "viewer.html").as_uri())
        wait_until(page, "window.orishell !== undefined")
        bare = pixels(page, ".stage canvas")
        page.get_by_test_id("load-case").select_option("weight")
        await_frames(page)
        used = 100 * 2 * case.stresses.max() / 20e6
        legend = page.locator(".orishell-legend").inner_text()
        assert (
            f"{float(f'{used:.3g}'):g} % of strength at most, in {loaded.parts.names[0]};" in legend
        )
        assert (
            float((np.abs(pixels(page, ".stage canvas") - bare).max(axis=-1) > 0.1).mean()) > 0.02
        )
