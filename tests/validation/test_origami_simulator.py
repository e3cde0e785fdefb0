"""What Origami Simulator's "File Import Tips" ask of FOLD and SVG files, our files have.

Origami Simulator (Ghassaei, Demaine, Gershenfeld) runs in a browser's GPU only. Its page says
what it reads, and that it reads SVG with the FOLD format's own library, which is on npm ("fold",
0.12.0, MIT): so that library makes a pattern of the lines here, and rabbit-ear folds it.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from numpy.typing import NDArray

from documents import FAMILIES, demo_document
from node_tools import ask_node
from orishell.document import Document
from orishell.io.format import DEFAULT_SETTINGS
from orishell.io.formats.origami_simulator import write_origami_simulator
from rigid import distance_after_motion

Integers = NDArray[np.int64]

STROKES = {"#ff0000": "M", "#0000ff": "V", "#000000": "B", "#ffff00": "F"}
"""Red: mountains; blue: valleys; black: outline; yellow: lines of the triangulation, which the
tool keeps flat. Magenta (undriven) and green (cut) are for edges that no shell has."""

MERGED_PX = 3.0
"""Ends of lines that are nearer than this become one vertex, unless the user says otherwise."""

PLACE, ANGLE_DEG, SHAPE = 1e-7, 1e-5, 1e-6
"""How well the SVG gives points (of the diagonal) and angles, and the shell that these fold into.
Found for the shell: 4.5e-8."""

_ENDS = ("x1", "y1", "x2", "y2")


def test_fold_has_the_fields_that_are_asked_for(shell_files: Path) -> None:
    """It asks for these four lists, and takes fold angles from a fifth; it knows no J edges."""
    content = json.loads((shell_files / "shell.fold").read_text())
    vertices, edges = content["vertices_coords"], content["edges_vertices"]
    letters, angles = content["edges_assignment"], np.array(content["edges_foldAngle"])
    assert content["frame_classes"] == ["creasePattern"]
    assert {len(point) for point in vertices} == {2}
    assert set(np.ravel(edges)) == set(range(len(vertices)))
    assert set(np.ravel(content["faces_vertices"])) == set(range(len(vertices)))
    assert len(letters) == len(angles) == len(edges)
    assert set(letters) <= set("BMVF")
    signs = {"B": 0, "F": 0, "M": -1, "V": 1}
    np.testing.assert_array_equal(
        np.sign(np.where(np.abs(angles) < 1e-7, 0.0, angles)), [signs[name] for name in letters]
    )


def test_the_fold_library_finds_our_panels(shell_files: Path) -> None:
    """From vertices and edges alone, counter-clockwise; and its borders are our borders."""
    path = shell_files / "shell.fold"
    content = json.loads(path.read_text())
    found = ask_node("find_faces.cjs", {"path": str(path)})
    ours = zip(content["faces_vertices"], content["faces_edges"], strict=True)
    theirs = zip(found["faces_vertices"], found["faces_edges"], strict=True)
    assert {_from_lowest(*face) for face in theirs} == {_from_lowest(*face) for face in ours}
    borders = {
        frozenset(edge)
        for edge, letter in zip(content["edges_vertices"], content["edges_assignment"], strict=True)
        if letter == "B"
    }
    assert {frozenset(edge) for edge in found["borders"]} == borders


@pytest.mark.parametrize("family", FAMILIES)
def test_svg_has_strokes_and_opacities_as_asked_for(tmp_path: Path, family: str) -> None:
    """One line for each edge; the fold angle is 180° times the opacity."""
    document = demo_document(family)
    pattern = _read_lines(tmp_path, document)
    numbers = _find_vertices(pattern["vertices_coords"], document)
    theirs = {
        frozenset(numbers[edge].tolist()): (letter, angle)
        for edge, letter, angle in zip(
            pattern["edges_vertices"],
            pattern["edges_assignment"],
            pattern["edges_foldAngle"],
            strict=True,
        )
    }
    assert len(theirs) == len(pattern["edges_vertices"])
    assert theirs == {
        frozenset(edge): (letter, pytest.approx(angle, abs=ANGLE_DEG))
        for edge, letter, angle in zip(
            document.mesh.edges.tolist(),
            document.assignment,
            document.fold_angles_deg.tolist(),
            strict=True,
        )
    }


@pytest.mark.parametrize("family", FAMILIES)
def test_svg_folds_into_the_locked_shell(tmp_path: Path, family: str) -> None:
    """Read as lines and no more, they are our panels; folded, they are the shell."""
    document = demo_document(family)
    answer = ask_node("read_lines.cjs", _read_lines(tmp_path, document))
    assert len(answer["vertices_coords"]) == document.mesh.vertex_count
    assert len(answer["edges_vertices"]) == len(document.mesh.edges)
    numbers = _find_vertices(answer["vertices_coords"], document)
    found = {frozenset(numbers[face].tolist()) for face in answer["faces_vertices"]}
    assert found == {frozenset(face) for face in document.mesh.faces.tolist()}
    locked = document.shell.positions[numbers]
    distance = distance_after_motion(np.array(answer["folded"]), locked)
    assert distance <= SHAPE * _diagonal(document)


def _read_lines(directory: Path, document: Document) -> dict[str, Any]:
    """The lines of the SVG as a FOLD pattern, two vertices each, in the sheet's unit and axes."""
    path = directory / "pattern.origami-simulator.svg"
    write_origami_simulator(path, document, DEFAULT_SETTINGS)
    root = ET.fromstring(path.read_text())
    lines = [element for element in root if _tag(element) == "line"]
    others = {_tag(element) for element in root.iter() if element not in lines}
    assert others <= {"svg", "title", "desc"}
    assert not any({"transform", "style"} & set(element.attrib) for element in root.iter())
    points = np.array([[float(line.attrib[key]) for key in _ENDS] for line in lines])
    points = points.reshape(-1, 2) * [1.0, -1.0]  # an SVG's y axis points downwards
    flat = document.require_flat()
    scale = np.ptp(flat, axis=0) / np.ptp(points, axis=0)
    assert scale[0] == pytest.approx(scale[1], rel=PLACE)
    points = (points - points.min(axis=0)) * scale + flat.min(axis=0)
    letters = [STROKES[line.attrib["stroke"]] for line in lines]
    signs = np.array([{"M": -1.0, "V": 1.0}.get(letter, 0.0) for letter in letters])
    opacity = np.array([float(line.get("opacity", "1")) for line in lines])
    assert ((opacity >= 0) & (opacity <= 1)).all()
    return {
        "vertices_coords": points.tolist(),
        "edges_vertices": np.arange(len(points)).reshape(-1, 2).tolist(),
        "edges_assignment": letters,
        "edges_foldAngle": (180.0 * opacity * signs).tolist(),
        "epsilon": MERGED_PX * float(scale[0]),
    }


def _find_vertices(points: list[list[float]], document: Document) -> Integers:
    """Number (k,) of the sheet's vertex at which every point lies."""
    distances = np.linalg.norm(np.array(points)[:, None] - document.require_flat()[None], axis=-1)
    assert distances.min(axis=1).max() <= PLACE * _diagonal(document)
    numbers: Integers = distances.argmin(axis=1)
    return numbers


def _diagonal(document: Document) -> float:
    return float(np.linalg.norm(np.ptp(document.require_flat(), axis=0)))


def _tag(element: ET.Element) -> str:
    return element.tag.rpartition("}")[2]


def _from_lowest(vertices: list[int], edges: list[int]) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """A face begun at its lowest vertex; its edges begin with the one that leaves it."""
    start = vertices.index(min(vertices))
    return tuple(vertices[start:] + vertices[:start]), tuple(edges[start:] + edges[:start])
