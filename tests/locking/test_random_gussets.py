"""Gussets in random shells: manifold3d finds what meets, the tests' own rank what is held."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from design_tables import mended
from orishell.document import Document
from orishell.locking.gussets import Place
from orishell.motion import diagonal
from orishell.shell.make import Shell
from orishell.solids.gussets import Gussets, gusset_parts
from overlaps import NOTHING
from rigid_rank import freedoms_with_plates
from samples import THOROUGH, led_by
from stiffened import Drawn, bodies, common, drawn, gussets_of, shell_of, without

QUICK = (3, 4, 6, 9, 10, 12, 16, 17, 21)
"""Of all families and builds, from 16 on with boards of their own; 10 and 16 are refused, 12 is
between flaps that are shut."""
NEAR = 1e-3
"""How near to contact boards are looked at, relative to how far gussets stand off."""


@pytest.mark.parametrize("number", range(60) if THOROUGH else QUICK)
def test_they_meet_nothing_and_hold_what_they_are_said_to(number: int) -> None:
    found = drawn(number)
    if found.refused is not None:
        require_reason(found)
        return
    design = found.shell.design
    assert design.plates
    require_apart(found.shell)
    corners = [part.plate.corner for part in design.plates if part.plate is not None]
    alone = corners[:: max(1, len(corners) // 3)]
    each = [freedoms_with_plates(design.mechanism, [corner]) for corner in alone]
    together = freedoms_with_plates(design.mechanism, corners)
    if design.fixed_by == "any":
        assert freedoms_with_plates(design.mechanism, []) == 1
        assert not any(each)
    assert (together == 0) == (design.fixed_by is not None)


def require_apart(shell: Shell) -> None:
    """Volume in common, relative to that of all."""
    names, found = bodies(shell.document)
    total = sum(each.volume() for each in found)
    assert max(common(names, found).values(), default=0.0) < NOTHING * total


def require_reason(found: Drawn) -> None:
    """What is named as meeting has volume in common, and what is offered instead is apart."""
    assert found.refused is not None
    named = re.fullmatch(r"(gusset [\d,]+) and (.*) meet", found.refused.condition)
    if named is not None:
        at = np.array(
            [[*map(int, one.split(","))] for one in re.findall(r"gusset ([\d,]+)", named[0])]
        )
        share = found.tables["stiffeners"]["share"]
        design = found.shell.design
        put_in = with_parts(found.shell, gussets_of(found.tables, design, at, share))
        pair = {each.removeprefix("panel ") for each in named.groups()}
        met = common(*bodies(put_in))
        assert max(volume for names, volume in met.items() if set(names) == pair) > 0
    for remedy in found.refused.candidates:
        require_apart(shell_of(mended(found.tables, remedy)))


def with_parts(shell: Shell, gussets: Gussets) -> Document:
    """The document of a shell with gussets that nobody proved."""
    built = shell.lock.built
    levels = 0 if built is None else built.boards.outlines.shape[1]
    parts = gusset_parts(shell.design, gussets, levels)
    return replace(shell.document, attached=(*shell.document.attached, *parts))


@pytest.mark.parametrize("number", led_by([4, 17, 5, 6, 8, 9, 10, 11, 16, 20], 2))
def test_boards_overlap_just_beyond_a_contact_that_is_found(number: int) -> None:
    """A gusset is brought nearer until it is said to meet a panel: before, nothing overlaps."""
    tables = drawn(number).tables
    shell = without(tables)
    design, inner = shell.design, shell.design.mechanism.inner_columns
    at = np.array([[1, (inner.start + inner.stop) // 2]])
    place = Place(design, shell.lock, at, 1e-9 * diagonal(design.mechanism.positions(0.0)))
    whole = gussets_of(tables, design, at, 0.7)

    def nearer(share: float) -> Gussets:
        return replace(whole, off=share * whole.off)

    low, high = 0.0, 1.0
    assert place.met(nearer(low)) is not None
    assert place.met(nearer(high)) is None
    while high - low > 1e-7:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if place.met(nearer(middle)) else (low, middle)
    found = place.met(nearer(low))
    assert found is not None
    named = {place.name(whole, panel).removeprefix("panel ") for panel in found[:2]}
    for share, meets in ((low * (1 - NEAR), True), (high * (1 + NEAR), False)):
        met = common(*bodies(with_parts(shell, nearer(share))))
        assert (max(met.values(), default=0.0) > 0) == meets
        if meets:  # panels on either side of a gusset may be met alike, but for rounding
            own = max(volume for pair, volume in met.items() if {*pair} == named)
            assert own >= (1 - 1e-9) * max(met.values())
