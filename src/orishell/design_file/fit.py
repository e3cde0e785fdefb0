"""The table ``[target.fit]``: the sizes that the built shell is to have."""

from __future__ import annotations

from typing import Annotated, ClassVar, Final, Literal, Self

from pydantic import Field, model_validator

from orishell.conventions.errors import InputError
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
    :mod:`orishell.shell.fit.built_size` says exactly what that is (all in the design's unit).
    """

    SAMPLE: ClassVar = {"width": 6, "depth": 3}

    width: Length | None = None
    depth: Length | None = None
    height: Length | None = None
    of: Side = "outside"
    head_height: Length | None = None

    @model_validator(mode="after")
    def _check(self) -> Self:
        given = self.model_dump(exclude_unset=True)
        if not self.asked:
            raise misfit("width, depth or height, or several of them", given)
        if self.head_height is not None and not self.clear:
            raise misfit('width or depth of = "inside" beside it', self.head_height, "head_height")
        return self

    @property
    def asked(self) -> dict[str, float]:
        """The sizes asked for, by their keys (lengths)."""
        values = {key: getattr(self, key) for key in AXES}
        return {key: value for key, value in values.items() if value is not None}

    @property
    def clear(self) -> bool:
        """Whether a size is asked for that must be clear up to the head height."""
        return self.of == "inside" and (self.width is not None or self.depth is not None)

    def require_headroom(self, unit: str) -> None:
        """Refuse a headroom in which nobody stands where a room is to be clear."""
        head = self.head(unit)
        if self.clear and self.height is not None and self.height <= head:
            raise InputError(
                "a room that is clear up to the head height needs more headroom than that",
                keys=("target.fit.height",),
                got=f"{self.height:g}",
                expected=f"more than {head:g}",
                remedy="ask for more, or give a lower head_height",
            )

    def require_lengths(self, lengths: tuple[str, str] | None) -> None:
        """Refuse sizes of a sheet without a target that has no lengths to be scaled, or height."""
        if lengths is None:
            raise InputError(
                "sizes need a target that is scaled, or a sheet of edges that are",
                keys=("target.fit",),
                expected="f and g, a surface, a drawn sheet, or a flat-foldable sheet by its name",
                remedy='add [target.f] and [target.g], or write family = "flat-foldable"',
            )
        if self.height is not None:
            raise InputError(
                "a sheet without a target is scaled along its rows and its columns only",
                keys=("target.fit.height",),
                got=f"{self.height:g}",
                expected="width and depth",
                remedy="leave it out, and choose fold_deg: it says how deep folds are",
            )

    def head(self, unit: str) -> float:
        """Height up to which a room is clear, in ``unit``."""
        return self.head_height or usual_head(unit)


def usual_head(unit: str) -> float:
    """Height up to which a room is clear if no other is asked for, in ``unit``."""
    return HEAD * conversion("m", unit)
