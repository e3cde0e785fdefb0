"""A shell on the ground, as files and the report have it: a plan of its feet, and what it needs.

The plan's origin is the corner of the smallest rectangle along x and y around all feet, where x and
y are least.
"""

from __future__ import annotations

from math import hypot

from orishell.conventions.record import Angle, record
from orishell.motion.grid import Vertex
from orishell.numerics.arrays import Array


@record
class GroundFoot:
    """A foot, and what the structure asks of the ground there."""

    number: int  # from 1, row by row
    at: Vertex  # row and column of its vertex in the whole grid
    # where it is, from the corner, and how high over the lowest foot (length)
    x: float
    y: float
    z: float
    # the largest forces on the ground: down, up, and along it (N); None without a structure
    push: float | None = None
    pull: float | None = None
    sideways: float | None = None
    ballast: float | None = None  # mass that holds it without an anchor (kg); None likewise

    @property
    def asked(self) -> tuple[float | None, ...]:
        """What is asked of the ground: forces down, up and along it (N), and ballast (kg)."""
        return self.push, self.pull, self.sideways, self.ballast

    def apart(self, other: GroundFoot) -> float:
        """How far it is from another foot, on the plan (length)."""
        return hypot(self.x - other.x, self.y - other.y)


@record
class SweptGround:
    """The ground that a shell needs on its way to the target: it is proved to stay inside.

    But for the last billionth of the way, of which both ends are known. The middle between its feet
    stays where it is at the target.
    """

    REPORTED = (
        "outline", "width", "depth", "area", "height", "highest_at", "below", "lowest_at",
        "margin", "states",
    )  # fmt: skip

    hull: Array  # its outline (K, 2), convex, from the corner, counter-clockwise (length)
    # size of the rectangle around it along x and y (length), and its area
    width: float
    depth: float
    area: float
    height: float  # the greatest height of a state, from its lowest place to its highest (length)
    highest_at: Angle  # the drive at which it is so high
    below: float  # how far parts get below the middle between the feet (length)
    lowest_at: Angle  # the drive at which they do
    # what outline and heights have in addition for the way between the states that were made
    margin: float
    states: int  # how many these are

    @property
    def outline(self) -> tuple[tuple[float, float], ...]:
        """The corners of its outline."""
        return _pairs(self.hull)


@record
class GroundPlan:
    """A plan of the feet of a shell at its target."""

    REPORTED = ("corner", "feet", "outline", "swept")

    corner: tuple[float, float]  # the corner in world coordinates, x and y
    feet: tuple[GroundFoot, ...]
    hull: Array  # convex hull (K, 2) of the plan of the shell, from the corner (length)
    # the ground that it needs on its way; None where it is opened in pieces, or moves so
    # fast somewhere that nobody knows
    swept: SweptGround | None
    # where end walls stand on the ground: both ends (2, 2) of each stretch, doors left out
    walls: tuple[Array, ...] = ()

    @property
    def crossed(self) -> tuple[tuple[GroundFoot, GroundFoot], ...]:
        """Pairs of feet across its corners; none where there are no two rows of them."""
        row = [foot for foot in self.feet if foot.at[0] == self.feet[0].at[0]]
        if not 1 < len(row) < len(self.feet) - 1:
            return ()
        return (self.feet[0], self.feet[-1]), (row[-1], self.feet[len(row)])

    @property
    def drawn(self) -> tuple[Array, ...]:
        """Points (K, 2) of the lines of the plan: outlines, and stretches of walls."""
        outlines = (self.hull,) if self.swept is None else (self.hull, self.swept.hull)
        return (*outlines, *self.walls)

    @property
    def outline(self) -> tuple[tuple[float, float], ...]:
        """The corners of the convex hull of the shell."""
        return _pairs(self.hull)

    def table(self, unit: str) -> tuple[list[str], list[list[object]]]:
        """Names of columns, and a row for each foot: from the corner, and in world coordinates.

        What is asked of the ground is empty where it is not known.
        """
        x, y = self.corner
        heads = [
            *("foot", "row", "column"),
            *(f"{name}_{unit}" for name in ("x", "y", "z", "world_x", "world_y")),
            *("push_N", "pull_N", "sideways_N", "ballast_kg"),
        ]
        rows: list[list[object]] = [
            [
                *(foot.number, *foot.at, foot.x, foot.y, foot.z, x + foot.x, y + foot.y),
                *("" if each is None else each for each in foot.asked),
            ]
            for foot in self.feet
        ]
        return heads, rows


def _pairs(corners: Array) -> tuple[tuple[float, float], ...]:
    return tuple((x, y) for x, y in corners.tolist())
