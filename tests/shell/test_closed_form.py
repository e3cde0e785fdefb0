"""Two ways to one motion: followed from all vertices at once, and in closed form along a cross."""

from __future__ import annotations

import numpy as np
import pytest

from orishell.motion.following import follow
from orishell.shell.closed_form import in_closed_form
from patterns import CHANGES, SAMPLES
from samples import led_by

GRIDS = ["orthodiagonal", "longitudinal", "Huffman's grid", "flat-foldable", "parallel repeating"]


@pytest.mark.parametrize("name", led_by(GRIDS, 3))
@pytest.mark.parametrize("change", ["shuffled", "mirrored"])
def test_both_ways_agree(name: str, change: str) -> None:
    """Neither knows of the other; 2e-13 was seen."""
    motion = follow(CHANGES[change](SAMPLES[name].make()), states=7)
    exact = in_closed_form(motion)
    assert exact is not None
    assert np.abs(exact.folds - motion.folds).max() < 2e-12
    assert exact.residuals.max() < 2e-13
    assert (exact.folds[0] == 0).all()


def test_none_where_there_is_none() -> None:
    """Triangles make no grid."""
    assert in_closed_form(follow(SAMPLES["Yoshimura"].make(), largest=1.0, states=3)) is None
