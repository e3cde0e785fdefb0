"""The table ``[target]``: the curves f and g, a surface, or a drawn sheet."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Self

from pydantic import BeforeValidator, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.table import Table
from orishell.curves import Curve
from orishell.design_file.drawing import DrawingTable
from orishell.design_file.fit import FitTable
from orishell.design_file.surface import SurfaceTable
from orishell.design_file.target import Target


def _named(value: Any) -> Any:
    """The table of a drawn sheet whose file alone is named."""
    return {"file": value} if isinstance(value, str) else value


class Targets(Table):
    """Both target curves, or a surface or a drawn sheet in their place."""

    f: Target | None = None
    g: Target | None = None
    surface: SurfaceTable | None = None
    pattern: Annotated[DrawingTable | None, BeforeValidator(_named)] = None
    fit: FitTable | None = None  # sizes that the built shell is to have

    @model_validator(mode="after")
    def _check(self) -> Self:
        curves = [name for name in ("f", "g") if getattr(self, name) is not None]
        others = [name for name in ("surface", "pattern") if getattr(self, name) is not None]
        if not others and not curves and self.fit is not None:
            what = "sizes need a target that is scaled: f and g, a surface, or a drawn sheet"
            raise PydanticCustomError("source", what, {"key": "fit"})
        if not others:
            for name in ("f", "g"):
                if name not in curves:
                    what = "Field required"
                    raise PydanticCustomError("missing", what, {"key": name})
        elif len(others) > 1 or curves:
            what = "a target is either f and g, or a surface, or a pattern"
            raise PydanticCustomError("source", what, {"key": (curves or others)[0]})
        return self

    def curves(self, directory: Path | None, unit: str) -> tuple[Curve, Curve]:
        """The curves f and g, see :meth:`Target.curve`."""

        def curve(name: str, target: Target) -> Curve:
            try:
                return target.curve(directory, unit)
            except InputError as error:
                raise error.at_key(f"target.{name}", f"[target.{name}]") from None

        assert self.f is not None
        assert self.g is not None
        return curve("f", self.f), curve("g", self.g)
