"""The paper's figures stay clear of themselves, in 40 states before the last one.

Sampled states, not the whole path; flaps touch in the last state, so it is left out.
"""

from pathlib import Path

import numpy as np
import pytest

from clearance import pierced
from orishell import FoldingMotion
from orishell.spec import read_design_file

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("figure", ["figure1", "figure2", "figure3"])
def test_no_panel_is_pierced_before_lock(figure: str) -> None:
    file = read_design_file(EXAMPLES / f"{figure}.toml")
    mechanism = file.pattern.design(file.f, file.g).mechanism
    for drive in FoldingMotion(mechanism, 41).drives[:-1]:
        assert not pierced(mechanism.positions(float(drive))), f"at drive {drive}"


def test_a_pierced_sheet_is_seen() -> None:
    # A strip of three panels rolled up: the third comes down through the first.
    x = np.array([0.0, 2.0, 2.0, 0.5])
    z = np.array([0.0, 0.0, 1.0, -1.0])
    strip = np.zeros((2, 4, 3))
    strip[..., 0], strip[..., 2] = x, z
    strip[1, :, 1] = -1.0
    strip[:, 3, 1] = [-0.3, -0.6]
    assert pierced(strip)
    strip[:, 3, 2] = 1.0
    assert not pierced(strip)
