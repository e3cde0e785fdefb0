"""Figures of the report that designs are compared by: a few by name, all numbers by their key."""

from __future__ import annotations

import dataclasses
import types
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, Union, get_args, get_origin

from orishell.conventions.meant import no_such
from orishell.conventions.record import Angle, read_key, written_fields
from orishell.design_file.search import Limit
from orishell.shell.report import Report
from orishell.shell.steps import Step
from orishell.structure.case import CaseResult
from orishell.structure.combinations import LimitState
from orishell.structure.equilibrium import Equilibrium

Read = Callable[[Report], float | None]
Share = Callable[[Equilibrium], float | None]


@dataclass(frozen=True, slots=True)
class Figure:
    """A number of the report."""

    name: str  # its name or key, as the design file has it
    # its unit, "{unit}" standing for that of lengths; empty where it has none, or may have any
    unit: str
    part: Step | None  # what a shell cannot leave out for it; None if it always has it
    read: Read  # gives it; None where the report does not say it

    def label(self, unit: str) -> str:
        """Its name in words, and its unit, where that of lengths is given."""
        words = self.name.replace("_", " ").replace(".", " under " if self.unit else ".")
        return f"{words} ({self.unit.format(unit=unit)})" if self.unit else words


def figure(name: str) -> Figure:
    """A figure by its name, or by its key in the report.

    name: One of :data:`NAMES`, of a load case with its name behind a dot; or keys from the
        outermost table of the report, joined by dots.

    Raises InputError if the report has no such number.
    """
    if name in _OF_SHELL:
        return Figure(name, *_OF_SHELL[name])
    worst, _, case = name.partition(".")
    if worst in _OF_CASE:
        unit, share = _OF_CASE[worst]
        state: LimitState = "SLS" if worst == "deflection" else "ULS"
        return Figure(name, unit, "structure", _worst(share, case, state))
    if name not in _keys():
        expected = f"{', '.join(NAMES)}, or the key of a number in report.json"
        known = [*NAMES, *_keys()]
        raise no_such("the report has no such figure", name, known, expected=expected)
    keys = name.split(".")

    def read_at(report: Report) -> float | None:
        value: Any = report
        for key in keys:
            value = read_key(value, key) if value is not None else None
        return float(value) if isinstance(value, int | float) else None

    return Figure(name, "", _part_of(name), read_at)


def _deviation(report: Report) -> float | None:
    found = report.deviation
    return None if found is None or found.surface is None else found.surface.max


def _utilisation(report: Report) -> float | None:
    """Above 1 where a case does not carry its loads, or a figure leaves that open."""
    return None if report.structure is None else report.structure.used


def _packed_volume(report: Report) -> float | None:
    packed, pieces = report.deployment.packed, report.deployment.pieces
    if packed is None:
        return None
    if pieces:
        return sum(each.box.volume for each in pieces)
    thickness = report.deployment.thickness
    if not thickness and report.structure is not None:
        thickness = report.structure.model.thickness
    return packed.length * packed.width * max(packed.height, packed.layers * thickness)


def _mass(report: Report) -> float | None:
    built = report.quantities.built
    if report.quantities.mass_kg is not None or built is None:
        return report.quantities.mass_kg
    return built.mass_kg.total


def _crease_length(report: Report) -> float:
    length = report.quantities.crease_length
    return length.mountain + length.valley


def _worst(share: Share, case: str, state: LimitState) -> Read:
    """The largest of a load case and its arrangements, or of all where none is named.

    state: Where a code combines the cases, only its combinations for this limit state count.
    """

    def counts(each: CaseResult) -> bool:
        if not case:
            return each.limit_state in (None, state)
        return each.name == case or each.name.startswith(f"{case}, ")

    def read(report: Report) -> float | None:
        cases = () if report.structure is None else report.structure.cases
        shares = [
            share(each.equilibrium) or 0.0
            for each in cases
            if each.equilibrium is not None and counts(each)
        ]
        return max(shares, default=None)

    return read


def _tie_force(standing: Equilibrium) -> float:
    return max((tie.force for tie in standing.ties), default=0.0)


_OF_SHELL: Mapping[str, tuple[str, Step | None, Read]] = {
    "panels": ("", None, lambda report: float(report.quantities.panels)),
    "deviation": ("{unit}", "deviation", _deviation),
    "mass": ("kg", None, _mass),
    "packed_volume": ("{unit}³", "pack", _packed_volume),
    "sheet_area": ("{unit}²", None, lambda report: report.quantities.area),
    "crease_length": ("{unit}", None, _crease_length),
    "cut_length": ("{unit}", None, lambda report: report.quantities.outline_length),
    "utilisation": ("", "structure", _utilisation),
    "degrees_of_freedom": ("", None, lambda report: report.degrees_of_freedom),
}
_OF_CASE: Mapping[str, tuple[str, Share]] = {
    "deflection": ("{unit}", lambda each: each.displacement.size),
    "tie_force": ("N", _tie_force),
    "stress": ("N/{unit}²", lambda each: each.stress.size),
    "buckling": ("", lambda each: each.utilisation.buckling),
}
"""These are of the worst load case, or of one: "deflection.snow". Buckling is the share of the load
at which the shell buckles, 0 if it does not."""
NAMES = (*_OF_SHELL, *_OF_CASE)
"""Figures that have a name."""
BEARS: Mapping[str, Limit] = {"utilisation": Limit(most=1.0)}
"""What holds of a structure where nothing else is asked for: a shell that buckles or breaks under
its loads is no choice."""

_PARTS: Mapping[str, Step] = {
    "residuals": "verification",
    "deviation.surface": "deviation",
    "deviation.approached": "deviation",
    "deployment.packed": "pack",
    "deployment.largest_thickness": "pack",
    "deployment.weight": "weight",
    "cutting": "cutting",
    "quantities.stock": "stock",
    "quantities.built.stock_sheets": "stock",
    "structure": "structure",
}
"""What a shell cannot leave out, by the beginning of the keys that it is told by."""


def _part_of(name: str) -> Step | None:
    begins = (part for key, part in _PARTS.items() if f"{name}.".startswith(f"{key}."))
    return next(begins, None)


@cache
def _keys() -> frozenset[str]:
    """The keys of all numbers of the report."""
    return frozenset(_numbers(Report, ""))


def _numbers(kind: Any, head: str) -> list[str]:
    if get_origin(kind) in (Union, types.UnionType):
        return [key for each in get_args(kind) for key in _numbers(each, head)]
    if kind in (int, float, Angle):
        return [head]
    if not dataclasses.is_dataclass(kind):
        return []
    return [
        number
        for key, field in written_fields(kind).items()
        for number in _numbers(field.kind, f"{head}.{key}" if head else key)
    ]
