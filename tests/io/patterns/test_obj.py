"""OBJ files of panels, folded or flat, as programs that fold save them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.io import read_pattern
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following import follow
from orishell.motion.following.placing import Placing
from orishell.numerics.arrays import Array
from patterns import SAMPLES, Sample, miura


def obj(path: Path, points: Array, pattern: CreasePattern, corner: str = "{}") -> Path:
    lines = ["# a state", *("v {!r} {!r} {!r}".format(*row) for row in points.tolist())]
    for loop in pattern.faces.tolist():
        lines.append("f " + " ".join(corner.format(each + 1) for each in loop if each >= 0))
    path.write_text("\n".join(lines) + "\n")
    return path


def lettered(pattern: CreasePattern) -> dict[tuple[int, int], str]:
    """The letter of each edge, by its vertices."""
    ends = np.sort(pattern.edges, axis=1).tolist()
    return {(a, b): letter for (a, b), letter in zip(ends, pattern.letters.tolist(), strict=True)}


@pytest.mark.parametrize("name", ["Miura", "Yoshimura", "waterbomb"])
def test_a_folded_state_is_laid_out_with_its_mountains_and_valleys(
    name: str, tmp_path: Path
) -> None:
    sample: Sample = SAMPLES[name]
    pattern = sample.make()
    folds = follow(pattern, largest=1.0, states=2).folds[-1]
    folded, _ = Placing(pattern).placed(folds)
    found = read_pattern(obj(tmp_path / "folded.obj", folded, pattern, "{}/1/1"))
    assert found.flat is not None
    assert any("laid out" in note for note in found.notes)
    assert lettered(found.flat) == lettered(pattern)
    lengths = [
        np.linalg.norm(np.diff(each.vertices[pattern.edges], axis=1)[:, 0], axis=-1)
        for each in (found.flat, pattern)
    ]
    np.testing.assert_allclose(lengths[0], lengths[1], rtol=1e-9)
    assert len(found.states) == 1


def test_a_flat_sheet_that_stands_is_seen_from_where_y_is_up(tmp_path: Path) -> None:
    pattern = miura()
    x, y = pattern.vertices.T
    standing = np.stack([x, np.full_like(x, 3.0), -y], axis=-1)
    found = read_pattern(obj(tmp_path / "flat.obj", standing, pattern))
    assert found.flat is not None
    np.testing.assert_allclose(found.flat.vertices, pattern.vertices, atol=1e-12)
    assert not found.states
    assert set(found.flat.letters.tolist()) == {"B", "U"}


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no panels.*save the sheet with its faces"),
        ("v 0 0 0\nv 1 x 0\n", "line 2.*not OBJ"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "no such vertex"),
    ],
)
def test_what_is_none_is_refused_by_place(content: str, says: str, tmp_path: Path) -> None:
    path = tmp_path / "broken.obj"
    path.write_text(content)
    with pytest.raises(InputError, match=says):
        read_pattern(path)
