"""Folded states of triangles and hexagons, right ones, and with one thing wrong at a time."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.io import read_pattern
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following import follow
from orishell.motion.following.placing import Placing
from orishell.numerics.arrays import Array
from orishell.verification.pattern import judge_pattern
from patterns import fold_of, of_loops

TIPS = np.exp(1j * np.deg2rad(60 * np.arange(6)))
HEXAGON = of_loops(
    np.vstack([[0.0, 0.0], np.stack([TIPS.real, TIPS.imag], axis=1)]),
    [[0, 1 + k, 1 + (k + 1) % 6] for k in range(6)],
    lambda a, b: "MV"[b % 2] if a == 0 else "B",
)
Content = dict[str, Any]


Rows = dict[str, tuple[str, str]]


def triangles(change: Callable[[Content], None], place: Path) -> Rows:
    """The verdict on six triangles about a vertex in two folded states, a crease at 1 and 2 rad."""
    return rows_of(HEXAGON, follow(HEXAGON, largest=2.0, states=3).folds[1:], change, place)


def rows_of(
    pattern: CreasePattern, states: Array, change: Callable[[Content], None], place: Path
) -> Rows:
    content = fold_of(pattern)
    content["file_frames"] = [
        {
            "frame_classes": ["foldedForm"],
            "frame_parent": 0,
            "frame_inherit": True,
            "vertices_coords": Placing(pattern).placed(folds)[0].tolist(),
            "edges_foldAngle": np.rad2deg(folds).tolist(),
        }
        for folds in states
    ]
    change(content)
    path = place / "states.fold"
    path.write_text(json.dumps(content))
    verdict = judge_pattern(read_pattern(path))
    return {row.subject: (row.sign, row.finding) for row in verdict.rows}


def test_states_that_are_what_they_say(tmp_path: Path) -> None:
    rows = triangles(lambda content: None, tmp_path)
    for subject in ("shape", "planes", "angles", "contact"):
        assert rows[subject][0] == "holds", rows
    assert "states" not in rows


def longer(content: Content) -> None:
    content["file_frames"][0]["vertices_coords"][1][0] += 1e-3


def other_angle(content: Content) -> None:
    content["file_frames"][1]["edges_foldAngle"][0] += 0.1


def other_letters(content: Content) -> None:
    swapped = {"M": "V", "V": "M", "B": "B"}
    content["edges_assignment"] = [swapped[each] for each in content["edges_assignment"]]


@pytest.mark.parametrize(
    ("change", "subject"),
    [(longer, "shape"), (other_angle, "angles"), (other_letters, "letters")],
)
def test_what_is_wrong_is_told(
    change: Callable[[Content], None], subject: str, tmp_path: Path
) -> None:
    assert triangles(change, tmp_path)[subject][0] == "fails"


FLAPS = of_loops(
    np.array(
        [
            *([0, 0], [1, 0], [1, 1], [0, 1], [-1, 0.2], [-1, 0.8], [-0.5, 0], [-0.5, 1]),
            *([2, 0.2], [2, 0.8], [1.5, 0], [1.5, 1.0]),
        ]
    ),
    [[0, 1, 2, 3], [3, 7, 5, 4, 6, 0], [1, 10, 8, 9, 11, 2]],
    lambda a, b: "V" if (a, b) in ((0, 3), (1, 2)) else "B",
)
"""Two hexagons, 1 long, beside a square: folded evenly they meet at 120 degrees."""


def folded(*degrees: float) -> Array:
    return np.outer(np.deg2rad(degrees), FLAPS.signs == 1)


def bent(content: Content) -> None:
    content["file_frames"][0]["vertices_coords"][4][0] += 1e-3


def test_panels_that_meet_are_told(tmp_path: Path) -> None:
    def same(content: Content) -> None:
        pass

    assert rows_of(FLAPS, folded(60, 119), same, tmp_path)["contact"][0] == "holds"
    assert rows_of(FLAPS, folded(119, 120), same, tmp_path)["contact"][0] == "holds"
    for degrees in ((120, 119), (60, 125)):
        assert rows_of(FLAPS, folded(*degrees), same, tmp_path)["contact"][0] == "fails"


def test_a_bent_panel_is_told(tmp_path: Path) -> None:
    """The flaps stand upright: across them is along x."""
    rows = rows_of(FLAPS, folded(90, 100), bent, tmp_path)
    assert rows["planes"][0] == "fails"
    assert rows["contact"][0] == "warns"
