"""The tables ``[target.f]`` and ``[target.g]``: where a curve comes from, and in which unit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Any, ClassVar, Final, Self

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import Unit, conversion
from orishell.conventions.table import Number, Table
from orishell.curves import (
    Chain,
    Curve,
    Formula,
    FormulaOfTwo,
    curve_data,
    curve_from_formulas,
    curve_from_points,
    parse_curve,
    parse_formula,
    read_dxf,
    read_points,
    read_svg,
)
from orishell.numerics.arrays import Array

FITTING: Final = {
    "formula": {"range"},
    "points": {"unit", "smooth", "part"},
    "svg": {"unit", "smooth", "id", "join", "part"},
    "dxf": {"unit", "smooth", "layer", "handle", "join", "part"},
    "path": {"unit", "smooth", "part"},
}
"""The sources of a curve, and the keys that have a meaning for each."""
FILES: Final = ("svg", "dxf")
ALWAYS: Final = {"scale", "reverse"}


KEPT: Final = 8
"""Number of curves that are kept for reuse: the studio sends the same tables again and again."""
MOST_POINTS: Final = 20_000
LONGEST_PATH: Final = 1_000_000
"""Characters of a path, at most."""
Point = Annotated[list[Number], Field(min_length=2, max_length=2)]
Ends = Annotated[list[Number | str], Field(min_length=2, max_length=2)]
"""Two parameters of a curve: numbers, or formulas of constants."""
Factor = Annotated[Number, Field(gt=0)]


def one_source(
    table: Table, fitting: Mapping[str, set[str]], always: set[str], otherwise: str
) -> str:
    """The one source of a curve or a surface that a table gives, whose keys all go with it.

    fitting: Sources, and the keys that have a meaning for each.
    always: Keys that have one for all.
    otherwise: What to say if there is not one source.
    """
    given = [key for key in type(table).model_fields if key in table.model_fields_set]
    sources = [key for key in given if key in fitting]
    if len(sources) != 1:
        found = {"found": " and ".join(sources) or "none of them"}
        raise PydanticCustomError("source", otherwise, found)
    source = sources[0]
    for key in given:
        if key not in {source, *fitting[source], *always}:
            owners = [each for each, keys in fitting.items() if key in keys]
            what = f"this key goes with {' or '.join(owners)}, not with {source}"
            raise PydanticCustomError("source", what, {"key": key})
    return source


class Target(Table):
    """A target curve: one source, and what is done with it."""

    SAMPLE: ClassVar = {"formula": "-x**2", "range": [-1, 1]}

    formula: str | Annotated[list[str], Field(min_length=2, max_length=2)] | None = None
    range: Ends | None = None
    points: str | Annotated[list[Point], Field(min_length=2, max_length=MOST_POINTS)] | None = None
    path: Annotated[str, Field(max_length=LONGEST_PATH)] | None = None
    svg: str | None = None
    id: str | None = None
    dxf: str | None = None
    layer: str | None = None
    handle: str | None = None
    join: Factor | None = None  # how far apart loose ends of a drawing may be, in its unit
    unit: Unit | None = None
    smooth: bool | None = None
    part: Ends | None = None
    scale: Factor | Annotated[list[Factor], Field(min_length=2, max_length=2)] = 1.0
    reverse: bool = False

    @model_validator(mode="after")
    def _check(self) -> Self:
        what = "a curve comes from either a formula, points, svg, dxf or a path"
        source = one_source(self, FITTING, ALWAYS, what)
        if source == "formula" and self.range is None:
            raise PydanticCustomError("source", "a formula needs its range, as in range = [0, 1]")
        if self.layer is not None and self.handle is not None:
            what = "a curve is chosen by its layer or its handle"
            raise PydanticCustomError("source", what, {"found": "both", "key": "handle"})
        return self

    def curve(self, directory: Path | None, unit: str) -> Curve:
        """The curve that the table describes; formulas are in ``unit``, files are converted to it.

        Without a directory no file may be read. Raises InputError if there is no curve.
        """
        self.note_all()  # what has no meaning for its source was refused
        if self.svg is None and self.dxf is None and not isinstance(self.points, str):
            return _curve_of(self.model_dump_json(exclude_unset=True), unit)
        return self._curve(directory, unit)

    def without_files(self, directory: Path, unit: str) -> dict[str, Any]:
        """The table with what its file draws in place of the file's name."""
        table = self.model_dump(exclude_unset=True)
        if isinstance(self.points, str):
            points = self._points(directory, unit)
            kept = np.linspace(0, len(points) - 1, min(len(points), MOST_POINTS))
            table["points"] = points[np.unique(np.rint(kept).astype(int))].tolist()
            table.pop("unit", None)
        elif self.svg is not None or self.dxf is not None:
            for key in {*FILES, *FITTING["svg"], *FITTING["dxf"], "reverse"} - {"smooth", "part"}:
                table.pop(key, None)
            chain = self._chain(directory, unit)
            table["path"], beside = curve_data(chain)
            if beside and self.part is not None:
                # Lengths along what is drawn, where that is a little longer or shorter.
                before, after = (
                    (each.spline() if self.smooth else each.curve()).stop
                    for each in (chain, parse_curve(table["path"]))
                )
                table["part"] = [end * after / before for end in numbers("part", self.part)]
        return table

    def _curve(self, directory: Path | None, unit: str) -> Curve:
        if self.points is not None:
            points = self._points(directory, unit)
            smooth = self.smooth is not False
            curve = curve_from_points(points[::-1] if self.reverse else points, smooth=smooth)
        elif self.formula is None:
            chain = self._chain(directory, unit)
            curve = chain.spline() if self.smooth else chain.curve()
        else:
            texts = [self.formula] if isinstance(self.formula, str) else self.formula or []
            *x, y = [_formula(text) for text in texts]
            require_heads((*x, y), "xy" if x else "y")
            start, stop = numbers("range", self.range or [])
            curve = curve_from_formulas(x[0] if x else None, y, start, stop)
            curve = curve.reversed() if self.reverse else curve
        if self.part is not None:
            curve = curve.part(*numbers("part", self.part))
        if isinstance(self.scale, list):
            along_x, along_y = self.scale
            return curve.scaled((along_x, along_y))
        return curve.scaled(self.scale) if self.scale != 1.0 else curve

    def _points(self, directory: Path | None, unit: str) -> Array:
        if isinstance(self.points, str):
            return read_points(beside(directory, self.points), into=unit, unit=self.unit)
        return np.array(self.points) * conversion(self.unit or unit, unit)

    def _chain(self, directory: Path | None, unit: str) -> Chain:
        """What is drawn, in the direction that is asked for."""
        if self.path is not None:
            chain = parse_curve(self.path).scaled(conversion(self.unit or unit, unit))
        elif self.svg is not None:
            chain = read_svg(
                beside(directory, self.svg),
                into=unit,
                id=self.id,
                unit=self.unit,
                join=self.join,
            )
        else:
            chain = read_dxf(
                beside(directory, self.dxf or ""),
                into=unit,
                layer=self.layer,
                handle=self.handle,
                unit=self.unit,
                join=self.join,
            )
        return chain.reversed() if self.reverse else chain


