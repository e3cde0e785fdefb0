"""Edges of what stiffens a sheet: what they bear, and how near that is to the end of it.

Strips of box girders are hinged on panels and on each other: these lines bear what crease lines do
(``line_strength``), but that no membrane helps them. Gussets, and plates across box girders, are
fixed along their edges once the shell stands: what that bears is given for itself
(``edge_strength``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.design import Design
from orishell.design.boxes import STRIPS, Box
from orishell.design.carried import CarriedPart
from orishell.motion.grid import Vertex
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, first_largest
from orishell.structure.carried import plates_across
from orishell.structure.crease_lines import by_direction
from orishell.structure.hinge_lines import UNKNOWN
from orishell.structure.mesh.edge_forces import spread_over
from orishell.structure.mesh.plate_edges import PlateEdges
from orishell.structure.model import Model


@record
class AtEdge:
    """Something that is largest along an edge of what stiffens a sheet."""

    size: float  # how large it is
    part: str  # a panel of a strip, "box 4 upper 3", or a plate: "gusset 5,3", "plate 4,3"
    beside: str  # what is on the other side of the edge, "panel 3,3" or "the edge from 5,3 to 4,3"

    def in_words(self) -> str:
        """Where it is."""
        return f"between {self.part} and {self.beside}"


@record
class _Joined:
    """Edges of the plates of one mesh."""

    hinged: bool  # whether they are hinges, as strips have; else what is fixed there once it stands
    thickness: float  # of these plates (length)
    names: Sequence[str]  # what plates (F,) are called
    beside: Sequence[Sequence[str]]  # what is beside their four edges (F, 4); empty beside nothing


@record
class JudgedEdges:
    """Forces per length along edges that bear alike, each the largest and where it is."""

    largest: AtEdge  # in any direction
    used: AtEdge | None  # the share of what is borne; None if nothing is known of that
    unknown: AtEdge  # in directions in which no strength is known


def judged_edges(model: Model, found: Sequence[PlateEdges], *, hinged: bool) -> JudgedEdges | None:
    """What edges bear, by what they can bear; None if there are none.

    hinged: Whether hinges of box girders are meant, or edges of gussets and plates.
    """
    asked = model.structure
    strength = asked.line_strength if hinged else asked.edge_strength
    edges = list(_forces(model, found, hinged))
    if not edges:
        return None
    places = [place for each, _ in edges for place in each]
    forces = np.concatenate([each for _, each in edges])

    def most(measure: Callable[[Array], Array]) -> AtEdge:
        sizes = measure(forces).max(axis=(-1, -2))
        worst = first_largest(sizes, SOLVED)
        return AtEdge(float(sizes[worst]), *places[worst])

    return JudgedEdges(
        largest=most(lambda each: np.linalg.norm(each, axis=-1)),
        used=None if strength is None else most(strength.used),
        unknown=most((strength or UNKNOWN).unknown),
    )


def _forces(
    model: Model, found: Sequence[PlateEdges], hinged: bool
) -> Iterator[tuple[list[tuple[str, str]], Array]]:
    """Edges of a mesh that something is beside, and forces (k, S, 2, 4) by direction on these."""
    for joined, edges in zip(_joined(model), found, strict=True):
        if joined.hinged != hinged:
            continue
        stretch = edges.lengths / edges.per_length.shape[2]
        spread = spread_over(edges.per_length, stretch, joined.thickness)
        there = np.argwhere([[bool(each) for each in beside] for beside in joined.beside])
        places = [(joined.names[k], joined.beside[k][edge]) for k, edge in there.tolist()]
        yield places, by_direction(spread[*there.T], model.lever)


def _joined(model: Model) -> list[_Joined]:
    """Of every mesh of ``Model.plates``."""
    design = model.design
    if design.carried and not design.boxes:
        skin, *walls = design.carried
        whole = [
            (skin.names, _of_skin(skin)),
            *((each.names, _of_wall(each, skin)) for each in walls),
        ]
        return [_Joined(True, model.thickness, *each) for each in whole]
    if design.boxes:
        strips = [
            _Joined(True, model.thickness, names, beside)
            for each in design.boxes
            for names, beside in _of_strips(each)
        ]
        plates = [_across(each, design) for each in design.boxes]
        fixed = [_Joined(False, model.thickness, *each) for each in plates if each[0]]
        return [*strips, *fixed]
    if not design.plates:
        return []
    at = [part.plate.corner for part in design.plates if part.plate is not None]
    own = design.plates[0].panel
    thickness = model.thickness if own is None else own.thickness
    beside = [(_edge(each, -1), "", "", _edge(each, 1)) for each in at]
    return [_Joined(False, thickness, [part.names[0] for part in design.plates], beside)]


def _edge(at: Vertex, way: int) -> str:
    """The edge of a column from a vertex, upwards or downwards."""
    row, column = at
    return f"the edge from {row},{column} to {row + way},{column}"


def _of_strips(box: Box) -> list[tuple[Sequence[str], Sequence[Sequence[str]]]]:
    """Panels of the upper and of the lower strip of a box girder, and what is beside each."""
    count = len(box.names) // 2
    upper, lower = box.names[:count], box.names[count:]
    on = [f"panel {row},{column}" for row, column in box.hung_on]
    found: list[tuple[Sequence[str], Sequence[Sequence[str]]]] = []
    for own, above, below in ((upper, on[:count], lower), (lower, upper, on[count:])):
        aside = ["", *own, ""]
        found.append((own, list(zip(aside, below, aside[2:], above, strict=False))))
    return found


def _of_skin(skin: CarriedPart) -> list[tuple[str, str, str, str]]:
    """What is beside each panel of a second skin."""
    grid, names = skin.strips.grid, skin.names
    every = np.full((grid.rows + 1, grid.columns + 1), "", np.object_)
    every[1:-1, 1:-1] = np.array(names, np.object_).reshape(grid.rows - 1, -1)
    sides = every[1:-1, :-2], every[2:, 1:-1], every[1:-1, 2:], every[:-2, 1:-1]
    return list(zip(*(each.ravel().tolist() for each in sides), strict=True))


def _of_wall(wall: CarriedPart, skin: CarriedPart) -> list[tuple[str, str, str, str]]:
    """What is beside each panel of a wall: others of it, and what it hangs on."""
    on = {}
    for each in wall.strips.hung:
        own = skin.names[each.panels * len(wall.names) :][: len(wall.names)]
        panels = [f"panel {row},{column}" for row, column in wall.hung_on]
        on[each.line] = own if each.part else panels
    aside = ["", *wall.names, ""]
    return list(zip(aside, on[1], aside[2:], on[0], strict=False))


def _across(box: Box, design: Design) -> tuple[Sequence[str], Sequence[Sequence[str]]]:
    """Plates across a box girder, and what is beside each."""
    row = box.sleeve.row
    own = [each for each in zip(*plates_across(design, 0), strict=True) if each[0][0] == row]
    strips = [f"box {row} {strip}" for strip in STRIPS]
    return (
        [name for _, name in own],
        [(_edge(at, -1), *strips, _edge(at, 1)) for at, _ in own],
    )
