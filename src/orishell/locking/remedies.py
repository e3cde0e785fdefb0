"""What to change in a refused design: every change is tried, through to the proof of its path.

A family knows what its own conditions leave open (``DesignError.candidates``), not whether panels
then meet. So each candidate is designed and its path proved before a message offers it; where that
fails for a further reason, that reason's candidates are tried on top.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import chain

from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress, unwatched
from orishell.errors import ClashError, DesignError, InputError, Remedy
from orishell.locking.flap_widths import largest_quotable, reaches_target, widest_flap
from orishell.locking.motion_end import end_motion, require_pack
from orishell.locking.request import Request

MOST = 3
"""Remedies that are offered at most."""
TRIALS, PANELS, SEARCHES = 18, 15_000, 3
"""Designs tried at most; of large sheets as many as have so many panels together, of requests
whose rows and columns must be searched for so many."""
SMALLEST = 0.05
"""Curves are offered no smaller than this share."""
THINNEST = 1e-2
"""Panels are offered no thinner than this share."""
COARSE = 2e-2
"""Accuracy of the largest size of a curve that works, relative to it."""
SHARES = (0.5, 0.25, 0.1)
"""Shares of a flap, or of a curve, tried on top of another change."""


def with_remedies(
    request: Request, refusal: DesignError, progress: Progress = unwatched
) -> DesignError:
    """Return the refusal with changes that were tried and work, or with why none does."""
    search = _Search(request, progress)
    refusal.remedies = search.run(refusal)
    if not refusal.remedies:
        refusal.limit = search.limit
    return refusal


@dataclass(slots=True)
class _Search:
    request: Request
    progress: Progress
    tried: int = 0
    failures: list[tuple[Remedy, DesignError]] = field(default_factory=list)

    @property
    def limit(self) -> str:
        """Why the first candidate does not work."""
        if not self.failures:
            needed = "f or g" if self.request.target else "sheet"
            return f"another {needed} is needed"
        remedy, reason = self.failures[0]
        place = f", {reason.place}" if reason.place else ""
        return f"with {remedy}, {reason.condition}{place}"

    def run(self, refusal: DesignError) -> tuple[Remedy, ...]:
        if isinstance(refusal, ClashError):
            apart = chain(refusal.candidates, _apart(self.request, refusal))
            found = self._working(Remedy({}), apart, 1)
        else:
            found = self._working(Remedy({}), iter(refusal.candidates), MOST)
        for remedy, reason in list(self.failures):
            if found:
                break
            found = self._working(remedy, self._further(remedy, reason), 1)
        return tuple(found)

    def _working(self, base: Remedy, candidates: Iterator[Remedy], most: int) -> list[Remedy]:
        """The first candidate for each set of keys that works together with ``base``."""
        found: dict[frozenset[str], Remedy] = {}
        for candidate in candidates:
            keys = frozenset(candidate.changes)
            if any(keys >= simpler for simpler in found):
                continue
            reason = self._try(base | candidate)
            if reason is None:
                found[keys] = base | candidate
            elif not base.changes:
                self.failures.append((candidate, reason))
            if len(found) == most or self.tried >= TRIALS:
                break
        return list(found.values())

    def _try(self, remedy: Remedy) -> DesignError | None:
        """Why a change does not work; None if it does."""
        self.tried += 1 if self.request.quick else TRIALS // SEARCHES
        try:
            request = self.request.changed(remedy).sized()
            design = request.designed()
            self.tried += design.mechanism.grid.panel_count * TRIALS // PANELS
            design, lock = end_motion(design, request)
            if request.from_pack:
                require_pack(design, lock)
        except DesignError as error:
            return error
        except InputError as error:
            return DesignError(error.what)
        finally:
            self.progress(min(1.0, self.tried / TRIALS), "looking for what works")
        return None

    def _further(self, remedy: Remedy, reason: DesignError) -> Iterator[Remedy]:
        yield from reason.candidates
        if isinstance(reason, ClashError):
            yield from _shrunk(self.request.changed(remedy), reason.flap)


def _apart(request: Request, clash: ClashError) -> Iterator[Remedy]:
    """Changes that keep panels apart: the widest flaps, the largest f, the longest part of g."""
    if clash.thick:
        if clash.flap:
            width = widest_flap(request, request.designed(), boards=True)
            yield from [] if width is None else [Remedy({"pattern.flap": width})]
        yield from _thinner(request)
        return
    if request.target is None:
        return
    design = request.designed() if request.quick else None
    if design is None or design.mechanism.grid.panel_count > PANELS / TRIALS:
        yield from _shrunk(request, clash.flap)
        return
    # Where the sheet meets itself without flaps, no width of flaps helps.
    if clash.flap and reaches_target(request.changed(Remedy({"pattern.flap": 0.0}))):
        width = widest_flap(request, design)
        if width is not None:
            yield Remedy({"pattern.flap": width})
    for resized in (_scaled_f, _shortened_g):

        def works(share: float, resized: Resized = resized) -> bool:
            return reaches_target(request.changed(resized(request, share)))

        share = largest_quotable(works, 1.0, SMALLEST, COARSE)
        if share is not None:
            yield resized(request, share)


def _thinner(request: Request) -> Iterator[Remedy]:
    """The thickest panels whose boards do not meet."""
    panel = request.panel
    assert panel is not None

    def works(thickness: float) -> bool:
        return reaches_target(request.changed(Remedy({"panel.thickness": thickness})))

    smallest = max(THINNEST, 2 * panel.membrane / panel.thickness)
    found = largest_quotable(works, panel.thickness, smallest, COARSE)
    if found is not None:
        yield Remedy({"panel.thickness": found})


def _shrunk(request: Request, flap: float) -> Iterator[Remedy]:
    """Much narrower flaps, a much smaller f, a much shorter g."""
    if request.target is None:
        return
    if flap:
        yield from (Remedy({"pattern.flap": rounded(share * flap)}) for share in SHARES)
    yield from (_scaled_f(request, share) for share in SHARES)
    yield from (_shortened_g(request, share) for share in SHARES)


Resized = Callable[[Request, float], Remedy]


def _scaled_f(request: Request, share: float) -> Remedy:
    assert request.target is not None
    return Remedy({"target.f.scale": request.target[0].scale_times(share)})


def _shortened_g(request: Request, share: float) -> Remedy:
    assert request.target is not None
    _, g = request.target
    low, high = g.drawn_part(g.start, g.start + share * (g.stop - g.start))
    return Remedy({f"target.g.{g.key}": [rounded(low, 10), rounded(high, 10)]})
