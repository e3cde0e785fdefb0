"""Good sheets pass whoever wrote them and in whatever order, and what is not tested is said."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.design_file import read_design_file
from orishell.document.from_design import document_of_motion
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.io import write_fold
from orishell.motion import FoldingMotion
from sheets import facts, failed, inspect, miura, shuffled, strip
from strategies import graph

EXAMPLES = Path(__file__).parents[2] / "examples"
ALL = {
    "convex",
    "flat",
    "developable",
    "panel_length",
    "planarity",
    "fold_angle",
    "assignment",
    "constant_sign",
    "maekawa",
    "clash",
}
BETWEEN = "contact between frames: only the states in the file are tested"


def figure(number: int, directory: Path, frames: int) -> dict[str, Any]:
    """One of the paper's figures as our design command writes it, with few frames."""
    file = read_design_file(EXAMPLES / f"figure{number}.toml")
    motion = FoldingMotion(file.pattern.design(file.f, file.g).mechanism, frames)
    write_fold(directory / "shell.fold", document_of_motion(motion, file.unit))
    content: dict[str, Any] = json.loads((directory / "shell.fold").read_text())
    return content


@pytest.mark.parametrize("number", [1, 2, 3])
def test_the_figures_pass_every_test(number: int, tmp_path: Path) -> None:
    inspection = inspect(figure(number, tmp_path, 6), tmp_path)
    assert inspection.passed
    assert {check.name for check in inspection.checks} == ALL
    # Rounding only: a millionth of what the tolerance lets pass.
    for name in ("flat", "developable", "panel_length", "planarity", "fold_angle"):
        assert facts(inspection, name)["worst"] < 1e-12
    report = inspection.as_dict()
    assert report["flat_frame"] == 0
    assert report["frames"] == [0, 1, 2, 3, 4, 5, 6]
    assert report["turned_panels"] == 0
    assert BETWEEN in report["not_checked"]
    json.dumps(report, allow_nan=False)
    # The first two are locked by their flaps, which touch by design; the third stops before.
    at_end = facts(inspection, "clash")["contacts_at_end"]
    assert [contacts["frame"] for contacts in at_end] == ([6] if number < 3 else [])


@pytest.mark.parametrize("seed", range(5))
def test_the_order_of_vertices_edges_and_panels_does_not_matter(seed: int, tmp_path: Path) -> None:
    fold = figure(1, tmp_path, 3)
    before, after = inspect(fold, tmp_path), inspect(shuffled(fold, seed), tmp_path)
    assert after.passed
    assert {check.name for check in after.checks} == ALL
    first, second = before.as_dict(), after.as_dict()
    for key in ("panels", "vertices", "creases", "inner_vertices", "not_checked", "flat_frame"):
        assert first[key] == second[key]
    assert second["turned_panels"] > 0
    pairs = [len(facts(each, "clash")["contacts_at_end"][0]["pairs"]) for each in (before, after)]
    assert pairs[0] == pairs[1]
    # A fault is found there too: one flap's crease called mountain instead of valley.
    edge = fold["edges_assignment"].index("V")
    fold["edges_assignment"][edge] = "M"
    vertices = set(fold["edges_vertices"][edge])
    assert failed(inspect(fold, tmp_path)) == {"assignment", "maekawa"}
    mixed = shuffled(fold, seed)
    inspection = inspect(mixed, tmp_path)
    assert failed(inspection) == {"assignment", "maekawa"}
    found = facts(inspection, "assignment")["vertices"]
    same = np.array(mixed["vertices_coords"])[found].tolist()
    assert sorted(same) == sorted(fold["vertices_coords"][vertex] for vertex in vertices)


def test_all_panels_the_other_way_round(tmp_path: Path) -> None:
    fold = figure(2, tmp_path, 3)
    fold["faces_vertices"] = [face[::-1] for face in fold["faces_vertices"]]
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    assert inspection.as_dict()["turned_panels"] == len(fold["faces_vertices"])


def test_the_size_and_the_place_do_not_matter(tmp_path: Path) -> None:
    fold = miura([0.4, 1.1])
    for frame in (fold, *fold["file_frames"]):
        coords = 1e-20 * np.array(frame["vertices_coords"])
        frame["vertices_coords"] = coords.tolist()
    assert inspect(fold, tmp_path).passed
    for frame in (fold, *fold["file_frames"]):
        frame["vertices_coords"] = (1e50 * np.array(frame["vertices_coords"]) + 1e29).tolist()
    assert inspect(fold, tmp_path).passed


def test_a_textbook_miura_sheet_by_another_program(tmp_path: Path) -> None:
    # Complete frames without inheritance or classes; fold angles from the textbook's relation.
    inspection = inspect(miura([0.0, 0.3, 0.8, 1.2, 1.5]), tmp_path)
    assert inspection.passed
    assert {check.name for check in inspection.checks} == ALL
    assert inspection.not_checked == (BETWEEN,)
    assert facts(inspection, "fold_angle")["worst"] < 1e-13
    for seed in range(3):
        assert inspect(shuffled(miura([0.3, 1.2]), seed), tmp_path).passed


def test_the_key_frame_may_be_the_folded_form(tmp_path: Path) -> None:
    fold = miura([0.7])
    folded, flat = fold["file_frames"][0], {"vertices_coords": fold["vertices_coords"]}
    flat |= {"frame_parent": 0, "frame_inherit": True, "frame_classes": ["creasePattern"]}
    inspection = inspect({**folded, "file_frames": [flat]}, tmp_path)
    assert inspection.passed
    assert inspection.sheet.frame.number == 1
    assert inspection.sheet.flat
    assert {check.name for check in inspection.checks} == ALL


