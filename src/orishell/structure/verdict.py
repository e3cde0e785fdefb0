"""Whether a case carries its loads, and what speaks against it: the words of all pages.

A case carries if the shell is in equilibrium, stays within its strengths, does not buckle, and is
not displaced so far that it is another shell.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Literal

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.conventions.row import ORDER, Sign
from orishell.numerics.equals import SOLVED, classes

if TYPE_CHECKING:
    from orishell.structure.equilibrium import Equilibrium
    from orishell.structure.free_motion import FreeMotion

Kind = Literal[
    "moves",
    "slips",
    "lifts off",
    "gives way",
    "exceeds strength",
    "buckles",
    "displaced",
    "unknown",
]
"""How a case fails, or may."""
COLLAPSED = 0.25
"""A shell displaced by this share of its height is no longer the shell that was analysed."""
LARGE = 0.05
"""Displacements above this share of the shell's height are too large for linear theory: the thrust
of an arch is a moment of its loads over its height, so it is wrong by about as much."""
LEAST_BUCKLING = 3.0
"""Below this factor a shell may well buckle: imperfect ones do before linear theory says so."""


@record
class Finding:
    """What speaks against a case, or is in doubt."""

    sign: Sign  # whether it fails, or wants attention
    kind: Kind  # how
    text: str  # by how much: what follows on "the shell"
    # how many times too much it is; None where nothing resists, or that is not known
    excess: float | None


def against_motion(motion: FreeMotion) -> Iterator[Finding]:
    """What speaks against a shell that nothing holds, or next to nothing."""
    by_ground: dict[str | None, Kind] = {
        "slips": "slips",
        "lifts": "lifts off",
        "unknown": "unknown",
        None: "moves",
    }
    kind = "gives way" if motion.soft else by_ground[motion.ground]
    yield Finding("fails", kind, motion.in_words(), None)


def against_equilibrium(found: Equilibrium, *, strength: bool = True) -> Iterator[Finding]:
    """What speaks against a shell in equilibrium.

    strength: Whether strength and buckling are judged.
    """
    if strength:
        yield from _against_strength(found)
    path = found.path
    if path is not None and not path.carries:
        excess = 1 / path.reached if path.reached else None
        yield Finding("fails", "buckles", path.in_words(), excess)
    unit, most = found.model.site.unit, found.displacement
    if most.share > LARGE:
        row, column = most.panel
        sign: Sign = "fails" if most.share > COLLAPSED else "warns"
        text = (
            f"is displaced by {plain(most.size, 2)} {unit} ({plain(100 * most.share, 2)} % of its "
            f"height) near panel {row}, {column}"
        )
        if sign == "warns" and path is None:
            text += ", too far for linear theory"
        if sign == "fails" or path is None:
            yield Finding(sign, "displaced", text, most.share / COLLAPSED)


def _against_strength(found: Equilibrium) -> Iterator[Finding]:
    used = found.utilisation
    for name, part in (
        ("panels", used.panels),
        ("membrane", used.membrane),
        ("creases", used.creases),
        ("arms", used.arms),
        ("ties", used.ties),
    ):
        if part is not None and part > 1:
            text = f"uses {plain(100 * part, 3)} % of the strength of its {name}"
            yield Finding("fails", "exceeds strength", text, part)
    factor = found.buckling
    if found.path is None and factor is not None and factor < LEAST_BUCKLING:
        text = f"buckles under {plain(factor, 3)} times its loads"
        if factor >= 1:
            text += " by linear theory, and earlier with imperfections"
        yield Finding("fails" if factor < 1 else "warns", "buckles", text, 1 / factor)
    if found.unknown:
        text = f"is loaded in {' and '.join(found.unknown)}, whose strength is not given"
        yield Finding("warns", "unknown", text, None)


def misleads(found: Equilibrium) -> bool:
    """Whether linear theory, by which it was found, may mislead."""
    soft = found.buckling is not None and found.buckling < LEAST_BUCKLING
    return found.path is None and (soft or found.displacement.share > LARGE)


def ranked(findings: Iterator[Finding]) -> tuple[Finding, ...]:
    """Findings, the worst first."""
    found = list(findings)
    beyond = classes([-(each.excess or 0) for each in found], SOLVED)
    order = np.lexsort((beyond, [ORDER.index(each.sign) for each in found]))
    return tuple(found[k] for k in order.tolist())
