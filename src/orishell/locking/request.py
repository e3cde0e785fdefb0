"""What is asked of a shell, in a form in which single values can be changed and tried."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Self

from orishell.conventions.formatting import in_one_line
from orishell.curves import Curve, curve_from_formulas, parse_formula
from orishell.design import Design
from orishell.errors import Remedy, Value
from orishell.families.pattern import Pattern
from orishell.families.registry import FAMILIES
from orishell.locking.lock import CONTACT_TOLERANCE


@dataclass(frozen=True, slots=True, eq=False)
class Request:
    """The family's parameters, the target curves, and the distance at which panels touch.

    Parameters
    ----------
    pattern
        The family's parameters.
    target
        The target curves f and g, or None.
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    """

    pattern: Pattern
    target: tuple[Curve, Curve] | None
    tolerance: float = CONTACT_TOLERANCE

    __repr__ = in_one_line

    @property
    def quick(self) -> bool:
        """Whether rows and columns are known without a search."""
        return True

    def sized(self) -> Request:
        """The request with its rows and columns settled: here they are given."""
        return self

    def designed(self) -> Design:
        """The design that is asked for, before its path is examined for contact."""
        if self.target is None:
            return self.pattern.design_without_target()
        return self.pattern.design(*self.target)

    def changed(self, remedy: Remedy) -> Self:
        """The request with other values at keys of the design file."""
        tables: dict[str, dict[str, Value | None]] = {}
        for key, value in remedy.changes.items():
            table, _, name = key.rpartition(".")
            tables.setdefault(table, {})[name] = value
        family = tables.get("shell", {}).get("family")
        model = type(self.pattern) if family is None else FAMILIES[str(family)].pattern
        return replace(
            self,
            pattern=self.pattern.changed(tables.get("pattern", {}), model),
            target=self.target
            and (
                _changed(self.target[0], tables.get("target.f", {})),
                _changed(self.target[1], tables.get("target.g", {})),
            ),
        )


def _changed(curve: Curve, values: Mapping[str, Value | None]) -> Curve:
    if "formula" in values:
        formula, ends = values["formula"], values["range"]
        assert isinstance(formula, str)
        assert isinstance(ends, list)
        drawn = curve_from_formulas(None, parse_formula(formula), *map(float, ends))
        return drawn.scaled(curve.scale)
    for name, value in values.items():
        if name == "scale":
            assert isinstance(value, float | int)
            curve = curve.scaled(value / curve.scale)
        else:
            assert name == curve.key
            assert isinstance(value, list)
            start, stop = value
            curve = curve.part_of_drawn(float(start), float(stop))
    return curve
