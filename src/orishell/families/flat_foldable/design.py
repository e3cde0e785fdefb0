"""Flat-foldable sheets from their own numbers, with no target to meet (not in the paper)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded, rounded_down, tidy_degrees
from orishell.design import Design, Parameter
from orishell.families.flat_foldable.lists import Lists, describe
from orishell.families.flat_foldable.locks.flaps import flap_width, with_any_flaps
from orishell.families.flat_foldable.locks.straight import with_parallel_borders
from orishell.families.flat_foldable.named import NamedSheet
from orishell.families.flat_foldable.net import Net
from orishell.families.flat_foldable.placement import levelled, with_level_ends
from orishell.families.flat_foldable.refusal import find_fault
from orishell.families.pattern import Auto
from orishell.motion import require_resolution
from orishell.numerics.bisection import largest_below

TURNS = {"arch": np.deg2rad(120), "fan": np.deg2rad(40)}
"""Turns that are taken where they are left open, or half of them, and so on."""
SMALLEST_TURN = 1e-3
"""The smallest share of a turn that is tried in its place."""


def of_lists(lists: Lists, fold: float | None, flap: float | Auto) -> Design:
    """The design of a sheet of lists, whose largest fold angle may be given (radians)."""
    net = lists.net()
    if fold is not None:
        share = np.tan(0.5 * fold) / max(np.abs(net.x).max(), np.abs(net.y).max())
        net = replace(net, x=share * net.x, y=share * net.y)
    fault = find_fault(net)
    if fault is not None:
        given = {"row_angles_deg": lists.row_angles, "column_angles_deg": lists.column_angles}
        changes = [Remedy({f"pattern.{key}": "auto"}) for key in given if given[key] is not None]
        if len(changes) > 1:
            changes.append(changes[0] | changes[1])
        raise DesignError(
            fault.condition,
            place=fault.place,
            size=fault.size,
            candidates=changes,
            excess=fault.excess,
        )
    return completed(net, {"sheet": "lists"}, flap=flap)


def of_name(named: NamedSheet, sheet: str, turn: float | None, flap: float | Auto) -> Design:
    """The design of a named sheet, whose turn may be given (radians)."""
    if sheet == "miura":
        return _checked_named(named, named.miura(), {"sheet": sheet}, flap)
    make: Callable[[float], Net] = named.arch if sheet == "arch" else named.fan

    def works(turn: float) -> bool:
        return find_fault(make(turn)) is None

    if turn is None:
        turn = TURNS[sheet]
        while not works(turn) and turn > SMALLEST_TURN * TURNS[sheet]:
            turn *= 0.5

    described: dict[str, Parameter] = {"sheet": sheet, "turn_deg": tidy_degrees(turn)}
    if not works(turn):
        sign = float(np.sign(turn))
        found = largest_below(lambda size: works(sign * size), abs(turn), smallest=SMALLEST_TURN)
        if found is not None:
            raise _too_large(named, turn, sign * rounded_down(float(np.rad2deg(found))), make(turn))
    return _checked_named(named, make(turn), described, flap, arched=sheet == "arch")


def _too_large(named: NamedSheet, turn: float, most: float, net: Net) -> DesignError:
    """The refusal of a turn (radians), the largest that works being ``most`` (degrees)."""
    fault = find_fault(net)
    assert fault is not None
    asked = tidy_degrees(turn)
    return DesignError(
        f"turn_deg = {asked:g} is too large for {named.rows} rows and {named.columns} columns",
        keys=("pattern.turn_deg",),
        place=fault.place,
        size=f"{fault.condition}; up to {most:g} works",
        candidates=[Remedy({"pattern.turn_deg": rounded(share * most)}) for share in (0.9, 0.5)],
        excess=asked / most - 1,
    )


def _checked_named(
    named: NamedSheet,
    net: Net,
    described: dict[str, Parameter],
    flap: float | Auto,
    *,
    arched: bool = False,
) -> Design:
    if flap:
        net = with_parallel_borders(net)
    fault = find_fault(net)
    if fault is not None:
        raise DesignError(
            fault.condition,
            place=fault.place,
            size=fault.size,
            candidates=[
                *([Remedy({"pattern.growth": 1.0})] if named.growth != 1 else []),
                Remedy({"pattern.sector_deg": 60.0}),
            ],
            excess=fault.excess,
        )
    given: dict[str, Parameter] = {
        **described,
        "sector_deg": tidy_degrees(named.sector),
        "growth": named.growth,
    }
    return completed(net, given, arched=arched, flap=flap)


def completed(
    net: Net, described: dict[str, Parameter], *, arched: bool = False, flap: float | Auto = 0.0
) -> Design:
    """The design of a net, level about the origin, with flaps beside straight borders."""
    bare = levelled(net, arched=arched)
    grows = described.get("growth", 1.0) != 1.0
    require_resolution(bare, [Remedy({"pattern.growth": 1.0})] if grows else [])
    if arched:
        bare = with_level_ends(bare)
    locked = with_any_flaps(bare, None if flap == "auto" else flap) if flap else None
    return Design(
        mechanism=locked or bare,
        parameters={
            **described,
            "fold_deg": tidy_degrees(bare.target_drive),
            "flap": flap_width(locked) if locked else 0.0,
            **describe(bare.sheet),
        },
        targets={},
        closeness={},
        swept=None,
        warnings=(),
        may_stand=True,
    )
