"""What a shell is asked for, so that it can be asked for a little differently."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal, Protocol, Self

from orishell.curves import Curve, curve_from_formulas, parse_formula
from orishell.design import Design
from orishell.errors import Remedy, Value
from orishell.locking.lock import CONTACT_TOLERANCE
from orishell.quoting import in_one_line


class FamilyParameters(Protocol):
    """The parameters of a family: its table [pattern]."""

    @property
    def flap(self) -> float | Literal["auto"]:
        """Width of the flaps; "auto" is as wide as the family finds useful and as meets nothing."""
        ...

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell that these parameters and the curves f and g ask for."""
        ...

    def design_without_target(self) -> Design:
        """Design what these parameters alone ask for."""
        ...

    def changed(self, values: Mapping[str, Value | None]) -> FamilyParameters:
        """The same with other values of its keys, None for a key removed, or of another family."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
class Request:
    """A target, a family's parameters, and when panels touch.

    Parameters
    ----------
    pattern
        The family's parameters.
    target
        The target curves f and g, or None.
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    """

    pattern: FamilyParameters
    target: tuple[Curve, Curve] | None
    tolerance: float = CONTACT_TOLERANCE

    __repr__ = in_one_line

    @property
    def quick(self) -> bool:
        """Whether it takes no search to know the number of rows and columns."""
        return True

    def sized(self) -> Request:
        """The request with a number of rows and columns."""
        return self

    def designed(self) -> Design:
        """The design, its path not examined yet."""
        if self.target is None:
            return self.pattern.design_without_target()
        return self.pattern.design(*self.target)

    def changed(self, remedy: Remedy) -> Self:
        """The request with other values at keys of the design file.

        Parameters
        ----------
        remedy
            The keys and their values.
        """
        tables: dict[str, dict[str, Value | None]] = {}
        for key, value in remedy.changes.items():
            table, _, name = key.rpartition(".")
            tables.setdefault(table, {})[name] = value
        values = {**tables.get("shell", {}), **tables.get("pattern", {})}
        return replace(
            self,
            pattern=self.pattern.changed(values) if values else self.pattern,
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
