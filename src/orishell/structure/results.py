"""What an analysis found: of every load case, with every stiffness of creases."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from typing import Literal

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.conventions.row import ORDER, Sign, worst
from orishell.document.loaded import LoadedShell
from orishell.numerics.arrays import Array
from orishell.structure.anchors import Anchor, find_anchors, ground_warnings
from orishell.structure.changes import refinement_warnings
from orishell.structure.combinations import LimitState
from orishell.structure.envelopes import STRENGTH, Envelope, envelopes, few, told
from orishell.structure.equilibrium import GOVERNING, Equilibrium, Limiting
from orishell.structure.loaded import loaded_shell
from orishell.structure.loads import Load, Vector, vector
from orishell.structure.model import Model, Stiffness, stiffness_in_words
from orishell.structure.plausibility import doubts
from orishell.structure.point_supports import warn_of_points
from orishell.structure.verdict import (
    COLLAPSED,
    Finding,
    against_equilibrium,
    against_motion,
    misleads,
    ranked,
)

LINEAR = "large displacements: all is linear, from the shape as it was designed"
FOLLOWED = "pressure that turns with the shell: loads keep direction and size as it moves"
NOT_COVERED = (
    "imperfections of shape and fit, and play of hinges",
    "buckling of single webs and faces of boards between their webs",
    "boards that are stiffer or stronger in one direction than in the other",
    "glue, seams and holes, and what tears at the corners of panels",
    "creep, fatigue, heat and moisture",
    "how anchors hold in the ground, and how the ground under the feet settles",
    "wind and snow on flaps: only their weight counts",
    "gusts that shake the shell, and local suction at its edges",
    "exceptional snow, and drifts at obstacles and taller buildings",
    "the way from the pack to the target",
)
Remedy = Literal["friction", "ties", "pinned"]
"""What may hold a shell: more friction, ties between its feet, or its supports pinned."""
REMEDIES: dict[Remedy, str] = {
    "friction": "friction of {friction:g}",
    "ties": "ties between its feet",
    "pinned": "pinned supports",
}
UNFOUND = "no state of sticking and slipping feet was found in which it bears them"
Ground = Literal["slips", "lifts", "unknown"]
"""What feet do of a shell that moves: it would stand if they did not slip, or if they were held
down; or what they do was not found."""


@record
class FreeMotion:
    """A motion that the loads drive, and that nothing resists, or next to nothing."""

    displacements: Array  # of all nodes (N, 3), the largest is 1, the way that the loads drive it
    folding: bool  # whether it is the shell's own folding motion, not one of the shell as a whole
    # whether it opens the shell; it closes it otherwise. None where it is no folding motion
    opens: bool | None
    holds: tuple[Remedy, ...] = ()  # what would hold the shell: each was tried with these loads
    # whether something resists it, but so little that it goes beyond the size of the shell
    soft: bool = False
    # whether its feet slip: it would stand if they stuck. Or whether they lift, or slip because
    # others lift: it would stand if they were held down. None if neither would hold it
    ground: Ground | None = None
    # the coefficient of friction with which it stands, tried with these loads; None if none does,
    # or none was asked for
    friction: float | None = None

    def in_words(self) -> str:
        """How a shell moves under its loads, what does not hold it, and what would."""
        if self.soft:
            words = "gives way under its loads, by more than its own size: it is far too soft"
        elif self.ground == "unknown":
            words = f"may move under its loads: {UNFOUND}"
        elif self.ground == "slips":
            way = "" if not self.folding else " and opens" if self.opens else " and closes"
            words = f"slips{way} under its loads: its feet need more friction than there is"
        elif self.ground == "lifts" and not self.folding:
            words = "tips, or lifts off, under its loads: nothing holds its feet down"
        elif not self.folding:
            words = "slides or tips as a whole under its loads: its supports do not hold it"
        elif self.opens:
            words = "opens under its loads: nothing holds the feet together"
        else:
            words = "closes under its loads: nothing holds the feet apart"
        if self.holds:
            told = [REMEDIES[each].format(friction=self.friction) for each in self.holds]
            return f"{words}; {' or '.join(told)} would"
        if self.soft:
            return words
        return f"{words}; neither ties between its feet nor pinned supports would"


@record
class CaseResult:
    """A load case with one stiffness of creases."""

    WRITTEN = (
        "name", "limit_state", "creases", "carries", "findings", "loads", "load", "equilibrium",
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
        """The same of a model that is told what refinement found."""
        found = self.equilibrium
        return self if found is None else replace(self, equilibrium=replace(found, model=model))

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        """What speaks against it, the worst first."""
        if self.motion is not None:
            return ranked(against_motion(self.motion))
        assert self.equilibrium is not None
        strength = self.limit_state in STRENGTH
        return ranked(against_equilibrium(self.equilibrium, strength=strength))

    @property
    def sign(self) -> Sign:
        """Whether it fails, wants attention, or holds."""
        return worst(each.sign for each in self.findings)

    @property
    def carries(self) -> bool | None:
        """Whether the shell carries these loads; None if the strength of something is not known."""
        if self.sign == "fails":
            return False
        return None if any(each.kind == "unknown" for each in self.findings) else True

    @property
    def used(self) -> float:
        """The largest share of what is borne: above 1 where it does not carry its loads."""
        if self.equilibrium is None:
            return float("inf")
        if self.limit_state in STRENGTH:
            return self.equilibrium.used
        return self.equilibrium.displacement.share / COLLAPSED

    def in_words(self) -> str:
        """What the shell does under these loads."""
        said = "; ".join(each.text for each in self.findings if each.sign == self.sign)
        if self.sign == "fails" or not said:
            return said or "carries its loads"
        doubt = (
            "carries its loads as far as is known" if self.carries is None else "carries its loads"
        )
        return f"{doubt}, but {said}"

    def load_warnings(self) -> Iterator[tuple[str, str]]:
        """Of which case, and what an engineer should read of its loads."""
        if all(load.kind != "self_weight" for load in self.loads):
            yield self.name, "own weight is left out (self_weight = true)"
        yield from ((load.case, load.caution) for load in self.loads if load.caution)


@record
class Governing:
    """What is nearest to the end of what it bears, of all cases."""

    part: Limiting  # what it is
    # the load case, and the stiffness of its creases
    case: str
    creases: Stiffness
    utilisation: float  # the share of what it bears


@record
class Analysis:
    """The shell as a structure."""

    WRITTEN = (
        "carries", "model", "cases", "governs", "envelopes", "anchors", "warnings", "not_covered",
    )  # fmt: skip

    model: Model  # what is analysed
    cases: tuple[CaseResult, ...]  # all load cases, those with the least stiffness of creases first

    @property
    def not_covered(self) -> tuple[str, ...]:
        """What the analysis says nothing of."""
        return (FOLLOWED if self.model.structure.nonlinear else LINEAR, *NOT_COVERED)

    @property
    def balanced(self) -> list[tuple[Equilibrium, CaseResult]]:
        """The cases in equilibrium, and what holds them."""
        return [(case.equilibrium, case) for case in self.cases if case.equilibrium is not None]

    @cached_property
    def anchors(self) -> tuple[Anchor, ...]:
        """What every support asks of the ground, by all cases in equilibrium."""
        return find_anchors(self)

    @cached_property
    def ranked(self) -> tuple[CaseResult, ...]:
        """All cases, the worst first."""
        order = sorted(self.cases, key=lambda each: (ORDER.index(each.sign), -each.used))
        return tuple(order)

    @property
    def sign(self) -> Sign:
        """That of the worst case."""
        return self.ranked[0].sign

    @property
    def carries(self) -> bool | None:
        """Whether it carries all cases; None if the strength of something is not known."""
        found = {case.carries for case in self.cases}
        return False if False in found else None if None in found else True

    @cached_property
    def governs(self) -> Governing | None:
        """What is nearest to the end of what it bears; None if that of nothing is known."""
        found = [
            Governing(used.governs, case.name, case.creases, used.shares[used.governs] or 0.0)
            for balanced, case in self.balanced
            if case.limit_state in STRENGTH
            if (used := balanced.utilisation).governs is not None
        ]
        return max(found, key=lambda each: each.utilisation, default=None)

    def in_words(self) -> str:
        """Whether it carries all cases, and what the worst does: for one line."""
        first, fails = self.ranked[0], sum(case.sign == "fails" for case in self.cases)
        under = f"under {self.name_of(first)} it {first.in_words()}"
        if fails:
            of = "" if len(self.cases) == 1 else f"{fails} of {len(self.cases)} cases fail; "
            return f"no: {of}{under}"
        if first.sign == "warns":
            return f"{'not known' if self.carries is None else 'not safely'}: {under}"
        found, case = max(self.balanced, key=lambda each: each[0].displacement.size)
        most, unit = found.displacement, self.model.site.unit
        return (
            f"all cases: {self.governing_in_words()}; it is displaced by {plain(most.size, 2)} "
            f"{unit} at most ({plain(100 * most.share, 2)} % of its height, under "
            f"{self.name_of(case)})"
        )

    def governing_in_words(self) -> str:
        """What governs, and how near it comes to what it bears."""
        governs = self.governs
        if governs is None:
            return "no strengths are given, and it does not buckle"
        share = governs.utilisation
        if governs.part == "buckling":
            borne = f"under {plain(1 / share, 3)} times the loads of"
        else:
            borne = f"{plain(100 * share, 3)} % of what can be borne, under"
        return f"{GOVERNING[governs.part]} governs, {borne} {self.name_of(governs)}"

    @cached_property
    def envelopes(self) -> tuple[Envelope, ...]:
        """What governs each limit state of a code; none if no code combines the cases."""
        return tuple(envelopes(self.cases))

    @property
    def told(self) -> tuple[CaseResult, ...]:
        """The cases that are told in full, the worst first: all, or of many those that govern."""
        return told(self.ranked, self.envelopes, self.governs)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """Sentences an engineer should read, beside what speaks against single cases."""
        return (*self._warnings(), *warn_of_points(self.model, self.cases))

    def _warnings(self) -> Iterator[str]:
        yield from ground_warnings(self)
        yield from refinement_warnings(self.model.change, self.model.stopped)
        far = [self.name_of(case) for found, case in self.balanced if misleads(found)]
        if far:
            yield (
                f"linear theory may mislead under {few(far)}: large displacements are "
                "followed with nonlinear = true in [structure]"
            )
        yield from doubts(self.model.structure, self.model.site.unit, self.model.design.panel)
        said: dict[str, dict[str, None]] = {}
        for case in self.cases:
            for name, text in case.load_warnings():
                said.setdefault(text, {})[name] = None
        for text, names in said.items():
            every = names.keys() == {each.name for each in self.cases}
            yield f"{'all load cases' if every else f'load cases {few(list(names))}'}: {text}"

    def name_of(self, case: CaseResult | Governing) -> str:
        """What a case is called, the stiffness of creases said where there are several.

        Parameters
        ----------
        case
            The case, or what governs.
        """
        name = case.name if isinstance(case, CaseResult) else case.case
        if len({each.creases for each in self.cases}) < 2:
            return name
        return f"{name}, {creases_in_words(case.creases)}"

    def loaded(self) -> LoadedShell:
        """The same as files and pages show it."""
        return loaded_shell(self)


def creases_in_words(creases: Stiffness) -> str:
    """Creases of a stiffness, as the name of a case has them."""
    return f"{creases} creases" if isinstance(creases, str) else f"creases of {creases:g} N"
