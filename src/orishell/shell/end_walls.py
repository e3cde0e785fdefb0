"""End walls of a shell that stands: where they are, how they are tied to it, what they meet.

A wall is upright, in the plane that is nearest to its border in plan. It is proved to meet nothing
at the target: all that is built and overlaps it along the ground lies on the inner side of its
inner face, by its clearance, and the rest lies beside it.

Limit: end walls are examined at the target only. How they are brought to their place is not, nor
what holds them on the ground, and they bear nothing of the shell's loads.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.deployment.feet import Feet, find_feet
from orishell.deployment.ground import END_WALL
from orishell.design import Design, PanelSpec
from orishell.design.end_walls import BuiltEndWall, End, EndWall, Opening
from orishell.design.part import SHELL, DocumentState, Part
from orishell.locking import Lock, lock_without_clash
from orishell.motion.layout import points_of
from orishell.motion.mesh import build_mesh
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.components import find_components
from orishell.shell.doors import require_room_for_door
from orishell.shell.fit.built_size import standing_triangles
from orishell.solids.end_walls import Strips, strips_below

GAP = 0.005
"""How far a wall keeps off the shell if nobody says so, as a share of its height."""
FARTHEST = 0.25
"""What reaches further beyond its end, as a share of the wall's height, is no edge to be closed."""
UNTABBED = 0.85
"""The share of a sheet that a strip of a folded wall may take: the rest is for tabs."""
MOST_SHEETS = 400
"""A wall is not cut into the strips of more sheets."""
OTHER: dict[End, End] = {"first": "last", "last": "first"}


def with_end_walls(
    design: Design,
    lock: Lock,
    feet: Feet | None,
    asked: tuple[EndWall, ...],
    largest: tuple[float, float] | None = None,
) -> Design:
    """The design with the end walls that are asked for, proved to meet nothing at the target.

    lock: How its motion ends, with its boards.
    feet: What it stands on; None if it cannot stand.
    largest: Sides of the sheets that its strips are cut from; None if nobody says.
    Raises DesignError: If there is no room for them, or for their doors, or the shell does not
    stand.
    """
    for number, wall in enumerate(asked):
        several = len(asked) > 1
        end, gap = _room(design, lock, feet, (number, wall, several))
        build = _build(design)
        strips = strips_below(end.border, wall.door, _within(largest, build, end))
        parts = tuple(_parts(design, end, strips, (wall.at, gap, build, _levels(lock))))
        built = _built(end, wall, strips, gap)
        design = replace(
            design, attached=(*design.attached, *parts), end_walls=(*design.end_walls, built)
        )
    return design


def _within(
    largest: tuple[float, float] | None, build: PanelSpec | None, end: ClosedEnd
) -> tuple[float, float] | None:
    """What strips fit into: sheets, less room for tabs where they are folded of one piece.

    None if sheets are so small that what is cut from them refuses them by itself.
    """
    if largest is None:
        return None
    wide, most = float(np.ptp(end.border[:, 0])), MOST_SHEETS
    if wide * end.height > most * largest[0] * largest[1] or wide > most * min(largest):
        return None
    if build is not None:
        return largest
    return UNTABBED * largest[0], UNTABBED * largest[1]


