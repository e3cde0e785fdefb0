"""Rhino 3dm, read back by rhino3dm."""

from collections import defaultdict
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from documents import FAMILIES, demo_document, flat_only, folded_only
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.rhino import write_rhino
from orishell.motion.mesh import build_mesh

DEMO = demo_document()
Objects = dict[str, dict[str, Any]]


def read(path: Path, document: Document, state: int | str = "target") -> tuple[Any, Objects]:
    """The file, and its objects by layer and name."""
    import rhino3dm

    write_rhino(path / "shell.3dm", document, Settings(state=state))
    file: Any = rhino3dm.File3dm.Read(str(path / "shell.3dm"))
    assert file is not None
    found: Objects = defaultdict(dict)
    for entry in file.Objects:
        assert entry.Geometry.IsValid
        found[file.Layers[entry.Attributes.LayerIndex].FullPath][entry.Attributes.Name] = entry
    return file, found


def coordinates(point: Any) -> list[float]:
    return [point.X, point.Y, point.Z]


def polyline(entry: Any) -> NDArray[np.float64]:
    curve = entry.Geometry
    return np.array([coordinates(curve.Point(k)) for k in range(curve.PointCount)])


@pytest.mark.parametrize("family", FAMILIES)
def test_shell_as_mesh_and_as_panels(family: str, tmp_path: Path) -> None:
    document = demo_document(family)
    _, found = read(tmp_path, document)
    mesh = found["shell::mesh"]["shell"].Geometry
    points = [coordinates(mesh.Vertices.Point3dAt(k)) for k in range(len(mesh.Vertices))]
    np.testing.assert_array_equal(points, document.shell.positions)
    np.testing.assert_array_equal(
        [mesh.Faces[k] for k in range(len(mesh.Faces))], document.mesh.faces
    )
    corners = document.shell.positions[document.mesh.faces]
    panels = found["shell::panels"]
    assert list(panels) == [f"panel {document.panel_name(k)}" for k in range(len(corners))]
    for entry, (a, b, c, d) in zip(panels.values(), corners, strict=True):
        surface = entry.Geometry
        (u, end_u), (v, end_v) = ((i.T0, i.T1) for i in (surface.Domain(0), surface.Domain(1)))
        found_corners = [(u, v), (end_u, v), (end_u, end_v), (u, end_v)]
        np.testing.assert_array_equal(
            [coordinates(surface.PointAt(*place)) for place in found_corners], [a, b, c, d]
        )
        assert surface.IsPlanar(1e-9)


@pytest.mark.parametrize("family", FAMILIES)
def test_pattern_on_layers(family: str, tmp_path: Path) -> None:
    document = demo_document(family)
    flat = document.require_flat()
    _, found = read(tmp_path, document)
    layers = {"M": "MOUNTAIN", "V": "VALLEY", "F": "ENGRAVE"}
    for letter, layer in layers.items():
        numbers = [e for e, has in enumerate(document.assignment) if has == letter]
        lines = found[f"flat pattern::{layer}"]
        assert list(lines) == [f"crease {number}" for number in numbers]
        for number, entry in zip(numbers, lines.values(), strict=True):
            ends = [
                coordinates(entry.Geometry.PointAtStart),
                coordinates(entry.Geometry.PointAtEnd),
            ]
            np.testing.assert_array_equal(
                ends, np.column_stack([flat[document.mesh.edges[number]], [0, 0]])
            )
            angle = float(entry.Attributes.GetUserString("fold_angle_deg"))
            assert angle == document.fold_angles_deg[number]
    (outline,) = found["flat pattern::CUT"].values()
    assert outline.Geometry.IsClosed
    points = polyline(outline)
    assert not points[:, 2].any()
    assert len(points) - 1 == document.assignment.count("B")
    (x, y), (after_x, after_y) = points[:-1, :2].T, points[1:, :2].T
    area = (x * after_y - after_x * y).sum() / 2
    assert area == pytest.approx(document.areas().sum(), rel=1e-12)


def test_curves(tmp_path: Path) -> None:
    _, found = read(tmp_path, DEMO)
    for name in ("f", "g"):
        np.testing.assert_array_equal(polyline(found[f"target::{name}"][name]), DEMO.curves[name])


@pytest.mark.parametrize(
    ("unit", "system"),
    [
        ("mm", "Millimeters"),
        ("cm", "Centimeters"),
        ("m", "Meters"),
        ("in", "Inches"),
        ("ft", "Feet"),
        ("unit", "None"),
    ],
)
def test_unit(unit: str, system: str, tmp_path: Path) -> None:
    file, _ = read(tmp_path, replace(flat_only(DEMO), unit=unit))
    assert file.Settings.ModelUnitSystem.name == system
    assert f"Unit: {unit}. Up: z." in file.StartSectionComments


def test_flat_sheet_alone(tmp_path: Path) -> None:
    _, found = read(tmp_path, flat_only(DEMO))
    mesh = found["shell::mesh"]["shell"].Geometry
    assert {mesh.Vertices.Point3dAt(k).Z for k in range(len(mesh.Vertices))} == {0.0}
    assert not any(layer.startswith("target") for layer in found)


def test_states_alone(tmp_path: Path) -> None:
    folded = folded_only(DEMO)
    _, found = read(tmp_path, folded, state=1)
    assert set(found) == {"shell::mesh", "shell::panels"}
    vertex = found["shell::mesh"]["shell"].Geometry.Vertices.Point3dAt(5)
    assert coordinates(vertex) == folded.states[1].positions[5].tolist()


def test_cuts_inside_and_a_panel_with_a_corner_inwards(tmp_path: Path) -> None:
    """A square and a dart that meet in a slit; the dart's area, 4, is by hand."""
    flat = np.array([[0.0, 0], [4, 0], [4, 4], [3, 1], [4, -4], [0, -4]])
    mesh = build_mesh(np.array([[0, 1, 2, 3], [0, 5, 4, 1]]), 6)
    slit = [set(edge) == {0, 1} for edge in mesh.edges.tolist()]
    document = replace(
        flat_only(DEMO),
        mesh=mesh,
        flat=flat,
        grid_shape=None,
        assignment=tuple("C" if cut else "B" for cut in slit),
        fold_angles_deg=np.zeros(len(slit)),
    )
    _, found = read(tmp_path, document)
    assert list(found["flat pattern::CUT"]) == ["outline 0", f"cut {slit.index(True)}"]
    dart = found["shell::panels"]["panel 0"].Geometry
    assert len(dart.Edges) == 4
    ends = {tuple(coordinates(edge.PointAtStart)) for edge in dart.Edges}
    assert ends == {(*point, 0.0) for point in flat[:4].tolist()}


def test_a_joined_edge_is_no_cut(tmp_path: Path) -> None:
    letters = list(DEMO.assignment)
    edge = letters.index("M")
    letters[edge] = "J"
    _, found = read(tmp_path, replace(DEMO, assignment=tuple(letters)))
    assert f"crease {edge}" in found["flat pattern::ENGRAVE"]
    assert list(found["flat pattern::CUT"]) == ["outline 0"]


def test_no_clock(tmp_path: Path) -> None:
    file, _ = read(tmp_path, DEMO)
    assert file.Created == file.LastEdited == datetime(1970, 1, 1)


def test_no_path(tmp_path: Path) -> None:
    read(tmp_path, DEMO)
    data = (tmp_path / "shell.3dm").read_bytes()
    for encoding in ("utf-8", "utf-16-le"):
        assert "shell.3dm".encode(encoding) not in data
