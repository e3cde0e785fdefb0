"""The entities of a DXF file as pieces, exactly, in the plane that they are drawn in."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Final, cast

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.curves.pieces import Affine, Arc, Piece, bulge_arc, circular_arc, nurbs, polyline
from orishell.numerics.arrays import Array

if TYPE_CHECKING:
    from ezdxf.entities.dxfentity import DXFEntity
    from ezdxf.entities.dxfgfx import DXFGraphic

VIEWS: Final = {
    "drawn in x and z, as seen from the front: z is its height": (0, 2, 1, -1),
    "drawn in y and z, as seen from the right: z is its height": (1, 2, 0, 1),
}
"""Upright planes: what is said of them, which coordinates run to the right, upwards and towards who
looks, and the sign of the last one."""


def draw_in_plane(entities: Sequence[DXFEntity]) -> tuple[list[Drawn], tuple[str, ...]]:
    """What entities draw in the one plane that they lie in, and what is to be said of it.

    That is a plane of constant z, or if one of them leaves it, of constant y or x.

    Raises InputError: If they lie in no such plane.
    """
    try:
        drawn = [draw_entity(each) for each in entities]
    except PlaneError as error:
        for note, (right, up, depth, sign) in VIEWS.items():
            try:
                drawn = [draw_entity(_turned(each, right, up, depth, sign)) for each in entities]
            except PlaneError:
                continue
            require_one_plane(drawn, "xyz"[depth], sign)
            return drawn, (note,)
        raise error from None
    require_one_plane(drawn)
    return drawn, ()


def _turned(entity: DXFEntity, right: int, up: int, depth: int, sign: int) -> DXFEntity:
    """A copy of the entity with other coordinates as its x, y and z."""
    from ezdxf.math import Matrix44

    turn = np.zeros((4, 4))
    turn[[right, up, depth, 3], range(4)] = 1, 1, sign, 1
    copy = cast("DXFGraphic", entity.copy())
    copy.transform(Matrix44(turn.ravel().tolist()))
    copy.dxf.handle = entity.dxf.get("handle")  # messages name the entity
    return copy


def require_one_plane(drawn: Sequence[Drawn], depth: str = "z", sign: int = 1) -> None:
    """Refuse curves that lie above each other: seen from above they would seem to meet.

    Parameters
    ----------
    depth, sign
        The coordinate towards who looks, and the sign that it has been given.

    Raises
    ------
    InputError
        Naming one that lies elsewhere than the first.
    """
    if not drawn:
        return
    level = float(drawn[0].z[0])
    reach = max(each.reach for each in drawn)
    for each in drawn:
        if not np.abs(each.z - level).max() <= FLAT * reach:
            raise InputError(
                "the entities lie in different planes",
                where=each.name,
                got=f"{depth} = {sign * each.z[0] + 0.0:.6g}",
                expected=f"{sign * level + 0.0:.6g}, as {drawn[0].name} has",
                remedy="move them into one plane (FLATTEN in AutoCAD, ProjectToCPlane in Rhino), "
                "or choose one with layer or handle",
            )


MIRROR: Final = Affine.of(-1, 0, 0, 1, 0, 0)
"""Coordinates of an entity whose extrusion is -z: its x axis is the drawing's -x axis."""
UPRIGHT = 1e-9
"""How far a unit extrusion may lie from the z axis."""
FLAT = 1e-6
"""How far an entity may leave a plane of constant z, relative to its largest coordinate."""
CURVE_TYPES: Final = ("LINE", "ARC", "CIRCLE", "ELLIPSE", "LWPOLYLINE", "POLYLINE", "SPLINE")
SPLINE_FRAME = 16
"""Flag of a polyline's vertices that are not on it but control it."""


FLATTEN: Final = (
    "turn it into the plane of x and y (3DROTATE in AutoCAD, RemapCPlane in Rhino), set heights "
    "that differ by little to one (FLATTEN, ProjectToCPlane), or choose another with layer or "
    "handle"
)
REDRAWN: Final = "repair the file in the CAD program (AUDIT), or draw it anew, and save it again"


class PlaneError(InputError):
    """An entity that does not lie in a plane of constant z."""


@record
class Drawn:
    """The pieces that an entity draws, and at what heights."""

    pieces: list[Piece]
    z: Array  # heights of its points (k,)
    name: str  # as messages call it
    # lines of the design file that choose it, or everything on its layer
    choices: tuple[str, ...] = ()

    @property
    def reach(self) -> float:
        """Its largest coordinate."""
        return max([float(np.abs(self.z).max(initial=0.0)), *(each.reach for each in self.pieces)])


def draw_entity(entity: DXFEntity) -> Drawn:
    """The pieces of an entity of one of the :data:`CURVE_TYPES`, in a plane of constant z."""
    name = name_of(entity)
    kind = entity.dxftype()
    try:
        pieces, z = _DRAWINGS[kind](entity)
        heights = np.atleast_1d(np.asarray(z, dtype=np.float64))
        drawn = Drawn(pieces, heights, name)
        # What is not finite is refused when the pieces are joined.
        if len(heights) and np.ptp(heights) > FLAT * drawn.reach:
            raise PlaneError(
                "this entity leaves the plane z = constant",
                got=f"z from {heights.min():.6g} to {heights.max():.6g}",
                expected="a curve in a plane of two coordinates",
                remedy=FLATTEN,
            )
    except InputError as error:
        error.remedy = error.remedy or REDRAWN
        raise error.located(name) from None
    return drawn


def name_of(entity: DXFEntity) -> str:
    """Type, handle and layer of an entity, for messages."""
    handle = entity.dxf.get("handle")
    return f"{entity.dxftype()}{f' {handle}' if handle else ''} on layer {layer_of(entity)!r}"


