"""What to change in a refused design: every change is tried, through all that can refuse it.

A family knows what its own conditions leave open (``DesignError.candidates``), not whether panels
then meet, or whether the shell fits the stock and its ties. So each candidate is typed into the
file, and the shell made from it, before a message offers it; where that fails for a further reason,
that reason's candidates are tried on top, and so on. Between a value that works and a nearer one
that does not, a still nearer one is looked for.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial
from itertools import chain

from orishell.conventions.errors import (
    ClashError,
    DesignError,
    InputError,
    Remedy,
    Value,
    VerificationError,
)
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.families.shared.candidates import part
from orishell.locking import largest_quotable, reaches_target
from orishell.locking.motion_end import FINE, NARROWEST, OF_BOARDS
from orishell.shell.designed import designed
from orishell.shell.instead import shell_of
from orishell.shell.steps import Step, Work

MOST_REMEDIES = 3
"""Remedies that are offered at most."""
SECONDS, LONGER = 10.0, 2.0
"""Work after which no more are looked for (s); or so many times as much as was needed to refuse the
design, if that is longer."""
TRIALS, PANELS, SEARCHES = 18, 15_000, 3
"""Designs tried at most; of large sheets as many as have so many panels together, of files
whose rows and columns must be searched for so many."""
DEEPER = 2 * TRIALS
"""Designs after which no third change is tried on top of two."""
HALVINGS = 4
"""Trials between a value that works and a nearer one that does not."""
SMALLEST_CURVE = 0.05
"""Curves are offered no smaller than this share."""
THINNEST = 1e-2
"""Panels are offered no thinner than this share."""
COARSE = 2e-2
"""Accuracy of the largest size of a curve that works, relative to it."""
SHARES = (0.5, 0.25, 0.1)
"""Shares of a flap, or of a curve, tried on top of another change."""

UNMEASURED: tuple[Step, ...] = ("deviation",)
"""What is not found out of a shell that is tried: it refuses none."""
FORMULA = ("formula", "range", "scale")
"""Keys of a curve that is a formula."""


def with_remedies(
    file: DesignFile, refusal: DesignError, progress: Progress = no_progress, spent: float = 0.0
) -> DesignError:
    """Return the refusal with changes that were tried and work, or with why none does.

    spent: Time that it took to refuse the design (s).
    """
    search = _RemedySearch(file, progress, max(SECONDS, LONGER * spent))
    try:
        search.run(refusal)
    except _OutOfTimeError:
        search.ended = True
    refusal.remedies = tuple(search.found.values()) or search.farther
    if not refusal.remedies:
        refusal.limit = search.limit
    return refusal


class _OutOfTimeError(Exception):
    """The time for looking is over."""


@dataclass(slots=True)
class _RemedySearch:
    file: DesignFile
    progress: Progress
    seconds: float  # after which no more are looked for
    begun: float = field(default_factory=time.thread_time)
    tried: float = 0
    failures: list[tuple[Remedy, DesignError]] = field(default_factory=list)
    found: dict[frozenset[str], Remedy] = field(default_factory=dict)
    farther: tuple[Remedy, ...] = ()  # what works, too, where nothing nearer is found
    ended: bool = False

    @property
    def limit(self) -> str:
        """Why the first candidate does not work."""
        ended = f"looking ended after {self.seconds:.2g} s of work"
        if self.ended and not self.failures:
            return ended
        if not self.failures:
            needed = "f or g" if self.file.target else "sheet"
            why = f"another {needed} is needed"
        else:
            remedy, reason = self.failures[0]
            place = f", {reason.place}" if reason.place else ""
            why = f"with {remedy}, {reason.condition}{place}"
        return f"{why} ({ended})" if self.ended else why

    def run(self, refusal: DesignError) -> None:
        self._watch()
        if isinstance(refusal, ClashError):
            self._look(Remedy({}), chain(refusal.candidates, self._apart(refusal)), 1)
        else:
            self._look(Remedy({}), iter(refusal.candidates), MOST_REMEDIES)
        single = len(self.failures)
        # They grow by what is tried on top of them.
        for number, (remedy, reason) in enumerate(self.failures):
            if self.found or self.farther or (number >= single and self.tried >= DEEPER):
                break
            self._look(remedy, self._further(remedy, reason), 1)

    def _look(self, base: Remedy, candidates: Iterator[Remedy], most: int) -> None:
        """Find the nearest candidate of each set of keys that works together with ``base``."""
        nearer: dict[frozenset[str], Remedy] = {}
        for each in candidates:
            candidate = each | _in_place_of(self.file, each)
            keys = frozenset(candidate.changes)
            if any(keys >= simpler for simpler in self.found):
                continue
            reason = self._try(base | candidate)
            if reason is None:
                self.found[keys] = base | candidate
                if keys in nearer:
                    self._approach(base, keys, candidate, nearer[keys])
            else:
                nearer[keys] = candidate
                self.failures.append((base | candidate, reason))
            if len(self.found) == most or self.tried >= TRIALS:
                break

    def _approach(self, base: Remedy, keys: frozenset[str], works: Remedy, fails: Remedy) -> None:
        """Come nearer to a number that does not work from one that does."""
        differing = [key for key in keys if works.changes[key] != fails.changes[key]]
        if len(differing) != 1:
            return
        (key,) = differing
        good, bad = works.changes[key], fails.changes[key]
        for _ in range(HALVINGS):
            middle = _middle(good, bad)
            if middle in (good, bad, None):
                break
            remedy = base | works | Remedy({key: middle})
            if self._try(remedy) is None:
                good, self.found[keys] = middle, remedy
            else:
                bad = middle

    def _try(self, remedy: Remedy) -> DesignError | None:
        """Why a change does not work; None if it does."""
        self.tried += 1 if self.file.tolerance is None else TRIALS // SEARCHES
        self._watch()
        try:
            changed = self.file.tried(remedy.changes)
            self.tried += changed.panel_count * TRIALS // PANELS
            shell_of(changed, Work(self._watch, skip=UNMEASURED))
        except DesignError as error:
            return error
        except InputError as error:
            return DesignError(error.what)
        except VerificationError as error:  # a design at the edge of what numbers can say
            return DesignError(str(error))
        return None

    def _watch(self, share: float = 0.0, what: str = "") -> None:
        """Tell how far the search is, and end it when its time is over."""
        self.progress(min(1.0, self.tried / TRIALS), "looking for what works")
        if time.thread_time() > self.begun + self.seconds:
            raise _OutOfTimeError

    def _further(self, remedy: Remedy, reason: DesignError) -> Iterator[Remedy]:
        """Changes on top of one that is refused for another reason."""
        yield from reason.candidates
        if isinstance(reason, ClashError):
            yield from _coarsely(_numbers(self.file.tried(remedy.changes), reason))

    def _apart(self, clash: ClashError) -> Iterator[Remedy]:
        """The widest flaps, the thickest panels, the largest f and part of g that do not meet."""
        file = self.file
        large = file.panel_count > PANELS / TRIALS and not clash.thick
        slow = self.seconds > SECONDS
        for number in _numbers(file, clash):
            if number.of_flaps:
                without = number.change(0.0)
                reason = self._try(without)
                if isinstance(reason, ClashError):
                    continue  # no width of flaps helps
                self.farther = () if reason else (without,)
            if large or slow or file.fit is not None or file.tolerance is not None:
                yield from _coarsely([number])
                continue
            works = partial(self._clear, number)
            found = largest_quotable(works, number.asked, number.smallest, number.accuracy)
            if found is not None:
                yield number.change(found)

    def _clear(self, number: _Number, value: float) -> bool:
        """Whether a shell can be designed with another number, and does not meet on its way.

        Flaps alone are looked at, where the number is theirs.
        """
        self._watch()
        try:
            design = designed(self.file.tried(number.change(value).changes))
        except (DesignError, InputError):
            return False
        tolerance = self.file.contact_tolerance
        return reaches_target(design, tolerance, flaps_only=number.of_flaps)


def _middle(good: Value | None, bad: Value | None) -> Value | None:
    """The number midway; None between what are none. Of odd numbers, as rows are, it is odd."""
    match good, bad:
        case float(), float():
            return rounded(0.5 * (good + bad))
        case int(), int():
            step = 2 if good % 2 and bad % 2 else 1
            return good + step * round((bad - good) / (2 * step))
    return None


def _in_place_of(file: DesignFile, remedy: Remedy) -> Remedy:
    """Without what a curve was drawn from, where a formula takes its place."""
    tables = [key.removesuffix(".formula") for key in remedy.changes if key.endswith(".formula")]
    return Remedy(
        {
            f"{table}.{key}": None
            for table in tables
            for key in value_at(file.tables, table) or ()
            if key not in FORMULA
        }
    )


@record
class _Number:
    """A number that is made smaller until panels do not meet."""

    asked: float
    change: Callable[[float], Remedy]  # what the file says for another one
    smallest: float = SMALLEST_CURVE  # share of it that is looked for
    accuracy: float = COARSE  # to this share of it
    of_flaps: bool = False  # whether only flaps depend on it


def _numbers(file: DesignFile, clash: ClashError) -> Iterator[_Number]:
    """What keeps panels apart if it is smaller: flaps, panels, f, the part of g that is kept."""
    if clash.flap:
        fine = FINE if file.panel is None else OF_BOARDS
        yield _Number(clash.flap, partial(_written, "pattern.flap"), NARROWEST, fine, True)
    if clash.thick:
        assert file.panel is not None
        thickness, membrane = file.panel.thickness, file.panel.membrane
        thinnest = max(THINNEST, 2 * membrane / thickness)
        yield _Number(thickness, partial(_written, "panel.thickness"), thinnest)
    elif file.target is not None and file.fit is None:  # a fit scales f and g again
        f, g = file.target
        yield _Number(1.0, lambda share: _written("target.f.scale", f.scale_times(share)))
        yield _Number(
            1.0, lambda share: part("g", g, g.start, g.start + share * (g.stop - g.start))
        )


def _coarsely(numbers: Iterable[_Number]) -> Iterator[Remedy]:
    """Much smaller numbers."""
    for each in numbers:
        yield from (each.change(rounded(share * each.asked)) for share in SHARES)


def _written(key: str, value: Value) -> Remedy:
    return Remedy({key: value})
