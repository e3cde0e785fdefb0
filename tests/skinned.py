"""Random shells of both families with a second skin, for the tests."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np

from design_tables import Tables
from orishell.conventions.errors import DesignError, InputError
from orishell.design_file import check_design
from orishell.families.parallel_repeating import ParallelRepeating
from orishell.shell.designed import designed
from orishell.shell.make import Shell
from stiffened import shell_of

CURVES = "-x**2", "-0.5*x**2 + 0.3*x", "0.9*x - 0.1*x**2", "0.6*x**2", "sin(2*x)", "cos(1.4*x)"
"""Arches, slopes, a trough and a wave."""
LINES = "0.3*sin(x)", "0.1*x**2", "0.05*x**3 - 0.1*x", "0.4*cos(x)"


OF_ITS_OWN = 60
"""From this number on second skins follow a curve of their own."""


LEVEL = 80
"""From this number on shells are T-hedral."""


def t_hedral_tables(number: int, attempt: int) -> Tables:
    """A T-hedral shell, with or without flaps."""
    draw = np.random.default_rng([number, attempt, 12])
    curve, line = CURVES[number % len(CURVES)], str(draw.choice(["0", *LINES]))
    reach, length = (round(float(draw.uniform(*each)), 3) for each in ((0.6, 1), (2, 4)))
    return {
        "shell": {"family": "t-hedral", "unit": "m"},
        "target": {
            "f": {"formula": curve, "range": [-reach, 0.9 * reach]},
            "g": {"formula": line, "range": [0, length]},
        },
        "pattern": {
            "rows": int(2 * draw.integers(1, 5) + 1),
            "columns": int(draw.integers(4, 8)),
            "flap": float(draw.choice([0, 0.1])),
            "depth": round(float(draw.uniform(0.05, 0.2)), 3),
        },
        "deployment": {"from": "pack", "flap_attachment": "clipped"},
    }


def random_tables(number: int, attempt: int) -> Tables:
    """A parallel repeating shell, or a T-hedral one."""
    return (t_hedral_tables if number >= LEVEL else parallel_tables)(number, attempt)


def parallel_tables(number: int, attempt: int) -> Tables:
    """A parallel repeating shell, with or without boards and flaps."""
    draw = np.random.default_rng([number, attempt, 11])

    def some(low: float, high: float) -> float:
        return round(float(draw.uniform(low, high)), 3)

    design: Tables = {
        "shell": {"family": "parallel-repeating", "unit": "m"},
        "target": {
            "f": {"formula": CURVES[number % len(CURVES)], "range": [-some(0.6, 1), some(0.6, 1)]},
            "g": {"formula": str(draw.choice(LINES)), "range": [0, some(2, 4)]},
        },
        "pattern": {
            "rows": int(2 * draw.integers(1, 5) + 1),
            "columns": int(draw.integers(4, 8)),
            "flap": float(draw.choice([0, 0.1])),
            "xi_deg": some(40, 110),
            "plane_deg": some(70, 110),
        },
    }
    if number % 2:
        thickness = some(0.002, 0.01)
        design["panel"] = {"construction": "bevel", "thickness": thickness, "gap": 0.2 * thickness}
    if draw.integers(2):
        design["deployment"] = {"from": "pack", "flap_attachment": "clipped"}
    return design


def random_sheet(number: int) -> ParallelRepeating:
    """The parallel repeating sheet of the first random shell of a number that can be made."""
    for attempt in itertools.count():
        tables = parallel_tables(number, attempt)
        try:
            sheet = designed(check_design(tables, Path("s.toml"))).mechanism
        except (InputError, DesignError):
            continue
        assert isinstance(sheet, ParallelRepeating)
        return sheet
    raise AssertionError


def skinned(number: int) -> tuple[Tables, Shell | DesignError]:
    """The first random shell of a number that has a second skin, or why it has none."""
    for attempt in itertools.count():
        design = random_tables(number, attempt)
        draw = np.random.default_rng([number, attempt, 13])
        try:
            shell_of(design)
        except (InputError, DesignError):
            continue
        gap = round(float(draw.uniform(0.02, 0.3)), 3) if draw.integers(2) else "auto"
        design["stiffeners"] = {"kind": "skin", "gap": gap, "walls": int(draw.integers(1, 4))}
        if OF_ITS_OWN <= number < LEVEL:
            f, part = design["target"]["f"], round(float(draw.uniform(0.6, 1)), 3)
            inner = f"{round(float(draw.uniform(0.9, 1.4)), 3)}*({f['formula']}) - 0.2"
            design["target"]["inner"] = {**f, "formula": inner}
            design["target"]["inner"]["range"] = [part * end for end in f["range"]]
            del design["stiffeners"]["gap"]
        design["motion"] = {"frames": 8}
        try:
            return design, shell_of(design)
        except DesignError as error:
            return design, error
        except InputError:
            continue
    raise AssertionError