def _room(
    design: Design, lock: Lock, feet: Feet | None, asked: tuple[int, EndWall, bool]
) -> tuple[ClosedEnd, float]:
    """The end that a wall closes, and how far it keeps off that; refused if it has no room.

    asked: The number of the wall, what is asked for, and whether there are several.
    """
    number, wall, several = asked
    key = f"end_wall.{number}"
    without = Remedy({"end_wall": None})
    if feet is None:
        raise DesignError(
            "an end wall stands on the ground, and this shell cannot stand",
            keys=("end_wall",),
            candidates=[without],
        )
    end = ClosedEnd.of(design, lock, feet, wall.at)
    beyond = end.reach - end.outermost
    gap = GAP * end.height if wall.gap == "auto" else wall.gap
    most = FARTHEST * end.height
    if beyond > most:
        other = [] if several else [Remedy({f"{key}.at": OTHER[wall.at]})]
        raise DesignError(
            f"the shell reaches beyond its {wall.at} end, where a wall would stand",
            place="at the target",
            keys=(f"{key}.at",),
            size=f"by {plain(beyond, 3)}, and a wall is at most {plain(most, 3)} off its border",
            candidates=[*other, without],
            excess=beyond / most - 1,
        )
    if gap > most:
        raise DesignError(
            "an end wall is too far from the end that it closes",
            keys=(f"{key}.gap",),
            size=f"it may be {plain(most, 3)} off it, a quarter of its height",
            candidates=[Remedy({f"{key}.gap": "auto"})],
            excess=gap / most - 1,
        )
    require_room_for_door(end.border, wall, key, end.highest)
    return end, gap


def require_doors(design: Design, asked: tuple[EndWall, ...]) -> None:
    """Refuse doors that walls have no room for before the motion of a design is proved.

    Raises DesignError as :func:`with_end_walls` does.
    """
    feet = find_feet(design)
    # What ends where its panels meet has its borders elsewhere after the proof.
    if feet is None or design.ending_at is not None or not any(each.door for each in asked):
        return
    lock = lock_without_clash(design)
    for number, wall in enumerate(asked):
        end = ClosedEnd.of(design, lock, feet, wall.at)
        require_room_for_door(end.border, wall, f"end_wall.{number}", end.highest)


@record
class ClosedEnd:
    """An end of a shell at its target, in the plane of the wall that closes it."""

    column: int  # of the sheet's vertices that are its border
    # unit vectors (3,): along the ground, to the right as seen from outside, and outwards
    right: Array
    out: Array
    origin: Array  # the middle of its width on the ground, in the plane through the shell's origin
    border: Array  # its vertices (R, 2) along the ground and above it
    away: Array  # where these are (R,) outwards
    reach: float  # how far outwards what is built and overlaps the wall along the ground goes
    highest: float  # of all vertices of the sheet over the ground (length)

    @classmethod
    def of(cls, design: Design, lock: Lock, feet: Feet, at: End) -> ClosedEnd:
        """The end of a design whose motion ends as ``lock`` says."""
        mechanism = design.mechanism
        columns = np.arange(mechanism.grid.columns)
        for flap in mechanism.flap_columns:  # which stand in the plane of the border
            columns = columns[1:] if flap == 0 else columns[:-1]
        column, beside = (columns[:2] if at == "first" else columns[:-3:-1]).tolist()
        points = design.hinges.vertices(mechanism.positions(mechanism.target_drive))
        line, next_to = points[:, column], points[:, beside]
        off = line[:, :2] - line[:, :2].mean(axis=0)
        _, _, (_, across) = np.linalg.svd(off, full_matrices=False)
        out = np.append(across, 0.0)
        out *= 1.0 if (line - next_to).mean(axis=0) @ out >= 0 else -1.0
        right = np.cross([0.0, 0.0, 1.0], out)
        along = line @ right
        low, high = float(along.min()), float(along.max())
        ground = feet.z - float(design.origin[2])
        origin = 0.5 * (low + high) * right + np.array([0.0, 0.0, ground])
        border = np.stack([along - 0.5 * (low + high), line[:, 2] - ground], axis=1)
        triangles = standing_triangles(design, lock)
        where = triangles @ right
        beside_it = (where.max(axis=1) < low) | (where.min(axis=1) > high)
        reach = float((triangles[~beside_it] @ out).max())
        highest = float(points[..., 2].max()) - ground
        return cls(column, right, out, origin, border, line @ out, reach, highest)

    @property
    def height(self) -> float:
        """Of its highest vertex over the ground (length)."""
        return float(self.border[:, 1].max())

    @property
    def outermost(self) -> float:
        """How far outwards its border goes (length)."""
        return float(self.away.max())


