"""Smooth surfaces of one sign of curvature: a shell that passes all checks, or a reason."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from orishell.conventions.errors import DesignError
from orishell.design_file import read_design_file
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from samples import led_by


def design_file(seed: int, panels: int, more: str) -> str:
    """A quadric with a little of third order, over a rectangle."""
    rng = np.random.default_rng(seed)
    sign = rng.choice([1, -1])
    first, second = rng.uniform(0.2, 1), sign * rng.uniform(0.2, 1)
    turn, half, up = rng.uniform(0, np.pi), rng.uniform(0.5, 1.0), rng.choice([1, -1])
    a, b, c, d = 0.1 * rng.standard_normal(4) * min(abs(first), abs(second))
    u = f"({np.cos(turn):.5f}*x+{np.sin(turn):.5f}*y)"
    v = f"({-np.sin(turn):.5f}*x+{np.cos(turn):.5f}*y)"
    square = f"{up * 0.5 * first:.5f}*{u}**2 + {up * 0.5 * second:.5f}*{v}**2"
    cube = f"{a:.5f}*{u}**3 + {b:.5f}*{u}**2*{v} + {c:.5f}*{u}*{v}**2 + {d:.5f}*{v}**3"
    return f"""
[shell]
family = "flat-foldable"
unit = "m"
[target.surface]
formula = "{square} + {cube}"
x = [-1, 1]
y = [{-half:.3f}, {half:.3f}]
[pattern]
rows = {panels - 1}
columns = {panels - 1}
{more}
"""


@pytest.mark.parametrize("seed", led_by([1, 0, *range(2, 100)]))
def test_shell_passes_all_checks_or_is_refused_with_what_was_reached(
    seed: int, tmp_path: Path
) -> None:
    """Rigid and clear of contact from flat to target."""
    path = tmp_path / "surface.toml"
    quick = seed < 2
    more = "direction_deg = 0\nfold_deg = 90" if quick else ""
    path.write_text(design_file(seed, 5 if quick else 10, more))
    reached = ""
    try:
        shell = make_shell(read_design_file(path), skip=("remedies", "stock", *MEASURES))
    except DesignError as refused:
        reached = refused.size
    if reached:
        assert "diagonal" in reached
        return
    assert shell.report.feasible
    assert shell.lock.cause == "crease"
