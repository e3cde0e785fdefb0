"""Boards on T-hedral shells: apart from the open end to where they stop, by manifold3d's solids."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design_tables import formula, tables
from orishell.conventions.errors import DesignError
from orishell.design import Design, PanelSpec
from orishell.design_file import check_design
from orishell.families.t_hedral import THedralPattern, design_t_hedral
from orishell.locking import find_lock
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.quads import signed_areas
from orishell.shell.make import make_shell
from orishell.solids import find_stop, find_thickness_limit
from overlaps import NOTHING, overlap
from samples import THOROUGH
from strategies import graph

STATES = 40
BEYOND = 1e-3
"""Where boards meet, they overlap so far beyond (radians)."""


def bare(rng: np.random.Generator) -> Design:
    """A random shell that can be designed: f with bends to both sides, with flaps or without."""
    while True:
        a, b, c = rng.uniform(-1, 1, 3)
        f = graph(f"{a}*x + {b}*x**2 + {0.3 * c}*sin(2*x)", -rng.uniform(0.5, 1.5), 1)
        g = graph(f"{rng.uniform(0, 0.5)}*sin(x)", 0, rng.uniform(2, 5))
        pattern = THedralPattern(
            rows=int(rng.choice([1, 3, 5])),
            columns=int(rng.integers(3, 6)),
            depth=float(rng.choice([0.0, 0.1, 0.3])),
            flap=float(rng.choice([0.0, 0.0, 0.2])),
        )
        try:
            return design_t_hedral(f, g, pattern)
        except DesignError:
            continue


def with_boards(design: Design, rng: np.random.Generator) -> Design:
    """The shell with random boards, of at most nine tenths of what there is room for."""
    construction = rng.choice(["sandwich", "bevel"])
    size = float(np.sqrt(np.abs(signed_areas(panels_laid_flat(design.mechanism))).mean()))

    def panels(thickness: float) -> PanelSpec:
        if construction == "sandwich":
            return PanelSpec(thickness=thickness, membrane=0.05 * thickness)
        return PanelSpec(thickness=thickness, construction="bevel", gap=0.1 * thickness)

    room = find_thickness_limit(design.mechanism.without_flaps(), panels(size)).thickness
    thickness = rng.uniform(0.05, 0.9) * min(room, 0.1 * size)
    while True:
        try:
            stopped = design.with_stop(find_stop(design.mechanism, panels(thickness)))
        except DesignError:  # no room on flaps, however early they stop
            thickness /= 2
            continue
        if find_thickness_limit(stopped.mechanism, panels(thickness)).thickness >= thickness:
            break
        thickness /= 2
    return replace(stopped, panel=panels(thickness), opens_from_pack=bool(rng.integers(2)))


@pytest.mark.parametrize("seed", range(60 if THOROUGH else 4))
def test_boards_are_apart_to_where_they_stop(seed: int) -> None:
    """Seen of manifold3d: no overlap in 40 states, and one beyond where boards stop it."""
    rng = np.random.default_rng(seed)
    design = with_boards(bare(rng), rng)
    lock = find_lock(design)
    assert not lock.early  # its panels meet nothing before the target
    assert lock.built is not None
    mechanism, bodies = design.mechanism, lock.built.bodies
    for drive in np.linspace(0.0, lock.closes_to, STATES):
        assert overlap(mechanism, bodies, drive) < NOTHING
    contact = lock.first_contact
    if contact is not None and contact.kind == "boards":
        beyond = contact.drive + np.geomspace(1e-4, 0.05, 8) * mechanism.end_drive
        assert max(overlap(mechanism, bodies, drive) for drive in beyond) > NOTHING
    elif lock.cause == "boards" and design.opens_from_pack:
        assert overlap(mechanism, bodies, lock.closes_to + BEYOND) > NOTHING


@pytest.mark.slow
def test_gussets_hold_a_vault_both_ways() -> None:
    """Each by itself: a gusset fixes all creases about its vertex, whatever sectors add up to."""
    design = tables("t-hedral", formula("-0.5*x**2", -1.5, 1.5), formula("0", 0, 4))
    design["pattern"] = {"rows": 5, "columns": 7, "flap": 0, "depth": 0.25}
    design["deployment"], design["motion"] = {"from": "pack"}, {"frames": 3}
    design["panel"] = {"thickness": 0.01, "membrane": 0.001, "gap": 0.004}
    design["stiffeners"] = {"kind": "gussets", "rows": "all", "share": 0.5}
    shell = make_shell(check_design(design, Path("vault.toml")))
    assert shell.report.feasible
    assert shell.design.fixed_by == "any"
    assert {row.sign for row in shell.report.verdict if row.subject in {"folds", "locks"}} == {
        "holds"
    }
