"""How much of the front short searches find: their hypervolume beside that of longer ones.

The hypervolume (Zitzler & Thiele 1998) is that of what the front beats, up to the worst of the
longer one's in each objective and a tenth of its range more.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.numerics.arrays import Array
from orishell.search import journal_in_memory, local_processes, search_designs
from orishell.search.front import front_of, scores
from orishell.search.problem import parse_problem

TIMES = 10
LENGTHS = {
    "parallel-repeating": (200, 400, 1000),
    "orthodiagonal": (200, 400, 1000, 2500),
    "longitudinal-linear-repeating": (200, 400, 1000),
}
"""Designs of the short searches; the longest one beside them takes ten minutes."""
SEARCHES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "parallel-repeating": (
        {"pattern": {"rows": 5, "columns": 6}},
        {
            "variables": {
                "pattern.xi_deg": {"low": 25.0, "high": 50.0},
                "pattern.plane_deg": {"low": 60.0, "high": 120.0},
                "pattern.theta_deg": {"low": -20.0, "high": 20.0},
            },
            "minimise": ["sheet.height", "deployed.width"],
        },
    ),
    "orthodiagonal": (
        {"pattern": {"rows": 3, "columns": 5, "flap": 0.05}},
        {
            "variables": {
                "pattern.depth": {"low": 0.04, "high": 0.2},
                "target.f.scale": {"low": 0.8, "high": 1.2},
                "target.g.scale": {"low": 0.5, "high": 1.2},
            },
            "minimise": ["sheet.height", "deployed.width"],
            "subject_to": {"sheet_area": {"least": 10.0}},
        },
    ),
    "longitudinal-linear-repeating": (
        {"pattern": {"rows": 3, "columns": 3}},
        {
            "variables": {
                "target.f.scale": {"low": 0.8, "high": 1.2},
                "pattern.sector_deg.0": {"low": 80.0, "high": 89.0},
                "pattern.sector_deg.1": {"low": 75.0, "high": 86.0},
            },
            "minimise": ["deviation.f.max", "deployed.depth"],
        },
    ),
}


def fronts(family: str) -> dict[int, Array]:
    """Objectives of the fronts after so many designs, and after TIMES as many, of one search.

    A search that ends earlier has made the same designs.
    """
    changes, search = SEARCHES[family]
    tables = parse_toml(starter_file(family))
    for name, values in changes.items():
        tables[name] = tables.get(name, {}) | values
    lengths = LENGTHS[family]
    table = {**search, "evaluations": TIMES * max(lengths)}
    problem = parse_problem({**tables, "search": table}, Path("search.toml"))
    with local_processes() as pool:
        found = search_designs(problem, pool, journal_in_memory())
    assert found.whole
    objectives = {}
    for count in {each * times for each in lengths for times in (1, TIMES)}:
        front = front_of(problem, found.outcomes[:count])
        assert front is not None
        objectives[count] = np.array([scores(problem, each) for each in front.members])
    return objectives


@pytest.mark.parametrize("family", SEARCHES)
def test_a_short_search_finds_most_of_the_front(benchmark: Any, family: str) -> None:
    from pymoo.indicators.hv import HV

    found = benchmark.pedantic(fronts, args=(family,), rounds=1)
    volume = HV(ref_point=np.full(2, 1.1))
    for count in LENGTHS[family]:
        short, whole = found[count], found[TIMES * count]
        low, high = whole.min(axis=0), whole.max(axis=0)
        share = volume((short - low) / (high - low)) / volume((whole - low) / (high - low))
        print(
            f"\n{family}: {count} designs find {share:.4f} of the hypervolume that "
            f"{TIMES * count} do; {len(short)} and {len(whole)} are on the front",
            end="",
        )