def layer_of(entity: DXFEntity) -> str:
    """The name of an entity's layer."""
    return str(entity.dxf.get("layer", "0"))


def _line(entity: Any) -> tuple[list[Piece], Any]:
    ends = np.array([entity.dxf.start, entity.dxf.end], dtype=np.float64)
    return polyline(ends[:, :2]), ends[:, 2]


def _arc(entity: Any) -> tuple[list[Piece], Any]:
    start, end = float(entity.dxf.start_angle), float(entity.dxf.end_angle)
    sweep = np.deg2rad((end - start) % 360.0 or 360.0)
    centre = np.array(entity.dxf.center)
    arc = circular_arc(centre[:2], float(entity.dxf.radius), float(np.deg2rad(start)), float(sweep))
    return _in_world(entity, [arc], centre[2])


def _circle(entity: Any) -> tuple[list[Piece], Any]:
    centre = np.array(entity.dxf.center)
    arc = circular_arc(centre[:2], float(entity.dxf.radius), 0.0, 2 * np.pi)
    return _in_world(entity, [arc], centre[2])


def _ellipse(entity: Any) -> tuple[list[Piece], Any]:
    centre = np.array(entity.dxf.center, dtype=np.float64)
    sign = _upwards(entity)
    major = np.array(entity.dxf.major_axis, dtype=np.float64)
    minor = float(entity.dxf.ratio) * sign * np.array([-major[1], major[0]])
    start, end = float(entity.dxf.start_param), float(entity.dxf.end_param)
    sweep = (end - start) % (2 * np.pi)
    if sweep < 1e-12 or 2 * np.pi - sweep < 1e-12:
        sweep = 2 * np.pi
    arc = Arc(centre[:2], np.array([major[:2], minor]), start, sweep)
    return [arc], [centre[2], centre[2] + major[2]]


def _light_polyline(entity: Any) -> tuple[list[Piece], Any]:
    points = np.array(entity.get_points("xyb"), dtype=np.float64).reshape(-1, 3)
    pieces = _bulged(points[:, :2], points[:, 2], closed=bool(entity.closed))
    return _in_world(entity, pieces, float(entity.dxf.get("elevation", 0.0)))


def _heavy_polyline(entity: Any) -> tuple[list[Piece], Any]:
    if not (entity.is_2d_polyline or entity.is_3d_polyline):
        raise InputError(
            "this is a mesh, not a curve",
            remedy="remove it, or choose the curve with layer or handle",
        )
    corners = [v for v in entity.vertices if not int(v.dxf.get("flags", 0)) & SPLINE_FRAME]
    points = np.array([v.dxf.location for v in corners], dtype=np.float64).reshape(-1, 3)
    if entity.is_3d_polyline:
        bulges = np.zeros(len(points))
        return _bulged(points[:, :2], bulges, closed=bool(entity.is_closed)), points[:, 2]
    bulges = np.array([float(v.dxf.get("bulge", 0.0)) for v in corners])
    pieces = _bulged(points[:, :2], bulges, closed=bool(entity.is_closed))
    height = float(np.array(entity.dxf.get("elevation", (0, 0, 0)), dtype=np.float64)[2])
    return _in_world(entity, pieces, height)


def _spline(entity: Any) -> tuple[list[Piece], Any]:
    control = np.array(entity.control_points, dtype=np.float64).reshape(-1, 3)
    knots, weights = entity.knots, entity.weights
    degree = int(entity.dxf.degree)
    if not len(control):  # given by points that it goes through: the spline that CAD programs draw
        if len(entity.fit_points) < 2:
            raise InputError("a spline has too few points", got=str(len(entity.fit_points)))
        tool = entity.construction_tool()
        control = np.array([tuple(point) for point in tool.control_points])
        knots, weights, degree = tool.knots(), tool.weights(), tool.degree
    weight = list(weights) if len(weights) else None
    return nurbs(degree, knots, control[:, :2], weight), control[:, 2]


def _bulged(points: Array, bulges: Array, *, closed: bool) -> list[Piece]:
    """Straight lines and arcs between points (N, 2); bulges (N,) belong to what follows a point."""
    if closed and len(points) > 1:
        points, bulges = np.concatenate([points, points[:1]]), np.append(bulges, 0.0)
    if not bulges[:-1].any():
        return polyline(points)
    ends = zip(pairwise(points), bulges[:-1], strict=True)
    return [bulge_arc(p, q, float(b)) for (p, q), b in ends]


def _in_world(entity: Any, pieces: Sequence[Piece], z: float) -> tuple[list[Piece], Any]:
    """From an entity's own coordinates, which follow its extrusion, to those of the drawing."""
    if _upwards(entity) > 0:
        return list(pieces), z
    return [piece.transformed(MIRROR) for piece in pieces], -z


def _upwards(entity: Any) -> int:
    """1 or -1 for an extrusion along z or -z; others are refused."""
    x, y, z = (float(value) for value in entity.dxf.get("extrusion", (0, 0, 1)))
    if not np.hypot(x, y) <= UPRIGHT * abs(z) or z == 0:
        raise PlaneError(
            "this entity lies in a plane that is not z = constant",
            got=f"extrusion ({x:g}, {y:g}, {z:g})",
            expected="a curve in a plane of two coordinates",
            remedy=FLATTEN,
        )
    return 1 if z > 0 else -1


_DRAWINGS: Final = {
    "LINE": _line,
    "ARC": _arc,
    "CIRCLE": _circle,
    "ELLIPSE": _ellipse,
    "LWPOLYLINE": _light_polyline,
    "POLYLINE": _heavy_polyline,
    "SPLINE": _spline,
}
