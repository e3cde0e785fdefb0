"""What an analysis found of one load case, and whether the shell carries it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from itertools import chain
from math import inf

from orishell.conventions.record import record
from orishell.conventions.row import Note, Sign, worst
from orishell.numerics.arrays import Array
from orishell.structure.ballast import BallastedFoot, against_ballast, worst_ballast
from orishell.structure.combinations import STRENGTH, LimitState
from orishell.structure.equilibrium import COLLAPSED, Equilibrium
from orishell.structure.free_motion import FreeMotion
from orishell.structure.loads import Load, Vector, vector
from orishell.structure.model import Model
from orishell.structure.stiffness import Stiffness, stiffness_in_words
from orishell.structure.verdict import (
    CARRIES,
    Finding,
    against_equilibrium,
    against_motion,
    against_wind_on_walls,
    ranked,
)


@record
class CaseResult:
    """A load case with one stiffness of creases."""

    REPORTED = (
        "name", "limit_state", "creases", "carries", "findings", "loads", "load", "ballast",
        "equilibrium",
    )  # fmt: skip

    name: str  # the case
    stiffness: float  # of creases (force per radian); 0 free, infinite rigid
    loads: tuple[Load, ...]  # what loads it, kind by kind
    forces: Array  # on nodes (N, 3), of all loads (N)
    motion: FreeMotion | None  # what nothing resists; None if there is equilibrium
    equilibrium: Equilibrium | None  # what holds it; None if it moves
    # what a code combines it for: "ULS" is judged by strength and buckling, "EQU" by equilibrium
    # alone, "SLS" by displacements; None if no code does, then by all
    limit_state: LimitState | None = None

    @property
    def creases(self) -> Stiffness:
        """Their stiffness."""
        return stiffness_in_words(self.stiffness)

    @property
    def load(self) -> Vector:
        """Sum of all loads."""
        return vector(self.forces.sum(axis=0))

    def of(self, model: Model) -> CaseResult:
        """The result of a model that is told what refinement found."""
        found = self.equilibrium
        return self if found is None else replace(self, equilibrium=replace(found, model=model))

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        """What speaks against it, the worst first."""
        if self.motion is not None:
            return ranked(against_motion(self.motion))
        assert self.equilibrium is not None
        strength, limited = self.limit_state in STRENGTH, self.limit_state in {None, "SLS"}
        within = against_equilibrium(self.equilibrium, strength=strength, limited=limited)
        walled = self.equilibrium.model.has_end_walls
        windy = walled and any(load.kind == "wind" for load in self.loads)
        return ranked(chain(within, against_ballast(self.ballast), against_wind_on_walls(windy)))

    @cached_property
    def ballast(self) -> BallastedFoot | None:
        """The foot that uses most of what its ballast holds, where equilibrium is judged."""
        found = self.equilibrium
        return None if found is None else worst_ballast(found, self.forces, self.limit_state)

    @property
    def lifts_only(self) -> bool:
        """Whether all that fails is that ballast does not hold its feet."""
        failing = [each for each in self.findings if each.sign == "fails"]
        lifts = {each.text for each in against_ballast(self.ballast)}
        return bool(failing) and all(each.text in lifts for each in failing)

    @property
    def sign(self) -> Sign:
        """Whether it fails, wants attention, or holds."""
        return worst(each.sign for each in self.findings)

    @property
    def carries(self) -> bool | None:
        """Whether the shell carries these loads; None if that is not known."""
        return CARRIES[self.sign]

    @property
    def used(self) -> float:
        """The largest share of what is borne, of the parts whose strength is known.

        It is above 1 where the shell does not carry its loads, and where a figure leaves that open.
        """
        if self.equilibrium is None:
            return float("inf")
        failing = [each for each in self.findings if each.sign == "fails"]
        beyond = [inf if each.excess is None else each.excess for each in failing]
        beyond += [each.excess for each in self.findings if each.excess is not None]
        if self.limit_state in STRENGTH:
            return max([self.equilibrium.used, *beyond])
        return max([self.equilibrium.displacement.share / COLLAPSED, *beyond])

    def in_words(self) -> str:
        """What the shell does under these loads."""
        if self.sign == "warns":
            return f"is not known to carry its loads: it {self.said}"
        followed = self.equilibrium is not None and self.equilibrium.path is not None
        return self.said or f"carries its loads{', large displacements followed' * followed}"

    @property
    def said(self) -> str:
        """What speaks against it, in words; empty if nothing does."""
        return "; ".join(each.text for each in self.findings if each.sign == self.sign)

    def load_warnings(self) -> Iterator[tuple[str, str]]:
        """Of which case, and what an engineer should read of its loads."""
        if all(load.kind != "self_weight" for load in self.loads):
            yield (
                self.name,
                Note("own weight is left out (self_weight = true in [load_case])", "weight"),
            )
        yield from ((load.case, load.caution) for load in self.loads if load.caution)
