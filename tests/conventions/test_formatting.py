"""What a prompt shows of results: one line each, worth reading."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from orishell import (
    FoldingMotion,
    ParallelRepeatingPattern,
    curve_from_formulas,
    curve_from_points,
    design_parallel_repeating,
    measure_residuals,
    parse_formula,
)
from orishell.design_file import read_design_file, starter_file
from orishell.deviation import Deviation, Distances
from orishell.families.registry import FAMILIES
from orishell.io import document_of_fold, read_fold, write_fold
from orishell.locking import find_lock
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from orishell.verification import inspect_fold
from public_names import public_objects

LONGEST = 330
"""Characters: four lines of a terminal, for what has a dozen parts."""
RESULT = 140
"""Of what one meets first."""


def test_no_array_is_printed() -> None:
    """What holds arrays is not compared (``eq=False``), and says itself what it is."""
    holding = {
        name: thing
        for name, thing in public_objects().items()
        if dataclasses.is_dataclass(thing) and not vars(thing)["__dataclass_params__"].eq
    }
    assert len(holding) > 30
    generated = [name for name, each in holding.items() if hasattr(each.__repr__, "__wrapped__")]
    assert not generated


@pytest.fixture(params=list(FAMILIES))
def shell(request: pytest.FixtureRequest, tmp_path: Path) -> Shell:
    path = tmp_path / "shell.toml"
    path.write_text(starter_file(request.param), encoding="utf-8")
    return make_shell(read_design_file(path), clash="unexamined", skip=MEASURES)


def parts(thing: Any, found: dict[int, Any]) -> Iterator[Any]:
    """Our dataclasses that are in a thing, itself included, each once."""
    if id(thing) in found:
        return
    found[id(thing)] = thing
    inner: list[Any] = []
    if dataclasses.is_dataclass(thing) and type(thing).__module__.startswith("orishell"):
        yield thing
        inner = [getattr(thing, each.name) for each in dataclasses.fields(thing)]
    elif isinstance(thing, list | tuple):
        inner = list(thing[:3])
    elif isinstance(thing, dict):
        inner = list(thing.values())
    for each in inner:
        yield from parts(each, found)


def test_results_are_one_line(shell: Shell, tmp_path: Path) -> None:
    write_fold(tmp_path / "shell.fold", shell.document)
    fold = read_fold(tmp_path / "shell.fold")
    motion, found = shell.motion, dict[int, Any]()
    things = [
        *(
            shell,
            None if shell.design.swept is None else shell.design.swept.lattice(1.0, 0.1),
            motion.target,
            list(shell.document.states),
        ),
        *(measure_residuals(motion, motion.flat), fold, document_of_fold(fold), inspect_fold(fold)),
    ]
    seen = [each for thing in things for each in parts(thing, found)]
    assert len({type(each) for each in seen}) > 25
    for each in seen:
        line = repr(each)
        assert "\n" not in line
        assert " at 0x" not in line
        assert len(line) <= LONGEST, line
    first = (shell, shell.design, shell.lock, motion, motion.target, motion.mechanism)
    for each in (*first, *(shell.file.target or ())):
        assert len(repr(each)) <= RESULT, each


def test_what_it_says() -> None:
    f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    g = curve_from_formulas(None, parse_formula("0.1*x"), 0, 2)
    design = design_parallel_repeating(
        f, g, ParallelRepeatingPattern(rows=3, columns=2, xi_deg=50, flap=0.3)
    )
    sheet = "ParallelRepeating(5 x 4 vertices, 12 panels, drive to 180 degrees)"
    assert repr(f) == "Curve(from (-1, -1) to (1, -1), parameter -1 to 1)"
    zigzag = curve_from_points([[0, 0], [1, 1], [2, 0]], smooth=False)
    assert repr(zigzag).endswith("(2, 0), parameter 0 to 2.82843, 1 corner)")
    assert repr(parse_formula("-x**2")) == "Formula(text='-x**2', variable='x')"
    assert repr(design.mechanism) == sheet
    assert repr(design).startswith(f"Design({sheet}; meets f to {design.closeness['f'].max:.4g}, g")
    motion = FoldingMotion(design.mechanism, 5)
    assert repr(motion) == f"FoldingMotion(5 states of {sheet})"
    assert repr(motion.flat) == (
        "FoldedState(drive=0, positions=array(5, 4, 3), "
        "fold_angles=CreaseValues(row=array(3, 3), column=array(4, 2)))"
    )
    lock = find_lock(design)
    assert repr(lock) == "Lock(flaps at 180, target at 180 degrees, path examined)"
    way = Distances(0.25, 0.125, 0.1, 0.2, 0.001, 0.01)
    assert repr(Deviation(way, way)) == "Deviation(max 0.25 (known to 0.001), rms 0.125, both ways)"
