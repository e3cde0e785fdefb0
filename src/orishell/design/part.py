"""A part of a shell: rigid panels that are made as one piece, and where they are in its states.

The sheet that folds is one. Others go with it: flaps that are clipped on at its target, and what
else is put in or hung on. Drawings, bill, files and proof take all of them alike.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from typing import Self, overload

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.design.holes import Holes
from orishell.design.hung import HungLines
from orishell.design.panel import PanelSpec
from orishell.design.stiffeners import Plate
from orishell.motion.boards import Boards
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.mesh import QuadMesh
from orishell.motion.quads import area_vectors, unit_normals
from orishell.numerics.arrays import Array, Integers

SHELL = "target"
"""Name of the state that is the shell as it stands."""

FLAT = "flat"
"""Name of the state that is the flat sheet."""

OPEN = "open"
"""Name of that state of a sheet which is flat in none, where its flattest panels lie level."""


@record
class DocumentState:
    """One folded state of the sheet."""

    positions: Array  # vertices (V, 3) in the document's frame, z up, read-only
    # Fold angles (E,) of the edges, valley positive, NaN where unknown; None if nothing is known of
    # them. In degrees, as files have them: not a bit is lost.
    fold_angles_deg: Array | None = None
    drive_deg: float | None = None  # drive angle; None if the state has none


class MadeStates(Sequence[DocumentState]):
    """So many states, each made by its number when it is taken."""

    def __init__(self, count: int, make: Callable[[int], DocumentState]) -> None:
        self._numbers, self._make = range(count), make

    def __len__(self) -> int:
        return len(self._numbers)

    @overload
    def __getitem__(self, which: int) -> DocumentState: ...
    @overload
    def __getitem__(self, which: slice) -> Sequence[DocumentState]: ...
    def __getitem__(self, which: int | slice) -> DocumentState | Sequence[DocumentState]:
        chosen = self._numbers[which]
        return self._make(chosen) if isinstance(chosen, int) else list(map(self._make, chosen))


@record
class Part:
    """Panels that are made as one piece, flat and in states, with the boards on them.

    Coordinates are in the frame of the document that it belongs to.
    """

    title: str  # one line that says what it is
    unit: str  # unit of length of all coordinates: mm, cm, m, in, ft; or "unit" if none is known
    mesh: QuadMesh  # panels and edges
    # letter (E,) of every edge: B, M, V, F (unfolded), U (unassigned), C (cut), J (joined)
    assignment: tuple[str, ...]
    # vertices (V, 2) as it is cut, read-only; None where only folded states are known
    flat: Array | None
    fold_angles_deg: Array  # fold angles (E,) at the target, valley positive, NaN where unknown
    # folded states in the order of the motion; may be made one by one as they are asked for
    states: Sequence[DocumentState]
    # rows and columns of vertices, if panels and vertices are numbered row by row; flaps that are
    # no columns come after them, and then all panels have names
    grid_shape: tuple[int, int] | None = None
    # numbers of the states that have a name: "flat", "target" (the shell), "pack"
    named: Mapping[str, int] = field(default_factory=dict)
    # names of the panels; empty if they are called by row and column, or by their numbers
    names: tuple[str, ...] = field(default=(), repr=False)
    # the drive below which it is not there, although it moves along with the sheet (degrees)
    joined_from_deg: float = 0.0
    # what panels are made of; None if they have no thickness
    panel: PanelSpec | None = field(default=None, repr=False)
    # what its boards are made of, by the name of a material, if that is not what the sheet's are
    material: str = field(default="", repr=False)
    # what is built of the panels; None if they have no thickness
    boards: Boards | None = field(default=None, repr=False)
    # what is drilled through its boards; None if nothing is
    holes: Holes | None = field(default=None, repr=False)
    # where it hangs on the sheet as that moves; None if it does not
    hung: HungLines | None = field(default=None, repr=False)
    # where others hang on its own panels as the sheet moves; None if none do
    bears: HungLines | None = field(default=None, repr=False)
    # what the booklet calls parts of its kind: "sheet", "flap"
    kind: str = field(default="sheet", repr=False)
    # rows and columns (K, 2) of the sheet's vertices that bear it; None for the sheet itself, and
    # for what stands on the ground by itself
    borne_at: Integers | None = field(default=None, repr=False)
    # the share (K,) of its mass that each of these bears; None if they bear as much each
    borne_shares: Array | None = field(default=None, repr=False)
    # where it is a plate that stiffens the shell; None if it stiffens nothing
    plate: Plate | None = field(default=None, repr=False)
    # it as it is cut, where it is no one flat sheet: strips that are joined; else None
    cut: Part | None = field(default=None, repr=False)

    @property
    def sheet(self) -> Self:
        """The part without others that go with it."""
        return self

    @property
    def parts(self) -> tuple[Part, ...]:
        """The part, and others that go with it."""
        return (self,)

    def as_cut(self) -> Self:
        """The part as it is cut: itself, or its strips in its place."""
        if self.cut is None:
            return self
        names = ("mesh", "assignment", "flat", "fold_angles_deg", "states")
        return replace(self, cut=None, **{name: getattr(self.cut, name) for name in names})

    @property
    def hinges(self) -> HingeLines:
        """Where its hinges are: in the creases, but for whole boards."""
        return IN_CREASES if self.boards is None else self.boards.hinges

    def parts_in(self, which: int | str) -> tuple[tuple[Part, DocumentState], ...]:
        """The part, and others that are there in a state, each as it is then.

        Parameters
        ----------
        which
            The state by its number or its name.

        Raises
        ------
        InputError
            If there is no such state.
        """
        return ((self, self.state(which)),)

    @property
    def shell(self) -> DocumentState:
        """The shell as it stands: the target, or the last state where none is called so."""
        return self.state(SHELL)

    def state(self, which: int | str) -> DocumentState:
        """A state by its number, 0 the first, or by its name, as ``which`` says.

        Where no state has a name, "flat" is the first and "target" the last; where there is none
        at all, both are the flat sheet. What is "open" in one state is flat in none, but its strips
        lie flat as they are cut.

        Raises
        ------
        InputError
            If there is no such state.
        """
        count = len(self.states)
        begin = {} if OPEN in self.named else {FLAT: 0}
        named = begin | {SHELL: max(count - 1, 0)} | (dict(self.named) if count else {})
        number = named.get(which, count) if isinstance(which, str) else which
        lies = which == FLAT and FLAT not in named and self.flat is not None
        if lies or (number == 0 and not count):
            return self._flat_state()
        if not 0 <= number < count:
            names = " or ".join(f'"{name}"' for name in named)
            raise InputError(
                "there is no such state",
                got=str(which),
                expected=f"{names}, or a number from 0 to {count - 1}",
            )
        return self.states[number]

    def is_joined_in(self, state: DocumentState) -> bool:
        """Whether it is there in a ``state`` of the sheet that it moves with."""
        return state.drive_deg is None or state.drive_deg >= self.joined_from_deg

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

    def corners(self, state: DocumentState) -> Array:
        """Corners (K, 3) of all boards in a ``state``; vertices if panels have no thickness."""
        if self.boards is None:
            return state.positions
        return self.boards_in(state).reshape(-1, 3)

    def panel_corners(self, state: DocumentState) -> Array:
        """Corners (F, 4, 3) of all panels in a state, shifted with their boards if these are."""
        corners = state.positions[self.mesh.faces]
        if not self.hinges.beside:
            return corners
        shifts = self.hinges.drawn(corners, unit_normals(corners))
        return np.asarray(corners + shifts[:, None])

    def mass(self, areal_mass: float, metres: float) -> float:
        """Its mass (kg): of its boards if their density is known, or by that of its area.

        Parameters
        ----------
        areal_mass
            Mass by area (kg per square of the unit).
        metres
            The unit of length (m).
        """
        if self.boards is None or self.panel is None or not self.panel.density:
            return areal_mass * float(self.areas().sum())
        return self.panel.density * metres**3 * float(self.boards.volumes().sum())

    def board_name(self, board: int) -> str:
        """What a board is called: its panel and its side, as in "3,12 top"."""
        assert self.boards is not None
        name = self.panel_name(int(self.boards.panels[board]))
        called = self.boards.called(board)
        return f"{name} {called}" if called else name

    def require_flat(self) -> Array:
        """The flat sheet (V, 2).

        Raises
        ------
        InputError
            If there is none: it is made of strips, or only folded states are known.
        """
        if self.cut is not None:
            raise InputError(
                "the shell is no one flat sheet: it is made of strips that are joined",
                expected="a sheet that is flat before it is folded",
                remedy="write its states (fold, obj, glb) or its strips (dxf, svg, pdf)",
            )
        if self.flat is None:
            raise InputError(
                "there is no flat sheet to draw",
                got="folded states only",
                expected='a frame of class "creasePattern"',
            )
        return self.flat

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
        shape, faces = self.grid_shape, self.mesh.faces
        if shape is None or (shape[0] - 1) * (shape[1] - 1) != len(faces):
            return None
        return shape if faces.max() + 1 == shape[0] * shape[1] else None

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
        """Length (E,) of every edge."""
        places = self.shell.positions if self.flat is None else self.flat
        ends = places[self.mesh.edges]
        return np.asarray(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))

    def _flat_state(self) -> DocumentState:
        flat = self.require_flat()
        return DocumentState(np.column_stack([flat, np.zeros(len(flat))]), drive_deg=0.0)
