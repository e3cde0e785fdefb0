"""Contact of boards: what is proved clear and what is said to meet, against manifold3d's solids."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import Phase, event, given, reject, settings
from hypothesis import strategies as st

from mechanisms import random_net
from orishell.conventions.errors import DesignError
from orishell.curves import curve_from_formulas, parse_formula
from orishell.design import Design, PanelSpec, Sides
from orishell.design_file import read_design_file
from orishell.families.flat_foldable.design import completed
from orishell.locking import Lock, find_lock
from orishell.solids import largest_folds, thickness_between
from overlaps import NOTHING, overlap
from samples import THOROUGH, examples, thorough
from strategies import Request, orthodiagonal_requests, requests

EXAMPLES = Path(__file__).parents[2] / "examples"
STATES = 40 if THOROUGH else 16
FEW = {
    "rows": (1, 3, 5) if THOROUGH else (1, 3),
    "columns": (3, 4, 5, 6) if THOROUGH else (3, 4),
}


SIDES: tuple[Sides | None, ...] = (None, "both", "top", "bottom")


def with_panels(design: Design, draw: st.DataObject) -> Design:
    """Random boards, of at most nine tenths of what the target leaves room for."""
    design = replace(design.with_clipped_flaps(), clipped=None)
    mechanism = design.mechanism
    flat, folds = mechanism.positions(0.0), largest_folds(mechanism, mechanism.target_drive)
    size = float(np.ptp(flat, axis=(0, 1)).max())
    sides = draw.draw(st.sampled_from(SIDES))
    of_size = PanelSpec(thickness=size, membrane=0.05 * size, sides=sides or "both")
    most = thickness_between(flat, mechanism.grid, folds, of_size)
    thickness = draw.draw(st.floats(0.05, 0.9)) * min(most, 0.1 * size)
    event("solid" if sides is None else f"boards on {sides}")
    if sides is not None:
        build = PanelSpec(thickness=thickness, membrane=0.05 * thickness, sides=sides)
    else:
        build = PanelSpec(
            thickness=thickness,
            construction="bevel",
            gap=draw.draw(st.floats(0.05, 0.3)) * thickness,
        )
    return replace(design, panel=build, opens_from_pack=draw.draw(st.booleans()))


def check(design: Design) -> Lock:
    """What the proof says is what manifold3d finds, in states that are not those looked at."""
    mechanism = design.mechanism
    try:
        lock = find_lock(design)
    except DesignError as error:  # the target leaves room for boards that the end does not
        if "leave nothing of a panel" in str(error):
            reject()
        raise
    if lock.built is None:
        reject()  # its panels meet before the target, whatever boards do
    boards = lock.built.bodies
    for drive in np.linspace(0.0, lock.closes_to, STATES):
        assert overlap(mechanism, boards, drive) < NOTHING
    meet = lock.first_contact is not None and lock.first_contact.kind == "boards"
    event("boards meet" if meet else "clear to the end")
    event("corners are cut off" if lock.built.reliefs.any() else "corners are whole")
    if lock.first_contact is not None and meet:
        at = lock.first_contact.drive
        beyond = at + np.geomspace(1e-4, 0.05, 8) * mechanism.end_drive
        assert max(overlap(mechanism, boards, drive) for drive in beyond) > NOTHING
    return lock


generated = settings(max_examples=examples(34), phases=[Phase.generate])


@pytest.mark.slow
@generated
@given(requests(), st.data())
def test_parallel_repeating(request: Request, data: st.DataObject) -> None:
    check(with_panels(few(request, data).feasible(), data))


@generated
@given(orthodiagonal_requests(), st.data())
def test_orthodiagonal(request: Request, data: st.DataObject) -> None:
    check(with_panels(few(request, data).feasible(), data))


@thorough
@generated
@given(st.floats(0.2, 1.0), st.sampled_from([2, 3, 5]), st.integers(3, 7), st.data())
def test_longitudinal(start: float, rows: int, columns: int, data: st.DataObject) -> None:
    file = read_design_file(EXAMPLES / "figure3.toml")
    f = curve_from_formulas(parse_formula("cos(t)"), parse_formula("sin(t)"), start, np.pi - start)
    pattern = file.pattern.model_copy(update={"column_lengths": "auto"}).sized(rows, columns)
    try:
        design = pattern.design(f, file.g)
    except DesignError:
        reject()
    check(with_panels(design, data))


@generated
@given(st.integers(0, 10**6), st.booleans(), st.data())
def test_flat_foldable(seed: int, mixed: bool, data: st.DataObject) -> None:
    check(with_panels(completed(random_net(5, 4, seed, mixed=mixed), {}, flap=0.0), data))


def few(request: Request, data: st.DataObject) -> Request:
    size = {key: data.draw(st.sampled_from(values)) for key, values in FEW.items()}
    return replace(request, options={**request.options, **size})
