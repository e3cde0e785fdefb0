"""A design that carries its loads, found from one that does not, or is not known to.

Changes are made one after the other in the order of a builder, and in that of a designer who may
choose the shape first. One stays if with it the shell is nearer to what it bears; where a shell
carries, what it does not need is taken away again. All trials are made of whole shells with few
cells; what is offered is then made and analysed as the file asks, contact and pack included. The
search ends after so much predicted work: no clock decides, and what was tried is said. Strengths
that the file does not give come first: without them nothing is ever known to carry.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain, repeat

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress, rising, stretch
from orishell.design_file import DesignFile
from orishell.shell.analyse import require_structure
from orishell.shell.carry_boards import as_sold, offer, thickness_key
from orishell.shell.carry_change import Change, Step, together
from orishell.shell.carry_found import (
    Carrying,
    CarrySearch,
    ended,
    left_to_supports,
    parts_on_site,
)
from orishell.shell.carry_state import State
from orishell.shell.carry_steps import BUILDER, DESIGNER, LIGHTER
from orishell.shell.carry_strengths import MAKES_KNOWN, in_words, not_given, refuse, require_known
from orishell.shell.facts import Facts
from orishell.shell.instead import shell_of, trying
from orishell.shell.load_trials import LOADED, LoadTrials, Refused
from orishell.structure.results import Analysis

ROUNDS = 3
"""So many times all steps of an order are taken, as one may help after another."""
WORK = 90.0
"""Beyond so many predicted seconds nothing more is tried, and in the first order beyond half."""
SPARING = 0.9
"""Where none of what carries with few cells does with those of the file, it may use so much."""
LEFT = 8.0
"""So many predicted seconds are left at least for what a shell that carries does not need."""
PER_PANEL = 0.012
"""Predicted seconds in which a panel is designed, beside its analysis."""
OFFERED, CONFIRMED = 3, 6
"""So many designs are offered at most, and so many tried as the file asks in search of them."""
Tell = Callable[[tuple[str, ...]], None]
PACKED = tuple(each for each in LOADED if each != "pack")


def _ignored(_: tuple[str, ...]) -> None:
    """Tell nobody."""


def find_carrying(
    file: DesignFile, progress: Progress = no_progress, tell: Tell = _ignored
) -> CarrySearch:
    """Designs that carry all cases of a file, the lightest first, or what was tried in vain.

    tell: Is told what was tried so far, with each trial that ends.
    Raises InputError, DesignError or VerificationError if the file itself cannot be made, and
    DesignError if a strength is not given that no change makes known.
    """
    require_structure(file)
    require_known(file)
    progress = rising(progress)
    made = shell_of(file, trying(stretch(progress, 0.0, 0.1), "analysing the file", LOADED))
    assert made.analysis is not None
    if made.analysis.carries:
        return CarrySearch(made.analysis, (), (), None, ended=False)
    return _Search(file, made.analysis, progress, tell).run()


class _Search:
    def __init__(self, file: DesignFile, begun: Analysis, progress: Progress, tell: Tell) -> None:
        self.file, self.begun, self.progress, self.tell = file, begun, progress, tell
        self.trials = LoadTrials(file, begun, self._tell)
        self.known: dict[str, State | Refused] = {}
        self.tried: list[str] = []
        self.carrying: list[State] = []
        self.nearest: State | None = None
        self.panels, self.until, self.ended = 0.0, WORK, False
        self.most = 1.0  # of what it bears, a shell of few cells may use so much

    @property
    def work(self) -> float:
        """Predicted seconds of all trials so far."""
        return self.trials.work + PER_PANEL * self.panels

    def _tell(self, _share: float, what: str) -> None:
        self.progress(min(0.99, 0.1 + 0.8 * self.work / WORK), what)

    def _note(self, words: str, ended: str) -> None:
        """Keep how a trial ended."""
        self.tried.append(f"{words}: {ended}")
        self.tell(tuple(self.tried))

    def run(self) -> CarrySearch:
        first = self._trial((), "the file")
        if isinstance(first, State):
            first = self._made_known(first)
            for order, share in ((BUILDER, 0.5), (DESIGNER, 1.0)):
                self.until = share * WORK
                self._walk(first, order)
        found = self._confirmed()
        if self.carrying and not found and isinstance(first, State):
            # With more cells it uses more than it bears: what is found with less is to spare some.
            self.most, self.carrying = SPARING, []
            for order in (BUILDER, DESIGNER):
                self.until = max(WORK, self.work + LEFT)
                self._walk(first, order)
            found = self._confirmed()
        best = None if found else self.nearest
        near = None if best is None else (best.change, best.analysis)
        return CarrySearch(self.begun, found, tuple(self.tried), near, self.ended)

    def _made_known(self, at: State) -> State:
        """The shell without that of which nobody knows what it bears; else DesignError."""
        missing, why = not_given(at.file), ""
        if missing:
            self._note(f"{in_words(missing)} is not given", "first what does without that is tried")
        for step, parts in MAKES_KNOWN:
            for change in step(at.file, at.analysis) if parts & set(not_given(at.file)) else ():
                made = self._changed(at, change)
                at = made or at
                if made is None:
                    why = f"; tried without it, {self.tried[-1].partition(' + ')[2]}"
                    continue
                break
        refuse(not_given(at.file), why)
        self.nearest = at if missing else self.nearest
        return at

    def _walk(self, at: State, order: Sequence[Step]) -> None:
        """Take every step that brings the shell nearer to carrying, until it does."""
        begun = len(at.changes)
        for step in chain.from_iterable(repeat(order, ROUNDS)):
            at = self._best(at, step, State.is_nearer) or at
            if self._carries(at) or self.work > self.until:
                self.ended = self.ended or not self._carries(at)
                break
        if not self._carries(at):
            return
        self.carrying.append(at)
        self.until = max(self.until, self.work + LEFT)
        at = self._without_useless(at, begun)
        for step in LIGHTER:
            lighter = self._best(at, step, self._is_lighter)
            if lighter is not None:
                at = lighter
                self.carrying.append(at)

    def _carries(self, at: State) -> bool:
        """Whether a shell of few cells carries, and uses no more of what it bears than it may."""
        return at.carries and at.lacks[-1] <= self.most

    def _is_lighter(self, new: State, old: State) -> bool:
        return self._carries(new) and new.weight < old.weight

    def _rank(self, at: State) -> tuple[bool, tuple[float, ...], tuple[float, int]]:
        """By which those that one step proposes are ranked: what carries by its weight."""
        carries = self._carries(at)
        return not carries, () if carries else at.lacks, at.weight

    def _without_useless(self, at: State, begun: int) -> State:
        """A shell that carries without the changes that it carries without, at no more weight.

        begun: So many changes are not taken back; the last of the others is first.
        """
        for change in reversed(at.changes[begun:]):
            after = at.changes[at.changes.index(change) + 1 :] if change in at.changes else ()
            replaced = change.said.keys() <= {kind for each in after for kind in each.said}
            if replaced or change not in at.changes or self.work > self.until:
                continue
            rest = tuple(each for each in at.changes if each != change)
            made = self._trial(rest, f"{at.name} - {change.words}")
            if isinstance(made, State) and self._carries(made) and made.weight <= at.weight:
                at = made
                self.carrying.append(at)
        return at

    def _best(self, at: State, step: Step, better: Callable[[State, State], bool]) -> State | None:
        """The best of what a step proposes; None if nothing is better than what there is."""
        found = []
        for change in step(at.file, at.analysis):
            if self.work > self.until:
                self.ended = True
                break
            state = self._changed(at, change)
            if state is not None and better(state, at):
                found.append(state)
        return min(found, key=self._rank, default=None)

    def _changed(self, at: State, change: Change) -> State | None:
        """A shell with one more change, or with what its refusal offers in its place."""
        made = self._trial((*at.changes, change), f"{at.name} + {change.words}")
        if isinstance(made, Refused):
            other = self._fitting(at.change, change, made)
            if other is not None:
                made = self._trial((*at.changes, other), f"{at.name} + {other.words}")
        return None if isinstance(made, Refused) else made

    def _trial(self, changes: tuple[Change, ...], words: str) -> State | Refused:
        """A changed shell with few cells, or why it is none. No change is tried twice.

        words: What is changed of which trial.
        """
        whole = together(changes)
        key = repr(sorted(whole.values.items()))
        if key in self.known:
            return self.known[key]
        name = str(len(self.known)) if changes else words
        said = f"{name} = {words}" if changes else words
        made: Facts | Refused
        if changes and changes[-1].refused:
            made = Refused(changes[-1].refused)
        else:
            made = self.trials.made(whole.values, said, quick=True)
            self.panels += self.file.panel_count
        if isinstance(made, Refused):
            self.known[key] = Refused(made.why)  # what it offers is tried once
            self._note(said, f"cannot be made, as {made.why}")
            return made
        assert made.analysis is not None
        state = State(name, changes, self.file.tried(whole.values), made, made.analysis)
        self.known[key] = state
        self._note(said, ended(state.analysis))
        if self.nearest is None or state.lacks < self.nearest.lacks:
            self.nearest = state
        return state

    def _fitting(self, before: Change, change: Change, refused: Refused) -> Change | None:
        """What a refusal offers in place of a change, as it is sold; None if it offers nothing."""
        offered = next(iter(refused.candidates), None)
        fitted = None if offered is None else change.fitted(offered, thickness_key(self.file))
        if fitted is None:
            return None
        try:
            made = self.file.tried((before | fitted).values)
        except InputError:
            return None
        return as_sold(self.file, offer(made, self.begun.model), fitted)

    def _confirmed(self) -> tuple[Carrying, ...]:
        """Those that carry as the file asks, too, the lightest first; none that another beats."""
        found: list[Carrying] = []
        trials = 0
        # What both orders came to is one design.
        for state in sorted(dict.fromkeys(self.carrying), key=lambda each: each.weight):
            changes = len(state.change.values)
            if any(each.beats(*state.weight, changes) for each in found):
                continue
            if len(found) == OFFERED or trials == CONFIRMED:
                self.ended = self.ended or not found
                break
            trials += 1
            words = f"{state.name} with cells as the file asks"
            made = self.trials.made(state.change.values, words, quick=False, skip=PACKED)
            if isinstance(made, Refused):
                self._note(words, f"cannot be made, as {made.why}")
                continue
            assert made.analysis is not None
            self._note(words, ended(made.analysis))
            if not made.analysis.carries:
                continue
            packed = made.deployment.packed
            box = None if packed is None else (packed.length, packed.width, packed.height)
            left = left_to_supports(made)
            found.append(Carrying(state.change, made.analysis, parts_on_site(made), box, left))
        return tuple(found)