def _build(design: Design) -> PanelSpec | None:
    """What its strips are made of: as panels are, whole boards on hinges as single ones."""
    if design.has_whole_boards:
        assert design.panel is not None
        return design.panel.replace_unchecked(construction="bevel")
    return design.panel


def _levels(lock: Lock) -> int:
    """At how many heights boards have outlines."""
    return 2 if lock.built is None else lock.built.boards.outlines.shape[1]


def _parts(
    design: Design, end: ClosedEnd, strips: Strips, made: tuple[End, float, PanelSpec | None, int]
) -> Iterator[Part]:
    """A wall as parts: each strip one where it has boards, else all that have sides in common.

    made: The end that it closes, how far it keeps off the shell, what it is made of, at how many
    heights boards have outlines.
    """
    at, gap, build, levels = made
    middle = end.reach + gap + (0.0 if build is None else build.heights[1])
    lying = points_of(design.mechanism, 0.0)[:, :2].mean(axis=0)
    drive = float(np.rad2deg(design.mechanism.target_drive))
    pieces = _hanging_together(strips) if build is None else np.arange(len(strips))
    names = [f"{at} wall {number + 1}" for number in range(len(strips))]
    places = lying - strips.corners.mean(axis=1)
    boards = None if build is None else strips.boards(build, places, levels)
    for piece in range(int(pieces.max()) + 1):
        mine = np.flatnonzero(pieces == piece)
        points, faces = _shared(strips.corners[mine])
        mesh = build_mesh(faces, len(points))
        place = lying - strips.corners[mine].mean(axis=(0, 1))
        own = None
        if boards is not None:
            own = boards.chosen(boards.panels == piece)
            own = replace(own, panels=np.zeros(len(own), np.int64))
        placed = points @ np.stack([end.right, [0.0, 0.0, 1.0]]) + end.origin + middle * end.out
        yield Part(
            title=f"Wall at the {at} end",
            unit="unit",
            mesh=mesh,
            assignment=tuple("F" if each else "B" for each in mesh.crease.tolist()),
            flat=points + place,
            fold_angles_deg=np.zeros(len(mesh.edges)),
            states=(DocumentState(placed, np.zeros(len(mesh.edges)), drive),),
            named={SHELL: 0},
            names=tuple(names[each] for each in mine.tolist()),
            panel=build,
            boards=own,
            kind=END_WALL,
        )


def _hanging_together(strips: Strips) -> Integers:
    """Numbers (P,) of the pieces that strips are of: those with a side in common are of one."""
    points, faces = _shared(strips.corners)
    mesh = build_mesh(faces, len(points))
    return find_components(mesh.edge_faces[mesh.crease], len(strips))


def _shared(corners: Array) -> tuple[Array, Integers]:
    """Distinct points (N, 2) of the corners of strips (P, 4, 2), and the strips (P, 4) in them."""
    points, number = np.unique(corners.reshape(-1, 2), axis=0, return_inverse=True)
    return points, number.reshape(-1, 4).astype(np.int64)


def _built(end: ClosedEnd, wall: EndWall, strips: Strips, gap: float) -> BuiltEndWall:
    face, door = end.reach + gap, wall.door
    rows = np.flatnonzero(end.border[:, 1] > GAP * end.height)
    strings = face - end.away[rows]
    return BuiltEndWall(
        at=wall.at,
        panels=len(strips),
        width=float(np.ptp(strips.top[:, 0])),
        height=float(strips.top[:, 1].max()),
        area=float(strips.areas().sum()),
        clearance=gap,
        farthest=float(face - end.away.min()),
        laced=np.stack([rows, np.full_like(rows, end.column)], axis=1),
        lengths=strings,
        door=None if door is None else Opening(door.width, door.height, door.offset),
    )
