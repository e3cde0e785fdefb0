"""The table [stiffeners]: plates that are put into the folds of a shell that stands."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from orishell.conventions.record import record
from orishell.conventions.table import Number, Several, Table
from orishell.motion.grid import Vertex

Index = Annotated[int, Field(ge=0)]


class Stiffeners(Table):
    """Plates that are put into the folds of a shell that stands.

    Gussets are plane triangles. Each is clipped in between the two panels that fold about a crease
    of a row, at one of its vertices: from there it goes along the edges of the column above and
    below, by ``share`` of each. ``columns`` are all, every so many of them with the last, or a
    list. They are made as panels are, of the same boards.
    """

    kind: Literal["gussets"]
    rows: Literal["valleys", "crests", "all"] | Several[Index] = "valleys"
    columns: Literal["all"] | Annotated[int, Field(ge=1)] | Several[Index] = "all"
    share: Annotated[Number, Field(gt=0, lt=1)] = 0.9


@record
class Plate:
    """Where a plane plate of a part is hinged on the sheet at its target."""

    corner: Vertex  # the vertex from which it goes along the edges of its column, up and down
    share: float  # of each of these edges
