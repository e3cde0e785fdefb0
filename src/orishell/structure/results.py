"""What an analysis found: of every load case, with every stiffness of creases."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Literal

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.document.loaded import LoadedCase, LoadedShell
from orishell.numerics.arrays import Array
from orishell.structure.combinations import LimitState
from orishell.structure.envelopes import MANY, STRENGTH, Envelope, envelopes
from orishell.structure.equilibrium import Equilibrium, Limiting
from orishell.structure.loads import Load, Vector, vector
from orishell.structure.model import Model, Stiffness, stiffness_in_words

COARSE = 0.1
"""Displacements that change by more than this share with cells half as large are not near."""
NOT_COVERED = (
    "imperfections of shape and fit, and play of hinges",
    "large displacements: all is linear, from the shape as it was designed",
    "buckling of single webs and faces of boards between their webs",
    "boards that are stiffer or stronger in one direction than in the other",
    "glue, seams and holes, and what tears at the corners of panels",
    "creep, fatigue, heat and moisture",
    "anchors, and the ground under the feet",
    "wind and snow on flaps: only their weight counts",
    "gusts that shake the shell, and local suction at its edges",
    "exceptional snow, and drifts at obstacles and taller buildings",
    "the way from the pack to the target",
)
Remedy = Literal["ties", "pinned"]
"""What may hold a shell: ties between its feet, or its supports pinned."""
REMEDIES: dict[Remedy, str] = {"ties": "ties between its feet", "pinned": "pinned supports"}


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

    def in_words(self) -> str:
        """How a shell moves under its loads, what does not hold it, and what would."""
        if self.soft:
            words = "gives way under its loads, by more than its own size: it is far too soft"
        elif not self.folding:
            words = "slides or tips as a whole under its loads: its supports do not hold it"
        elif self.opens:
            words = "opens under its loads: nothing holds the feet together"
        else:
            words = "closes under its loads: nothing holds the feet apart"
        if self.holds:
            return f"{words}; {' or '.join(REMEDIES[each] for each in self.holds)} would"
        if self.soft:
            return words
        return f"{words}; neither ties between its feet nor pinned supports would"


@record
class CaseResult:
    """A load case with one stiffness of creases."""

    WRITTEN = ("name", "limit_state", "creases", "loads", "load", "moves", "stands")

    name: str  # the case
    stiffness: float  # of creases (force per radian); 0 free, infinite rigid
    loads: tuple[Load, ...]  # what loads it, kind by kind
    forces: Array  # on nodes (N, 3), of all loads (N)
    motion: FreeMotion | None  # what nothing resists; None if the shell stands
    stands: Equilibrium | None  # how it stands; None if it does not
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

    @property
    def moves(self) -> str | None:
        """How it moves, where nothing resists; None if it stands."""
        return None if self.motion is None else self.motion.in_words()

    def warnings(self) -> Iterator[str]:
        """What an engineer should read of it."""
        if self.motion is not None:
            yield f"the shell {self.moves}"
        if self.stands is not None:
            yield from self.stands.warnings(strength=self.limit_state in STRENGTH)

    def load_warnings(self) -> Iterator[str]:
        """What an engineer should read of its loads."""
        if all(load.kind != "self_weight" for load in self.loads):
            yield f"{self.name}: own weight is left out (self_weight = true)"
        yield from (f"{load.case}: {load.caution}" for load in self.loads if load.caution)


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

    WRITTEN = ("model", "cases", "governs", "envelopes", "warnings", "not_covered")

    model: Model  # what is analysed
    cases: tuple[CaseResult, ...]  # all load cases, those with the least stiffness of creases first
    not_covered: tuple[str, ...] = NOT_COVERED  # what the analysis says nothing of

    @property
    def standing(self) -> list[tuple[Equilibrium, CaseResult]]:
        """The cases under which it stands, and how."""
        return [(case.stands, case) for case in self.cases if case.stands is not None]

    @cached_property
    def governs(self) -> Governing | None:
        """What is nearest to the end of what it bears; None if that of nothing is known."""
        found = [
            Governing(used.governs, case.name, case.creases, used.shares[used.governs] or 0.0)
            for stands, case in self.standing
            if case.limit_state in STRENGTH
            if (used := stands.utilisation).governs is not None
        ]
        return max(found, key=lambda each: each.utilisation, default=None)

    @cached_property
    def envelopes(self) -> tuple[Envelope, ...]:
        """What governs each limit state of a code; none if no code combines the cases."""
        return tuple(envelopes(self.cases))

    @property
    def told(self) -> tuple[CaseResult, ...]:
        """The cases that are told in full: all, or of many those that govern."""
        if len({case.name for case in self.cases}) <= MANY:
            return self.cases
        names = {each.case for each in self.envelopes if each.moves or each.part is not None}
        if self.governs is not None:
            names.add(self.governs.case)
        own = (case for case in self.cases if case.limit_state is None or case.name in names)
        return tuple(own)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """Sentences an engineer should read."""
        return tuple(self._warnings())

    def _warnings(self) -> Iterator[str]:
        if self.model.change > COARSE:
            yield (
                f"displacements changed by {plain(100 * self.model.change, 3)} % when cells were "
                "halved: use finer ones (cells, or refine, in [structure])"
            )
        for case in self.cases:
            yield from (f"load case {self.name_of(case)}: {text}" for text in case.warnings())
        of_loads = dict.fromkeys(text for case in self.cases for text in case.load_warnings())
        yield from (f"load case {text}" for text in of_loads)

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
        model, section = self.model, self.model.section
        facets = model.mesh.facets
        count = len(facets.triangles)
        return LoadedShell(
            points=facets.points,
            triangles=facets.triangles,
            panels=model.mesh.panels,
            membrane=np.broadcast_to(np.asarray(section.membrane, np.float64), count),
            bending=np.broadcast_to(np.asarray(section.bending, np.float64), count),
            poisson=section.poisson,
            areal_mass=model.exposure.areal_mass,
            held=model.supports.as_if_pinned(),
            ties=model.nodes_of(model.site.ties),
            tie_stiffness=model.structure.tie_stiffness,
            cases=tuple(self._loaded(case) for case in self.cases),
        )

    def _loaded(self, case: CaseResult) -> LoadedCase:
        shown = case.motion or case.stands
        assert shown is not None
        count = len(self.model.mesh.facets.triangles)
        return LoadedCase(
            name=self.name_of(case),
            stands=case.motion is None,
            forces=case.forces,
            displacements=shown.displacements,
            stresses=np.zeros(count) if case.stands is None else case.stands.stresses.max(axis=1),
        )


def creases_in_words(creases: Stiffness) -> str:
    """Creases of a stiffness, as the name of a case has them."""
    return f"{creases} creases" if isinstance(creases, str) else f"creases of {creases:g} N"
