from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from documents import FAMILIES, demo_document, folded_only
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.origami_simulator import write_origami_simulator

STROKES = {
    "#000000": "B",
    "#ff0000": "M",
    "#0000ff": "V",
    "#00ff00": "C",
    "#ffff00": "F",  # and J, a joined edge: both do not fold
    "#ff00ff": "U",
}
"""As Origami Simulator's file import tips name them."""

MERGED_PX = 3.0
"""Its importer merges vertices that are nearer than this."""


def lines_of(path: Path, document: Document) -> list[dict[str, str]]:
    write_origami_simulator(path, document, Settings())
    title, *lines = ElementTree.parse(path).getroot()
    assert title.tag.endswith("}title")
    assert {line.tag for line in lines} == {"{http://www.w3.org/2000/svg}line"}
    return [line.attrib for line in lines]


def ends_of(lines: list[dict[str, str]]) -> np.ndarray:
    return np.array(
        [[[float(line[f"{axis}{end}"]) for axis in "xy"] for end in (1, 2)] for line in lines]
    )


@pytest.mark.parametrize("family", FAMILIES)
def test_every_edge_is_one_line_with_its_assignment_and_fold_angle(
    family: str, tmp_path: Path
) -> None:
    document = demo_document(family)
    lines = lines_of(tmp_path / "pattern.svg", document)
    assert tuple(STROKES[line["stroke"]] for line in lines) == document.assignment
    for line, letter, angle in zip(
        lines, document.assignment, document.fold_angles_deg, strict=True
    ):
        if letter in "MV":
            assert 180 * float(line["opacity"]) == pytest.approx(abs(angle), rel=1e-8)
        else:
            assert "opacity" not in line


@pytest.mark.parametrize("family", FAMILIES)
def test_it_is_similar_to_the_sheet_and_its_vertices_are_not_merged(
    family: str, tmp_path: Path
) -> None:
    document = demo_document(family)
    ends = ends_of(lines_of(tmp_path / "pattern.svg", document)) * [1, -1]
    flat = document.require_flat()[document.mesh.edges]
    scale = np.ptp(ends[..., 0]) / np.ptp(flat[..., 0])
    shift = ends[0, 0] - scale * flat[0, 0]
    np.testing.assert_allclose(ends, scale * flat + shift, atol=1e-5)
    vertices = scale * document.require_flat()
    apart = np.hypot(*np.moveaxis(vertices[:, None] - vertices, -1, 0))
    np.fill_diagonal(apart, np.inf)
    assert apart.min() > MERGED_PX
    assert max(np.ptp(ends[..., 0]), np.ptp(ends[..., 1])) >= 599.99


def test_creases_that_are_not_assigned_or_cut_have_their_own_colours(tmp_path: Path) -> None:
    document = demo_document()
    crease = np.flatnonzero(document.mesh.crease)[:4]
    letters = list(document.assignment)
    for edge, letter in zip(crease, "UCFJ", strict=True):
        letters[edge] = letter
    lines = lines_of(tmp_path / "pattern.svg", replace(document, assignment=tuple(letters)))
    strokes = ["#ff00ff", "#00ff00", "#ffff00", "#ffff00"]
    assert [lines[edge]["stroke"] for edge in crease] == strokes


def test_unknown_fold_angles_have_no_opacity(tmp_path: Path) -> None:
    document = demo_document()
    unknown = np.full(len(document.assignment), np.nan)
    lines = lines_of(tmp_path / "pattern.svg", replace(document, fold_angles_deg=unknown))
    assert not any("opacity" in line for line in lines)


def test_folded_states_alone_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no flat sheet"):
        lines_of(tmp_path / "pattern.svg", folded_only(demo_document()))
