"""What an analysis found: of every load case, with every stiffness of creases."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.conventions.row import ORDER, Note, Sign
from orishell.document.loaded import LoadedShell
from orishell.numerics.equals import SOLVED, classes, largest_of
from orishell.structure.anchors import Anchor, find_anchors, ground_warnings
from orishell.structure.carried import membrane_warnings
from orishell.structure.case import CaseResult
from orishell.structure.changes import refinement_warnings
from orishell.structure.code_asks import asks_in_words, code_asks
from orishell.structure.combinations import STRENGTH
from orishell.structure.envelopes import Envelope, Governing, envelopes, few, reported_cases
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.loaded import loaded_shell
from orishell.structure.model import Model
from orishell.structure.plausibility import doubts_of_shell
from orishell.structure.stiffness import creases_in_words
from orishell.structure.utilisation import governing
from orishell.structure.verdict import CARRIES, misleads
from orishell.structure.whole_boards import arm_warnings

LOCAL = 0.65
"""A mode is local to points that hold the shell if so much of its strain energy is in panels there:
0.76 to 1 where it was, up to 0.54 where it was not (shelter, a strip of it, and Figure 2)."""
NEAR = 1.25
"""Local modes count below so many times the lowest factor: with finer cells they fall that much."""
FAR = 10.0
"""Above this factor nothing is said: a shell that far from buckling stays far from it."""


def warn_of_points(model: Model, cases: Sequence[CaseResult]) -> Iterator[str]:
    """What supports that are points, or next to points, do to buckling."""
    for patch in model.supports.lost:
        yield Note(
            f"a patch of {plain(patch, 3)} {model.site.unit} is smaller than the cells around it: "
            "only vertices are held (patch in supports, or cells, in [structure])",
            "patch",
        )
    names = dict.fromkeys(
        case.name
        for case in cases
        if case.equilibrium is not None and buckles_at_points(case.equilibrium)
    )
    if names:
        yield Note(
            f"load cases {', '.join(names)}: buckling is local to supports held at a point, and "
            "falls as cells become finer: hold edges or a patch there (edges = true, or patch, in "
            "supports in [structure])",
            "points",
        )


def buckles_at_points(found: Equilibrium) -> bool:
    """Whether a shell buckles, or nearly so, locally where points hold it."""
    lowest = found.buckling
    if lowest is None or lowest > FAR:
        return False
    both = zip(found.buckling_factors, found.buckling_at_points, strict=True)
    return any(share > LOCAL and factor < NEAR * lowest for factor, share in both)


LINEAR = "large displacements: all is linear, from the shape as it was designed"
LINEAR_BUT_SOFT = (
    "large displacements of cases that buckle by linear theory under 3 times their loads or more, "
    "or not at all: these are linear, from the shape as it was designed"
)
FOLLOWED = "pressure that turns with the shell: loads keep direction and size as it moves"
FOLDED = (
    "folding, contact and pack of panels of this thickness: all that is said of these is of panels "
    "without one, as they are designed with none"
)
ONE_WAY = "boards that are stiffer or stronger in one direction than in the other"
ECCENTRIC = (
    "how far the middle of what chamfers leave of a board is off its hinge plane: boards bend "
    "about their own middle everywhere, the least that they do"
)
CLIPPED_IN = (
    "what single clips or bolts along edges of gussets do to boards, moments that they hold, and "
    "how far off the creases gussets stand: they are hinged in these; where they have a core, its "
    "shear and wrinkling of faces"
)
HUNG_ON = (
    "wind and snow on what the sheet carries: only its weight counts; what single screws of its "
    "hinges, or clips of plates across, do to boards, and how far off panels its boards stand; "
    "springs in its hinges, which turn freely, whatever the creases of the sheet do"
)
IMPERFECT = "imperfections of shape and fit, and play of hinges"
IMPERFECT_BUT_SOFT = (
    "imperfections of fit, and of shape but of cases that buckle soon and are followed, as these "
    "first buckle"
)
IMPERFECT_FIT = "imperfections of fit, and of shape in other ways than it first buckles"
NOT_COVERED = (
    "buckling of single webs and faces of boards between their webs",
    "holes, and what tears at the corners of panels",
    "wind and snow on flaps: only their weight counts",
)


@record
class Analysis:
    """The shell as a structure."""

    REPORTED = (
        "carries", "model", "cases", "governs", "envelopes", "anchors", "warnings",
        "code_asks", "not_covered",
    )  # fmt: skip

    model: Model  # what is analysed
    cases: tuple[CaseResult, ...]  # all load cases, those with the least stiffness of creases first

    @property
    def not_covered(self) -> tuple[str, ...]:
        """What the analysis says nothing of."""
        asked = self.model.structure
        soft = any(found.path is not None for found, _ in self.balanced)
        first = FOLLOWED if asked.nonlinear else LINEAR_BUT_SOFT if soft else LINEAR
        thinned = ECCENTRIC if self.model.bevelled else ""
        bare = FOLDED if self.model.design.panel is None else ""
        clipped = CLIPPED_IN if self.model.design.plates else ""
        hung = HUNG_ON if self.model.design.carried else ""
        off = any(found.path is not None and found.path.imperfection for found, _ in self.balanced)
        known = IMPERFECT_BUT_SOFT if off else IMPERFECT
        built = IMPERFECT_FIT if asked.imperfection else known
        # Of plates that stiffen the sheet no grain is known.
        ways = "" if asked.has_grain and not self.model.plates else ONE_WAY
        parts = (thinned, bare, clipped, hung, built, ways)
        return (first, *(each for each in parts if each), *NOT_COVERED)

    @property
    def code_asks(self) -> tuple[str, ...]:
        """What codes ask of it, and is not done here."""
        return code_asks(self.model.structure)

    def asks_in_words(self) -> str:
        """What codes ask of it, and is not done here, by its names: for one line."""
        return asks_in_words(self.model.structure)

    @property
    def balanced(self) -> list[tuple[Equilibrium, CaseResult]]:
        """The cases in equilibrium, and what holds them."""
        return [(case.equilibrium, case) for case in self.cases if case.equilibrium is not None]

    @property
    def named_balanced(self) -> list[tuple[str, CaseResult]]:
        """The cases in equilibrium, each with what it is called."""
        return [(self.name_of(case), case) for _, case in self.balanced]

    @cached_property
    def anchors(self) -> tuple[Anchor, ...]:
        """What every support asks of the ground, by all cases in equilibrium."""
        return find_anchors(self.model, self.named_balanced)

    @cached_property
    def ranked(self) -> tuple[CaseResult, ...]:
        """All cases, the worst first."""
        used = classes([-each.used for each in self.cases], SOLVED)
        signs = np.array([ORDER.index(each.sign) for each in self.cases])
        return tuple(self.cases[k] for k in np.lexsort((used, signs)).tolist())

    @property
    def sign(self) -> Sign:
        """That of the worst case."""
        return self.ranked[0].sign

    @property
    def carries(self) -> bool | None:
        """Whether it carries all cases; None if that is not known."""
        return CARRIES[self.sign]

    @property
    def used(self) -> float | None:
        """The largest share of what is borne, above 1 where a case fails; None if it is not known.

        It is not where nothing fails, but a part is loaded whose strength is not given.
        """
        open_ = (each.excess is None for case in self.cases for each in case.findings)
        if self.carries is None and any(open_):
            return None
        return max(case.used for case in self.cases)

    @cached_property
    def governs(self) -> Governing | None:
        """What is nearest to the end of what it bears; None if that of nothing is known."""
        found = [
            Governing(used.governs, case.name, case.creases, used.shares[used.governs] or 0.0)
            for balanced, case in self.balanced
            if case.limit_state in STRENGTH
            if (used := balanced.utilisation).governs is not None
        ]
        return largest_of(found, lambda each: each.utilisation, SOLVED) if found else None

    def in_words(self) -> str:
        """Whether it carries all cases, and what the worst does: for one line."""
        first, fails = self.ranked[0], sum(case.sign == "fails" for case in self.cases)
        under = f"under {self.name_of(first)} it {first.said}"
        if fails:
            of = "" if len(self.cases) == 1 else f"{fails} of {len(self.cases)} cases fail; "
            return f"no: {of}{under}"
        if first.sign == "warns":
            return f"not known: {under}"
        found, case = largest_of(self.balanced, lambda each: each[0].displacement.size, SOLVED)
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
            return "nothing bears anything whose strength is known, and it does not buckle"
        share = governs.utilisation
        if governs.part == "buckling":
            borne = f"under {plain(1 / share, 3)} times the loads of"
        else:
            borne = f"{plain(100 * share, 3)} % of what can be borne, under"
        what = governing(governs.part, skin=self.model.has_skin)
        return f"{what} governs, {borne} {self.name_of(governs)}"

    @cached_property
    def envelopes(self) -> tuple[Envelope, ...]:
        """What governs each limit state of a code; none if no code combines the cases."""
        return tuple(envelopes(self.cases))

    @property
    def reported_cases(self) -> tuple[CaseResult, ...]:
        """The cases that are told in full, the worst first: all, or of many those that govern."""
        return reported_cases(self.ranked, self.envelopes, self.governs)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """Sentences an engineer should read, beside what speaks against single cases."""
        return (*self._warnings(), *warn_of_points(self.model, self.cases))

    def _warnings(self) -> Iterator[str]:
        yield from ground_warnings(self.model, self.anchors, self.named_balanced)
        yield from refinement_warnings(self.model.change, self.model.stopped, self.model.cells)
        yield from arm_warnings(self.model.structure, self.model.mesh)
        yield from membrane_warnings(self.model.design, self.model.structure)
        far = [self.name_of(case) for found, case in self.balanced if misleads(found)]
        if far:
            text = f"linear theory may mislead under {few(far)}"
            followed = self.model.mesh.offsets is None  # of whole boards they are not
            if followed:
                text += ": follow large displacements (nonlinear = true in [structure])"
            yield Note(text, "linear" if followed else None)
        yield from doubts_of_shell(self.model)
        said: dict[str, dict[str, None]] = {}
        for case in self.cases:
            for name, text in case.load_warnings():
                said.setdefault(text, {})[name] = None
        for text, names in said.items():
            every = names.keys() == {each.name for each in self.cases}
            which = "all load cases" if every else f"load cases {few(list(names))}"
            yield Note(f"{which}: {text}", text.about if isinstance(text, Note) else None)

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
        """The shell with its load cases as files and pages show it."""
        return loaded_shell(self.model, [(self.name_of(case), case) for case in self.cases])