def test_whole_numbers_and_the_fewest_keys(tmp_path: Path) -> None:
    # A strip of three squares, flat and then a U.
    fold = strip([[0, 0], [1, 0], [2, 0], [3, 0]], [[0, 1], [0, 0], [1, 0], [1, 1]])
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    assert {check.name for check in inspection.checks} == {
        "convex",
        "flat",
        "panel_length",
        "planarity",
        "constant_sign",
        "clash",
    }
    assert inspection.not_checked == (
        "developability (no inner vertices)",
        "fold angles of frame 1 (no edges_foldAngle of their own)",
        "mountains and valleys (no edges_assignment)",
        BETWEEN,
    )


def test_a_pattern_alone(tmp_path: Path) -> None:
    fold = miura([])
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    assert inspection.not_checked == (
        "folded states (the file has none): rigid panels, fold angles, contact",
        BETWEEN,
    )
    assert {"fold_angle", "panel_length", "constant_sign"}.isdisjoint(
        {check.name for check in inspection.checks}
    )


def test_folded_states_alone(tmp_path: Path) -> None:
    fold = miura([0.4, 0.9])
    first, second = fold["file_frames"]
    inspection = inspect({**first, "file_frames": [second]}, tmp_path)
    assert inspection.passed
    assert inspection.as_dict()["flat_frame"] is None
    assert "flat" not in {check.name for check in inspection.checks}
    assert any(text.startswith("the flat sheet (the file has none)") for text in
               inspection.not_checked)  # fmt: skip


def test_not_a_grid(tmp_path: Path) -> None:
    # Three rhombi around a vertex of degree three: a hexagon.
    ring = [[np.cos(k * np.pi / 3), np.sin(k * np.pi / 3)] for k in range(6)]
    fold = {
        "vertices_coords": [[0, 0], *ring],
        "faces_vertices": [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]],
    }
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    assert inspection.as_dict()["inner_vertices"] == 1


def test_loose_vertices_and_dangling_edges(tmp_path: Path) -> None:
    fold = miura([0.5])
    for frame in (fold, *fold["file_frames"]):
        width = len(frame["vertices_coords"][0])
        frame["vertices_coords"] = [*frame["vertices_coords"], width * [1e6]]
        frame["edges_vertices"] = [*frame["edges_vertices"], [0, 30]]
        frame["edges_assignment"] = [*frame["edges_assignment"], "U"]
    fold["file_frames"][0]["edges_foldAngle"].append(0)
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    assert inspection.sheet.diagonal < 20
    assert "1 edges that belong to no panel" in inspection.not_checked


def test_the_tolerance_decides(tmp_path: Path) -> None:
    fold = miura([0.5])
    rounded = np.round(fold["file_frames"][0]["vertices_coords"], 4).tolist()
    fold["file_frames"][0]["vertices_coords"] = rounded
    assert "panel_length" in failed(inspect(fold, tmp_path))
    assert inspect(fold, tmp_path, tolerance=1e-4).passed


@pytest.mark.parametrize("tolerance", [0.0, -1e-6, np.nan, np.inf])
def test_tolerances_that_are_none(tolerance: float, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="a finite number greater than 0"):
        inspect(miura([]), tmp_path, tolerance=tolerance)


def test_extreme_tolerances_do_no_harm(tmp_path: Path) -> None:
    for tolerance in (1e300, 1.0, 1e-20, 5e-324):
        inspection = inspect(miura([0.5]), tmp_path, tolerance=tolerance)
        assert not inspection.passed
        json.dumps(inspection.as_dict(), allow_nan=False)


@pytest.mark.parametrize(
    ("coords", "says"),
    [
        ([[0, 0], [1, 0], [2, 0], [3, 0]], "frame 0 panel 0: a panel has no area"),
        ([[0, 0], [1, 0], [0, 1], [1, 1]], "a panel has no area, or crosses itself"),
        (4 * [[5, 5]], "the sheet has no size; got a bounding box of diagonal 0"),
    ],
)
def test_panels_that_are_none(coords: list[list[int]], says: str, tmp_path: Path) -> None:
    fold = {"vertices_coords": coords, "faces_vertices": [[0, 1, 2, 3]]}
    with pytest.raises(InputError) as error:
        inspect(fold, tmp_path)
    assert says in str(error.value)


def test_progress_sees_every_frame(tmp_path: Path) -> None:
    seen: list[tuple[float, str]] = []
    inspect(miura([0.1, 0.2]), tmp_path, progress=lambda *told: seen.append(told))
    assert seen == [(1 / 3, "checking"), (2 / 3, "checking"), (1, "checking")]


def test_our_own_pattern_with_all_its_names(tmp_path: Path) -> None:
    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("x**2/30", 0, 10),
        ParallelRepeatingPattern(rows=3, columns=4, xi_deg=np.rad2deg(0.8), flap=0.3),
    )
    motion = FoldingMotion(design.mechanism, 3)
    write_fold(tmp_path / "shell.fold", document_of_motion(motion, "m"))
    fold = json.loads((tmp_path / "shell.fold").read_text())
    # The second frame lifts the vertex in row 2, column 3 of 5 x 6.
    fold["file_frames"][1]["vertices_coords"][2 * 6 + 3][2] += 0.01
    inspection = inspect(fold, tmp_path)
    place = facts(inspection, "developable")
    assert (place["frame"], place["grid"]) in [
        (2, [row, column]) for row in (1, 2, 3) for column in (2, 3, 4)
    ]
    assert facts(inspection, "planarity")["grid"] in [[1, 2], [1, 3], [2, 2], [2, 3]]
