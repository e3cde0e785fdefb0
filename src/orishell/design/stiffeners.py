"""The table [stiffeners]: plates that are put into the folds of a shell that stands."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from orishell.conventions.record import record
from orishell.conventions.table import Number, Several, Size, Table
from orishell.design.panel import PanelSpec
from orishell.motion.grid import Vertex

Index = Annotated[int, Field(ge=0)]


class Stiffeners(Table):
    """Plates that are put into the folds of a shell that stands.

    Gussets are plane triangles. Each is clipped in between the two panels that fold about a crease
    of a row, at one of its vertices: from there it goes along the edges of the column above and
    below, by ``share`` of each. ``columns`` are all, every so many of them with the last, or a
    list. They are made as panels are, of the same boards, unless they have a ``thickness`` (length)
    or a ``material`` of their own: then each is one board, as thick as panels if nothing else is
    said.
    """

    kind: Literal["gussets"]
    rows: Literal["valleys", "crests", "all"] | Several[Index] = "valleys"
    columns: Literal["all"] | Annotated[int, Field(ge=1)] | Several[Index] = "all"
    share: Annotated[Number, Field(gt=0, lt=1)] = 0.9
    thickness: Annotated[Size, Field(gt=0)] | None = None
    material: str | None = None

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
