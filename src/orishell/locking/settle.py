"""Designs whose panels meet nothing before they lock: how wide flaps can be, or what to change."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from orishell.curves import Curve
from orishell.design import Design
from orishell.errors import DesignError
from orishell.locking.lock import CONTACT_TOLERANCE, Contact, Lock, find_lock
from orishell.quoting import in_degrees, in_one_line

Auto = Literal["auto"]
Progress = Callable[[float], None]

NARROWEST = 1e-3
"""Flaps narrower than this share of what was asked for are of no use."""
SMALLEST = 0.05
"""Curves are offered no smaller than this share."""
FINE, COARSE = 1e-3, 2e-2
"""To this share the nearest width of flaps, or size of a curve, is found."""


@dataclass(frozen=True, slots=True, eq=False)
class Request:
    """What a shell is asked for, so that it can be asked for a little differently.

    Parameters
    ----------
    design
        Designs the shell from f, g and the width of the flaps.
    f, g
        The target curves.
    flap
        Width of the flaps; "auto" is as wide as the family finds useful and as meets nothing.
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    """

    design: Callable[[Curve, Curve, float | Auto], Design]
    f: Curve
    g: Curve
    flap: float | Auto
    tolerance: float = CONTACT_TOLERANCE

    __repr__ = in_one_line

    def made(self) -> Design:
        """The design."""
        return self.design(self.f, self.g, self.flap)

    def locks(self, *, flaps_only: bool = False) -> bool:
        """Whether it can be made and meets nothing (``flaps_only``: no flap) before its target."""
        try:
            design = self.made()
        except DesignError:
            return False
        return not find_lock(design, tolerance=self.tolerance, flaps_only=flaps_only).early


def settle(
    request: Request,
    design: Design,
    *,
    allow_clash: bool = False,
    advanced: Progress | None = None,
) -> tuple[Design, Lock]:
    """Find how a design's motion ends, with narrower flaps if these may be chosen and must be.

    Parameters
    ----------
    request
        What is asked for.
    design
        What was made of it.
    allow_clash
        Return the design even if panels meet before it locks.
    advanced
        Called with the share of the path that is done.

    Raises
    ------
    DesignError
        If panels meet before it locks: which, where, and the nearest flaps or curve with which
        they do not.
    """
    lock = find_lock(design, tolerance=request.tolerance, advanced=advanced)
    if lock.early and request.flap == "auto":
        width = _widest_flap(request, design)
        if width is not None:
            design = replace(request, flap=width).made()
            lock = find_lock(design, tolerance=request.tolerance, advanced=advanced)
    if lock.early and not allow_clash:
        raise _refusal(request, design, lock)
    return design, lock


def _refusal(request: Request, design: Design, lock: Lock) -> DesignError:
    contact = lock.first_contact
    assert contact is not None
    first, second = (list(panel) for panel in contact.panels)
    at, target = in_degrees(contact.drive), in_degrees(lock.target)
    if contact.drive == 0:
        return DesignError(
            "panels of the flat sheet touch",
            place=f"panels {first} and {second}",
            nearest="a smaller contact_tolerance, or longer creases",
        )
    return DesignError(
        f"panels {first} and {second} meet before the shell reaches its target ({contact.kind})",
        place=f"at drive {at} of {target} degrees",
        size=f"the corrugation is {contact.depth:.4g} deep there, {lock.depth:.4g} at the target",
        nearest=f"{_nearest(request, design, contact)}; --allow-clash writes it as it is",
    )


def _nearest(request: Request, design: Design, contact: Contact) -> str:
    """The nearest flaps, f or part of g that meet nothing, found by trying them."""
    # Where the sheet meets itself without flaps, no width of flaps helps.
    if "flap" in contact.kind and replace(request, flap=0.0).locks():
        width = _widest_flap(request, design)
        if width is not None and replace(request, flap=width).locks():
            return f"flap = {width:.4g}"
    scale = _largest(
        lambda scale: replace(request, f=request.f.scaled(scale)).locks(), 1.0, SMALLEST, COARSE
    )
    if scale is not None:
        return f"scale in [target.f] times {scale:.4g} (scale is 1 where none is given)"
    start, stop = request.g.start, request.g.stop

    def part(length: float) -> Curve:
        end = start + length
        inner = tuple(at for at in request.g.breaks if at < end)
        return replace(request.g, stop=end, breaks=inner)

    length = _largest(
        lambda length: replace(request, g=part(length)).locks(), stop - start, SMALLEST, COARSE
    )
    if length is not None:
        return f"the part of g from parameter {start:.10g} to {part(length).stop:.10g}"
    return "an f and a g that keep farther from themselves"


def _widest_flap(request: Request, design: Design) -> float | None:
    """The widest flaps below those of a design that meet nothing themselves."""
    asked = design.parameters["flap"]
    assert isinstance(asked, float | int)
    if asked <= 0:
        return None
    return _largest(
        lambda width: replace(request, flap=width).locks(flaps_only=True), asked, NARROWEST, FINE
    )


def _largest(
    works: Callable[[float], bool], most: float, smallest: float, step: float
) -> float | None:
    """The largest value below the most that works, None if none down to a share of it does.

    Rounded down to the four digits that messages show if that works too.
    """
    good, bad = 0.5 * most, most
    while not works(good):
        good, bad = 0.5 * good, good
        if good < smallest * most:
            return None
    while bad - good > step * good:
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if works(middle) else (good, middle)
    unit = 10.0 ** (np.floor(np.log10(good)) - 3)
    tidy = float(f"{np.floor(good / unit) * unit:.4g}")
    return tidy if works(tidy) else good
