"""Contact in states of a motion that is followed: where it is known by hand."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.clash.sampled import NARROW, look_for_contact
from orishell.motion.following import follow
from patterns import SAMPLES, of_loops

SQUARES = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6]]
STRIP = np.array([[x, y] for y in (0.0, 1.0) for x in (-1.0, 0.0, 1.0, 2.0)])
TIPS = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 0.5], [2.0, 0.5]])
HEXAGONS = np.array([[-1.0, 0.2], [-1.0, 0.8], [2.0, 0.2], [2.0, 0.8], [-0.5, 0.0], [-0.5, 1.0]])


@pytest.mark.parametrize(
    ("vertices", "loops", "pair"),
    [
        (STRIP, SQUARES, (0, 2)),
        (TIPS, [[0, 1, 2, 3], [3, 4, 0], [1, 5, 2]], (1, 2)),
        (
            np.vstack([TIPS[:4], HEXAGONS]),
            [[3, 9, 5, 4, 8, 0], [0, 1, 2, 3], [1, 6, 7, 2]],
            (0, 2),
        ),
    ],
    ids=["squares", "triangles", "hexagon"],
)
def test_two_flaps_that_meet(
    vertices: np.ndarray, loops: list[list[int]], pair: tuple[int, int]
) -> None:
    """Flaps as long as the panel between them is wide, both folded by t: their tips are at
    -cos t and 1 + cos t, and meet at cos t = -1/2."""
    motion = follow(of_loops(vertices, loops, lambda a, b: "V"), states=11)
    seen = look_for_contact(motion)
    assert seen.panels == pair
    assert seen.met is not None
    assert seen.clear < np.deg2rad(120) - 1e-9 < seen.met < seen.clear + NARROW
    assert seen.states == 7  # 18 degrees apart, so that it is first seen at 126


@pytest.mark.parametrize("name", ["Miura", "waterbomb"])
def test_none_before_the_end(name: str) -> None:
    """A Miura sheet closes without contact, and so do the squares of a waterbomb's first folds."""
    motion = follow(SAMPLES[name].make(), largest=np.pi if name == "Miura" else 1.0, states=9)
    seen = look_for_contact(motion)
    assert (seen.met, seen.panels) == (None, None)
    assert seen.states == (7 if name == "Miura" else 8)
    assert seen.apart == pytest.approx((np.pi if name == "Miura" else 1.0) / 8)
