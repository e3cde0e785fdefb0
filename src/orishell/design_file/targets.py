"""The table ``[target]``: the curves f and g, a surface, or a drawn sheet."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, ClassVar, Self

from pydantic import BeforeValidator, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.conventions.table import Table
from orishell.curves import Curve
from orishell.design import MeshSurface, PiecedSurface
from orishell.design_file.drawing import DrawingTable
from orishell.design_file.fit import FitTable
from orishell.design_file.surface import SurfaceTable
from orishell.design_file.target import Target
from orishell.motion.drawing import Drawing


def _named(value: Any) -> Any:
    """The table of a drawn sheet whose file alone is named."""
    return {"file": value} if isinstance(value, str) else value


@record
class Known:
    """What a target is, once it was read."""

    curves: tuple[Curve, Curve] | None = None  # f and g
    inner: Curve | None = None  # the curve of a second skin
    surface: PiecedSurface | None = None  # a surface in place of f and g
    # turns of its rectangle to be tried (degrees); none if the file says how it is turned
    turns: tuple[float, ...] = ()
    drawing: Drawing | None = None  # or a drawn sheet

    @property
    def notes(self) -> tuple[str, ...]:
        """What is to be said of how its files were read."""
        if isinstance(self.surface, MeshSurface):
            return self.surface.notes
        curves = dict(zip("fg", self.curves or (), strict=False))
        if self.inner is not None:
            curves["inner"] = self.inner
        return tuple(f"{name}: {note}" for name, curve in curves.items() for note in curve.notes)


class Targets(Table):
    """Both target curves, or a surface or a drawn sheet in their place."""

    SAMPLE: ClassVar = {"f": Target.SAMPLE, "g": {"formula": "0.1*cos(2*pi*x)", "range": [0, 6]}}

    f: Target | None = None
    g: Target | None = None
    inner: Target | None = None  # the curve of a second skin, drawn where f is
    surface: SurfaceTable | None = None
    pattern: Annotated[DrawingTable | None, BeforeValidator(_named)] = None
    fit: FitTable | None = None  # sizes that the built shell is to have

    @model_validator(mode="after")
    def _check(self) -> Self:
        curves = [name for name in ("f", "g") if getattr(self, name) is not None]
        others = [name for name in ("surface", "pattern") if getattr(self, name) is not None]
        if not others and not self.sizes_alone:
            for name in ("f", "g"):
                if name not in curves:
                    what = "Field required"
                    raise PydanticCustomError("missing", what, {"key": name})
        if self.inner is not None:
            other = next(iter(others), "fit" if self.fit is not None else "")
            if other:
                what = f"a curve of a second skin goes with f and g, without {other}"
                raise PydanticCustomError("source", what, {"key": "inner"})
        if others and (len(others) > 1 or curves):
            what = "a target is either f and g, or a surface, or a pattern"
            raise PydanticCustomError("source", what, {"key": (curves or others)[0]})
        return self

    @property
    def sizes_alone(self) -> bool:
        """Whether there is nothing to follow, but sizes for a sheet of its own."""
        others = self.f, self.g, self.inner, self.surface, self.pattern
        return self.fit is not None and others == (None,) * len(others)

    def known(self, directory: Path | None, unit: str) -> Known:
        """The surface, or the curves, see :meth:`Target.curve`; a drawn sheet is read before."""
        if self.sizes_alone:
            return Known()
        if self.surface is not None:
            surface = self.surface.surface(directory, unit)
            return Known(surface=surface, turns=self.surface.open_turns)
        inner = None if self.inner is None else _curve("inner", self.inner, directory, unit)
        return Known(self.curves(directory, unit), inner)

    def curves(self, directory: Path | None, unit: str) -> tuple[Curve, Curve]:
        """The curves f and g, see :meth:`Target.curve`."""
        assert self.f is not None
        assert self.g is not None
        return _curve("f", self.f, directory, unit), _curve("g", self.g, directory, unit)


def _curve(name: str, target: Target, directory: Path | None, unit: str) -> Curve:
    try:
        return target.curve(directory, unit)
    except InputError as error:
        raise error.at_key(f"target.{name}", f"[target.{name}]") from None
