"""The table ``[target.fit]``: the sizes that the built shell is to have."""

from __future__ import annotations

from typing import Annotated, Final, Literal, Self

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.quantities import conversion
from orishell.conventions.table import Number, Table, misfit

Side = Literal["outside", "inside"]
"""Of what sizes are: the box around the shell, or the room within."""
AXES: Final = ("width", "depth", "height")
"""Sizes along x, y and z."""
HEAD: Final = 2.0
"""Height at which a room must be clear (metres): people of 1.95 m walk through, and doors are as
high."""

Length = Annotated[Number, Field(gt=0)]


class FitTable(Table):
    """Sizes of the built shell at its target, along x, y and z; those left out are not asked for.

    Outside they are those of its bounding box. Inside, ``width`` and ``depth`` are clear from the
    ground to ``head_height`` through the whole shell, and ``height`` is the headroom:
    :mod:`orishell.shell.standing` says exactly what that is (all in the design's unit).
    """

    width: Length | None = None
    depth: Length | None = None
    height: Length | None = None
    of: Side = "outside"
    head_height: Length | None = None

    @model_validator(mode="after")
    def _check(self) -> Self:
        if not self.asked:
            what = "a fit needs a size: width, depth or height"
            raise PydanticCustomError("source", what, {"found": "none of them"})
        clear = self.width is not None or self.depth is not None
        if self.head_height is not None:
            if self.of == "outside" or not clear:
                what = 'this key goes with width or depth of = "inside"'
                raise PydanticCustomError("source", what, {"key": "head_height"})
            if self.height is not None and self.height <= self.head_height:
                expected = f"a headroom above head_height, {self.head_height:g}"
                raise misfit(expected, self.height, "height")
        return self

    @property
    def asked(self) -> dict[str, float]:
        """The sizes asked for, by their keys (lengths)."""
        values = {key: getattr(self, key) for key in AXES}
        return {key: value for key, value in values.items() if value is not None}

    def head(self, unit: str) -> float:
        """Height up to which a room is clear, in ``unit``."""
        return self.head_height or HEAD * conversion("m", unit)
