"""What to change in a refused design: every change is tried, through all that can refuse it.

A family knows what its own conditions leave open (``DesignError.candidates``), not whether panels
then meet, or whether the shell fits the stock and its ties. So each candidate is typed into the
file, and the shell made from it, before a message offers it; where that fails for a further reason,
that reason's candidates are tried on top. Between a value that works and a nearer one that does
not, a still nearer one is looked for.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import chain

from orishell.conventions.errors import (
    ClashError,
    DesignError,
    InputError,
    Remedy,
    VerificationError,
)
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.locking import largest_quotable, reaches_target, widest_flap
from orishell.shell.designed import designed
from orishell.shell.instead import shell_of
from orishell.shell.steps import Step, Work

MOST_REMEDIES = 3
"""Remedies that are offered at most."""
SECONDS = 10.0
"""Work after which no more are looked for (s)."""
TRIALS, PANELS, SEARCHES = 18, 15_000, 3
"""Designs tried at most; of large sheets as many as have so many panels together, of files
whose rows and columns must be searched for so many."""
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
    file: DesignFile, refusal: DesignError, progress: Progress = no_progress
) -> DesignError:
    """Return the refusal with changes that were tried and work, or with why none does."""
    search = _RemedySearch(file, progress)
    try:
        search.run(refusal)
    except _OutOfTimeError:
        search.ended = True
    refusal.remedies = tuple(search.found.values())
    if not refusal.remedies:
        refusal.limit = search.limit
    return refusal


class _OutOfTimeError(Exception):
    """The time for looking is over."""


@dataclass(slots=True)
class _RemedySearch:
    file: DesignFile
    progress: Progress
    until: float = field(default_factory=lambda: time.thread_time() + SECONDS)
    tried: float = 0
    failures: list[tuple[Remedy, DesignError]] = field(default_factory=list)
    found: dict[frozenset[str], Remedy] = field(default_factory=dict)
    ended: bool = False

    @property
    def limit(self) -> str:
        """Why the first candidate does not work."""
        if not self.failures:
            needed = "f or g" if self.file.target else "sheet"
            why = f"another {needed} is needed"
        else:
            remedy, reason = self.failures[0]
            place = f", {reason.place}" if reason.place else ""
            why = f"with {remedy}, {reason.condition}{place}"
        return f"{why} (looking ended after {SECONDS:g} s of work)" if self.ended else why

    def run(self, refusal: DesignError) -> None:
        self._watch()
        if isinstance(refusal, ClashError):
            self._look(Remedy({}), chain(refusal.candidates, self._apart(refusal)), 1)
        else:
            self._look(Remedy({}), iter(refusal.candidates), MOST_REMEDIES)
        for remedy, reason in list(self.failures):
            if self.found:
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
                if not base.changes:
                    self.failures.append((candidate, reason))
            if len(self.found) == most or self.tried >= TRIALS:
                break

    def _approach(self, base: Remedy, keys: frozenset[str], works: Remedy, fails: Remedy) -> None:
        """Come nearer to a number that does not work from one that does."""
        if len(keys) != 1:
            return
        (key,) = keys
        good, bad = works.changes[key], fails.changes[key]
        if not (isinstance(good, float) and isinstance(bad, float)):
            return
        for _ in range(HALVINGS):
            middle = rounded(0.5 * (good + bad))
            if middle in (good, bad):
                break
            remedy = base | Remedy({key: middle})
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
        if time.thread_time() > self.until:
            raise _OutOfTimeError

    def _further(self, remedy: Remedy, reason: DesignError) -> Iterator[Remedy]:
        yield from reason.candidates
        if isinstance(reason, ClashError):
            yield from _shrunk(self.file.tried(remedy.changes), reason.flap)

    def _apart(self, clash: ClashError) -> Iterator[Remedy]:
        """The widest flaps, the largest f and the longest part of g that keep panels apart."""
        file = self.file
        if clash.thick:
            if file.fit is not None:
                yield from _shrunk(file, clash.flap)
                yield from _thinned(file)
                return
            if clash.flap:
                yield from self._narrower()
            yield from self._thinner()
            return
        if file.target is None:
            return
        if file.fit is not None or file.tolerance is not None or file.panel_count > PANELS / TRIALS:
            yield from _shrunk(file, clash.flap)
            return
        # Where the sheet meets itself without flaps, no width of flaps helps.
        if clash.flap and self._reaches_target(Remedy({"pattern.flap": 0.0})):
            yield from self._narrower()
        for resized in (_scaled_f, _shortened_g):

            def works(share: float, resized: Resized = resized) -> bool:
                return self._reaches_target(resized(file, share))

            share = largest_quotable(works, 1.0, SMALLEST_CURVE, COARSE)
            if share is not None:
                yield resized(file, share)

    def _narrower(self) -> Iterator[Remedy]:
        """The widest flaps that meet nothing."""

        def narrower(width: float) -> Design:
            self._watch()
            return designed(self.file.tried({"pattern.flap": width}))

        tolerance = self.file.contact_tolerance
        width = widest_flap(designed(self.file), narrower, tolerance)
        if width is not None:
            yield Remedy({"pattern.flap": width})

    def _thinner(self) -> Iterator[Remedy]:
        """The thickest panels whose boards do not meet."""
        panel = self.file.panel
        assert panel is not None

        def works(thickness: float) -> bool:
            return self._reaches_target(Remedy({"panel.thickness": thickness}))

        smallest = max(THINNEST, 2 * panel.membrane / panel.thickness)
        found = largest_quotable(works, panel.thickness, smallest, COARSE)
        if found is not None:
            yield Remedy({"panel.thickness": found})

    def _reaches_target(self, remedy: Remedy) -> bool:
        """Whether a changed shell can be designed, and its panels meet not before its target."""
        self._watch()
        try:
            design = designed(self.file.tried(remedy.changes))
        except (DesignError, InputError):
            return False
        return reaches_target(design, self.file.contact_tolerance)


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


def _shrunk(file: DesignFile, flap: float) -> Iterator[Remedy]:
    """Much narrower flaps, a much smaller f, a much shorter g."""
    if file.target is None:
        return
    if flap:
        yield from (Remedy({"pattern.flap": rounded(share * flap)}) for share in SHARES)
    if file.fit is not None:  # which scales f and g again
        return
    yield from (_scaled_f(file, share) for share in SHARES)
    yield from (_shortened_g(file, share) for share in SHARES)


def _thinned(file: DesignFile) -> Iterator[Remedy]:
    """Much thinner panels."""
    assert file.panel is not None
    thickness = file.panel.thickness
    yield from (Remedy({"panel.thickness": rounded(share * thickness)}) for share in SHARES)


Resized = Callable[[DesignFile, float], Remedy]


def _scaled_f(file: DesignFile, share: float) -> Remedy:
    return Remedy({"target.f.scale": file.f.scale_times(share)})


def _shortened_g(file: DesignFile, share: float) -> Remedy:
    g = file.g
    low, high = g.drawn_part(g.start, g.start + share * (g.stop - g.start))
    return Remedy({f"target.g.{g.key}": [rounded(low, 10), rounded(high, 10)]})
