"""The document that files are written from: a sheet, its unit, its states and its curves.

A designed shell and a FOLD file by another program become the same thing here, so that every
format has one writer.

Limit: coordinates are written in double precision, in the place of the curves. A shell a thousand
kilometres from the origin keeps its lengths to ten digits, not fifteen. Put curves near the origin.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.record import record
from orishell.curves import nearby_origin
from orishell.design import PanelSpec
from orishell.document.ground import GroundPlan
from orishell.document.loaded import LoadedShell
from orishell.document.measures import Measures
from orishell.motion.boards import Boards
from orishell.motion.grid import VertexPair
from orishell.motion.mesh import QuadMesh
from orishell.motion.quads import area_vectors, unit_normals
from orishell.numerics.arrays import Array, Integers

LARGEST_COORDINATE = 1e36
"""Coordinates above this are refused: many formats have single precision, which ends at 3e38."""

SHELL = "target"
"""Name of the state that is the shell as it stands."""

FLAT = "flat"
"""Name of the state that is the flat sheet."""


@record
class DocumentState:
    """One folded state of the sheet."""

    positions: Array  # vertices (V, 3) in the document's frame, z up, read-only
    # Fold angles (E,) of the edges, valley positive, NaN where unknown; None if nothing is known of
    # them. In degrees, as files have them: not a bit is lost.
    fold_angles_deg: Array | None = None
    drive_deg: float | None = None  # drive angle; None if the state has none


@dataclass(frozen=True, slots=True)
class FirstContact:
    """Two panels that touch."""

    drive_deg: float  # drive angle at which they do
    panels: tuple[int, int]  # their numbers


@record
class DocumentTie:
    """A tie between two vertices, taut in the shell as it stands."""

    ends: VertexPair  # its vertices by row and column of the grid
    length: float  # from end to end (length)
    slack: bool = False  # whether it is proved to be slack from the pack to there


@record
class Document:
    """A sheet to be written.

    Coordinates of states, curves and surface are in the document's frame: :meth:`in_world` makes
    world coordinates of them, when they are written.
    """

    title: str  # one line that says what it is
    unit: str  # unit of length of all coordinates: mm, cm, m, in, ft; or "unit" if none is known
    mesh: QuadMesh  # panels and edges
    # letter (E,) of every edge: B, M, V, F (unfolded), U (unassigned), C (cut), J (joined)
    assignment: tuple[str, ...]
    # vertices (V, 2) of the flat sheet, read-only; None where only folded states are known
    flat: Array | None
    fold_angles_deg: Array  # fold angles (E,) at the last state, valley positive, NaN where unknown
    # folded states in the order of the motion; may be made one by one as they are asked for
    states: Sequence[DocumentState]
    # rows and columns of vertices, if panels and vertices are numbered row by row; flaps that are
    # no columns come after them, and then all panels have names
    grid_shape: tuple[int, int] | None
    # polylines (k, 3) beside the last state: the curves that the shell follows, by name
    curves: Mapping[str, Array]
    # lattice (a, b, 3) of the surface that the last state follows, if it is known
    surface: Array | None = None
    # signed distances (V,) of the last state's vertices from it, NaN where they do not count
    distances: Array | None = None
    # where the document's frame stands in the world (3,)
    origin: Array = field(default_factory=lambda: np.zeros(3), repr=False)
    # what is known of the shell, as in ``report.json``; empty if nothing is
    report: Mapping[str, object] = field(default_factory=dict, repr=False)
    # what of that its drawing does not show, for those who build it; None if nothing is known
    measures: Measures | None = field(default=None, repr=False)
    # the panels that touch first on the way, if that is known
    contact: FirstContact | None = field(default=None, repr=False)
    # numbers of the states that have a name: "flat", "target" (the shell), "pack"
    named: Mapping[str, int] = field(default_factory=dict)
    # names of the panels; empty if they are called by row and column, or by their numbers
    names: tuple[str, ...] = field(default=(), repr=False)
    # what panels are made of; None if they have no thickness
    panel: PanelSpec | None = field(default=None, repr=False)
    # what is built of the panels; None if they have no thickness
    boards: Boards | None = field(default=None, repr=False)
    # boards that are no part of the sheet and clipped on at the target, in the same frame, flat and
    # in that one state
    clipped: tuple[Document, ...] = field(default=(), repr=False)
    ties: tuple[DocumentTie, ...] = field(default=(), repr=False)
    # its feet in plan; None if it cannot stand, or that was not measured
    ground: GroundPlan | None = field(default=None, repr=False)
    # its size relative to the shell, if it is a model of it; None if it is the shell itself
    model_scale: float | None = field(default=None, repr=False)
    # the shell as a structure; None if it was not analysed
    loaded: LoadedShell | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        flat = () if self.flat is None else (self.flat,)
        largest = max(
            (float(np.abs(each).max()) for each in (*flat, *self.curves.values())), default=0
        )
        if not largest <= LARGEST_COORDINATE:
            raise InputError(
                "the sheet or its curves are too large for files",
                got=f"coordinates up to {largest:.3g}",
                expected=f"up to {LARGEST_COORDINATE:g}",
            )

    @property
    def shell(self) -> DocumentState:
        """The shell as it stands: the target, or the last state where none is called so."""
        return self.state(SHELL)

    def state(self, which: int | str) -> DocumentState:
        """A state by its number, 0 the first, or by its name, as ``which`` says.

        Where no state has a name, "flat" is the first and "target" the last; where there is none
        at all, both are the flat sheet.

        Raises
        ------
        InputError
            If there is no such state.
        """
        count = len(self.states)
        named = {FLAT: 0, SHELL: max(count - 1, 0)} | (dict(self.named) if count else {})
        number = named.get(which, count) if isinstance(which, str) else which
        if number == 0 and not count:
            return self._flat_state()
        if not 0 <= number < count:
            names = " or ".join(f'"{name}"' for name in named)
            raise InputError(
                "there is no such state",
                got=str(which),
                expected=f"{names}, or a number from 0 to {count - 1}",
            )
        return self.states[number]

    def clipped_at(self, which: int | str) -> tuple[Document, ...]:
        """The boards that are clipped on in a state: all where ``which`` is the target, or none."""
        return self.clipped if which in (SHELL, self.named.get(SHELL)) else ()

    def boards_in(self, state: DocumentState) -> Array:
        """Corners (B, H, K, 3) of the outlines of all boards in a state, in the document's frame.

        Raises
        ------
        InputError
            If panels have no thickness.
        """
        if self.boards is None:
            raise InputError(
                "panels have no thickness",
                keys=("panel.thickness",),
                remedy="add the table [panel] to the design file",
            )
        return self.boards.carried(self.mesh.faces, self.require_flat(), state.positions)

    def panel_corners(self, state: DocumentState) -> Array:
        """Corners (F, 4, 3) of all panels in a state, shifted with their boards if these are."""
        corners = state.positions[self.mesh.faces]
        if self.boards is None or self.boards.hinges is None:
            return corners
        shifts = self.boards.hinges.drawn(corners, unit_normals(corners))
        return np.asarray(corners + shifts[:, None])

    def board_name(self, board: int) -> str:
        """What a board is called: its panel and its side, as in "3,12 top"."""
        assert self.boards is not None
        name = self.panel_name(int(self.boards.panels[board]))
        called = self.boards.called(board)
        return f"{name} {called}" if called else name

    def in_world(self, points: Array) -> Array:
        """World coordinates (..., 3) of points (..., 3) of the document's frame."""
        return points + self.origin if self.origin.any() else points

    @property
    def nearby(self) -> Array:
        """An origin (3,) near the shell, for formats with coordinates in single precision.

        In the world, and zero where the shell stands near the world's origin.
        """
        return nearby_origin(self.in_world(self.shell.positions))

    def require_flat(self) -> Array:
        """The flat sheet (V, 2).

        Raises
        ------
        InputError
            If only folded states are known.
        """
        if self.flat is None:
            raise InputError(
                "there is no flat sheet to draw",
                got="folded states only",
                expected='a frame of class "creasePattern"',
            )
        return self.flat

    def require_unit(self) -> str:
        """The unit of length.

        Raises
        ------
        InputError
            If none is known.
        """
        if self.unit not in MILLIMETRES:
            raise InputError(
                "this needs a unit of length, and the sheet names none",
                where="unit",
                got=repr(self.unit),
                expected=", ".join(MILLIMETRES),
            )
        return self.unit

    def panel_name(self, panel: int) -> str:
        """Row and column of a panel, as in "3,12"; its number where it has no other name."""
        if self.names:
            return self.names[panel]
        if self.grid_shape is None:
            return str(panel)
        row, column = divmod(panel, self.grid_shape[1] - 1)
        return f"{row},{column}"

    @property
    def whole_grid(self) -> tuple[int, int] | None:
        """Rows and columns of vertices where there are no panels but those of a grid."""
        shape = self.grid_shape
        if shape is None or (shape[0] - 1) * (shape[1] - 1) != len(self.mesh.faces):
            return None
        return shape

    @property
    def rows_and_columns(self) -> tuple[Integers, Integers] | None:
        """Row (F,) and column (F,) of every panel of a grid and of flaps beside it; else None."""
        if self.grid_shape is None:
            return None
        if self.names:
            rows, columns = np.array([name.split(",") for name in self.names], np.int64).T
        else:
            rows, columns = np.divmod(np.arange(len(self.mesh.faces)), self.grid_shape[1] - 1)
        return rows, columns

    def areas(self) -> Array:
        """Area (F,) of every panel."""
        vertices = self._flat_state() if self.flat is not None else self.shell
        return np.asarray(
            np.linalg.norm(area_vectors(vertices.positions[self.mesh.faces]), axis=-1)
        )

    def edge_lengths(self) -> Array:
        """Length (E,) of every edge of the flat sheet."""
        ends = self.require_flat()[self.mesh.edges]
        return np.asarray(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))

    def _flat_state(self) -> DocumentState:
        flat = self.require_flat()
        return DocumentState(np.column_stack([flat, np.zeros(len(flat))]), drive_deg=0.0)
