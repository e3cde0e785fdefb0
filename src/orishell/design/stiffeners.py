"""The table [stiffeners]: plates in the folds of a shell, box girders over them, a second skin."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from orishell.conventions.record import record
from orishell.conventions.table import Number, Several, Size, Table, misfit
from orishell.design.panel import PanelSpec
from orishell.motion.grid import Vertex

Index = Annotated[int, Field(ge=0)]


Length = Annotated[Size, Field(gt=0)]

BOLT_EDGE = 4.0
"""How far holes of bolts are from edges, in diameters: what EN 1995-1-1, table 8.4 asks at most of
bolts beside a loaded edge of wood."""


KEYS = {
    "gussets": ("rows", "columns", "share", "thickness", "material", "bolts"),
    "boxes": ("rows", "columns", "share"),
    "skin": ("gap", "walls"),
}
"""Keys of every kind."""


class Bolts(Table):
    """Bolts along the edges of gussets, through brackets that others hold on panels (lengths).

    ``hole`` is the diameter of holes, ``spacing`` their distance, ``edge`` how far their middles
    are from the edges of a gusset.
    """

    SAMPLE: ClassVar = {"hole": 0.008, "spacing": 0.08}

    hole: Length
    spacing: Length
    edge: Length | Literal["auto"] = "auto"

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.spacing < 2 * self.hole:
            raise misfit(f"at least two diameters, {2 * self.hole:g}", self.spacing, "spacing")
        if self.edge != "auto" and self.edge < self.hole:
            raise misfit(f"at least the diameter of a hole, {self.hole:g}", self.edge, "edge")
        return self

    @property
    def off(self) -> float:
        """How far middles of holes are from edges (length)."""
        return BOLT_EDGE * self.hole if self.edge == "auto" else self.edge


class Stiffeners(Table):
    """Plates in the folds of a shell that stands, or strips of panels that move with it.

    Gussets are plane triangles. Each is clipped in between the two panels that fold about a crease
    of a row, at one of its vertices: from there it goes along the edges of the column above and
    below, by ``share`` of each. ``columns`` are all, every so many of them with the last, or a
    list. They are made as panels are, of the same boards, unless they have a ``thickness`` (length)
    or a ``material`` of their own: then each is one board, as thick as panels if nothing else is
    said. They are clipped in, or bolted on along both edges if there are ``bolts``.

    Boxes close rows of the sheet to box girders by two more strips of panels, which hang on its
    panels along lines that cut edges of columns at ``share`` of them at the most, and move with it.
    ``share`` "auto" is as much as leaves the motion free. In ``columns``, which may be "none",
    plates are clipped across the boxes once the shell stands.

    A skin is a second sheet below that of a parallel repeating or T-hedral shell, nowhere nearer to
    it than a ``gap`` (length) at the target, and joined to it by ``walls``: between all rows of
    panels that have room for one, every so many of these with the last, or those of a list. It
    moves with the shell. ``gap`` "auto" moves it by half the shortest edge of its columns.
    """

    SAMPLE: ClassVar = {"kind": "gussets"}

    kind: Literal["gussets", "boxes", "skin"]
    rows: Literal["valleys", "crests", "all"] | Several[Index] = "valleys"
    columns: Literal["all", "none"] | Annotated[int, Field(ge=1)] | Several[Index] = "all"
    share: Annotated[Number, Field(gt=0, lt=1)] | Literal["auto"] = 0.9
    thickness: Length | None = None
    material: str | None = None
    bolts: Bolts | None = None
    gap: Length | Literal["auto"] = "auto"
    walls: Literal["all"] | Annotated[int, Field(ge=1)] | Several[Index] = "all"

    @model_validator(mode="after")
    def _check_kind(self) -> Self:
        for key in sorted(self.model_fields_set - {"kind", *KEYS[self.kind]}):
            value = getattr(self, key)
            if value is not None:
                kinds = [kind for kind, keys in KEYS.items() if key in keys]
                named = " or ".join(f'"{kind}"' for kind in kinds)
                raise misfit(f'none beside kind = "{self.kind}": it is of {named}', value, key)
        return self

    def made_of(self, panel: PanelSpec, density: float) -> PanelSpec:
        """What they are made of, beside panels.

        Parameters
        ----------
        density
            Mass by volume of boards of their own (kg/m^3), 0 if unknown.
        """
        if self.thickness is None and self.material is None:
            return panel
        return panel.replace_unchecked(
            thickness=self.thickness or panel.thickness,
            construction="bevel",  # one solid board
            membrane=0.0,
            membrane_density=0.0,
            density=density,
        )


@record
class Plate:
    """Where a plane plate of a part is hinged on the sheet at its target."""

    corner: Vertex  # the vertex from which it goes along the edges of its column, up and down
    share: float  # of each of these edges