@lru_cache(KEPT)
def _curve_of(table: str, unit: str) -> Curve:
    """The curve of a table without files: the same object each time, so that results are reused."""
    return Target.model_validate_json(table)._curve(None, unit)


def beside(directory: Path | None, name: str) -> Path:
    """The path of a file that is named in a design file; without a directory it is refused."""
    if directory is None:
        raise InputError(
            "files are not opened here",
            got=repr(name),
            remedy="drop the file onto the curve, or give its points as a list",
        )
    return directory / name


def numbers(key: str, ends: list[float | str]) -> tuple[float, float]:
    """Two numbers, each given as itself or as a formula of constants."""
    first, last = (
        _constant(end, key, index) if isinstance(end, str) else end
        for index, end in enumerate(ends)
    )
    return first, last


def _constant(text: str, key: str, index: int) -> float:
    """The value of a formula without a variable."""
    try:
        formula = parse_formula(text)
    except InputError as error:
        raise error.at_key(key, f"{key}[{index}]") from None
    value = float(formula.jet(np.zeros(()))[0])
    if formula.variable is None and np.isfinite(value):
        return value
    raise InputError(
        "this is no number" if formula.variable is None else "only constants are allowed here",
        where=f"{key}[{index}]",
        keys=(key,),
        got=repr(text[:60]),
        expected='a number, or a formula of constants as in "pi/2"',
    )


def require_heads(formulas: Sequence[Formula | FormulaOfTwo], names: str) -> None:
    """Refuse formulas that say in front that they give another coordinate than theirs.

    names: The coordinates, as in "xy".
    """
    for name, formula in zip(names, formulas, strict=True):
        if formula.head in {*"xyz"} - {name}:
            others = f"one formula for each of {', '.join(names)}, in this order"
            raise InputError(
                f"this formula is to give {name}",
                where="formula",
                keys=("formula",),
                got=repr(formula.text[:60]),
                expected=others if len(names) > 1 else f"{name} alone",
            )


def _formula(text: str) -> Formula:
    try:
        return parse_formula(text)
    except InputError as error:
        raise error.at_key("formula", "formula") from None
