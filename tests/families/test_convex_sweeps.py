"""A family that needs a convex f gets one, also of surfaces that curve both ways."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from orishell.design_file.file import check_design
from orishell.shell.designed import designed
from samples import led_by

SURFACES = ["(x**2 - y**2)/4", "(x**2 - y**2)*0.15", "x**2/5 - y**2/10", "x**2/5 - cos(4*y)/20"]
"""The nearest convex cylinders bend little at their ends; through 21 points, splines turned back
over the first, by 49 degrees."""


@pytest.mark.parametrize("formula", led_by(SURFACES))
def test_the_f_nearest_to_a_surface_is_convex(formula: str) -> None:
    tables = {
        "shell": {"family": "longitudinal-linear-repeating", "unit": "m"},
        "target": {"surface": {"formula": formula, "x": [-1, 1], "y": [-1, 1]}},
        "pattern": {"rows": 7, "columns": 7, "sector_deg": "auto"},
    }
    design = designed(check_design(tables, Path("roof.toml"), files=False))
    points = np.array(design.by_curves["target.f.points"])
    turns = np.diff(np.diff(points[:, 1]) / np.diff(points[:, 0]))
    assert (np.sign(turns) == np.sign(turns[0])).all()
