"""The crease pattern as a record, against what is known by hand of the patterns of the tests."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.numerics.arrays import Booleans
from patterns import CHANGES, SAMPLES, Sample, miura

ROUNDING = 1e-12
"""Of angles (radians): 20 times what was seen."""


def failing(pattern: CreasePattern) -> Booleans:
    """Inner vertices (I,) where alternate sectors differ, or folds are not two more of one sort."""
    creases, _ = pattern.fans
    sectors = np.nan_to_num(pattern.sectors)
    alternating = (sectors * (-1.0) ** np.arange(sectors.shape[1])).sum(axis=1)
    folds = np.where(creases >= 0, pattern.signs[creases], 0.0).sum(axis=1)
    fine = (np.abs(alternating) < ROUNDING) & (np.abs(folds) == 2)
    return np.asarray(~fine, dtype=np.bool_)


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("sample", SAMPLES.values(), ids=SAMPLES)
def test_samples_are_as_known_by_hand(sample: Sample, change: str) -> None:
    pattern = CHANGES[change](sample.make())
    assert len(pattern.inner) == sample.inner
    sums = np.nansum(pattern.sectors, axis=1)
    np.testing.assert_allclose(sums, 2 * np.pi, atol=ROUNDING)
    if sample.failing is not None:
        assert failing(pattern).sum() == sample.failing
    # Euler: panels inside one border, with or without a hole.
    euler = len(pattern.vertices) - len(pattern.edges) + len(pattern.faces)
    assert euler == (0 if "hole" in next(k for k, v in SAMPLES.items() if v is sample) else 1)


def test_panels_go_counter_clockwise_with_themselves_to_the_left_of_their_sides() -> None:
    pattern = miura()
    backwards = pattern.faces[:, ::-1]
    again = pattern_of_panels(pattern.vertices, backwards, pattern.edges, pattern.letters)
    np.testing.assert_array_equal(again.edge_faces, pattern.edge_faces)
    for edge, (left, right) in zip(again.edges, again.edge_faces, strict=True):
        for face, way in ((left, edge), (right, edge[::-1])):
            if face >= 0:
                loop = again.faces[face].tolist()
                assert loop[(loop.index(way[0]) + 1) % 4] == way[1]


def test_panels_on_each_other_or_without_an_area_are_refused_by_number() -> None:
    vertices = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0]])
    with pytest.raises(InputError, match="panels 0 and 1 lie on the same side of their edge 0-1"):
        pattern_of_panels(vertices, np.array([[0, 1, 2], [0, 1, 3]]))
    with pytest.raises(InputError, match="panel 1 has no area"):
        pattern_of_panels(vertices, np.array([[1, 2, 3], [0, 4, 1]]))
