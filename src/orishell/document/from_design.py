"""The document of a designed shell: what its files are written from."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar, overload

import numpy as np

from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, followed, no_progress
from orishell.conventions.record import record
from orishell.design import Design, PanelSpec
from orishell.design.carried import CarriedPart
from orishell.document import SHELL, Document, DocumentState, Part
from orishell.motion import FoldedState, FoldingMotion, Mechanism, find_assignment
from orishell.motion.as_made import AsMade, in_strips, laid_flat, sides_of_strips
from orishell.motion.boards import Boards
from orishell.motion.grid import CreaseValues, Grid, edges_assignment
from orishell.motion.layout import (
    Layout,
    SlitFlaps,
    edge_folds,
    edge_signs,
    mesh_of,
    points_of,
)
from orishell.motion.mesh import QuadMesh, build_mesh
from orishell.numerics.arrays import Array, Booleans, Integers


def document_of_motion(
    motion: FoldingMotion,
    unit: str,
    *,
    title: str = "Origami shell",
    curves: Mapping[str, Array] | None = None,
    origin: Array | None = None,
    clipped: Mechanism | None = None,
    panel: PanelSpec | None = None,
    boards: Boards | None = None,
    flaps: Boards | None = None,
    carried: Iterable[CarriedPart] = (),
    attached: Iterable[Part] = (),
) -> Document:
    """The document of a motion; its states are made when a format asks for them.

    Arguments are as the fields of :class:`~orishell.document.Document`; ``clipped`` is the sheet
    with flaps that are clipped on at the target, and ``flaps`` are its boards. They are the first
    of the parts that go with the sheet, what it has ``carried`` follows, and then what else is
    ``attached``.
    """
    mechanism = motion.mechanism
    grid, states, flat = mechanism.grid, states_of(motion), _flat(mechanism)
    strips = None if flat is not None else in_strips(mechanism)
    beside = isinstance(mechanism, SlitFlaps)
    return Document(
        title=title,
        unit=unit,
        mesh=states.mesh,
        assignment=states.letters(),
        flat=flat,
        fold_angles_deg=states.degrees(mechanism.target_drive),
        states=states,
        cut=_cut(motion, strips, unit),
        cut_from=np.zeros(0, np.int64) if strips is None else strips.vertices,
        grid_shape=(grid.rows, grid.columns),
        curves=dict(curves or {}),
        origin=np.zeros(3) if origin is None else origin,
        named=motion.named,
        panel=panel,
        boards=boards,
        names=_names(Layout.of(mechanism)) if beside else (),
        attached=(
            *(() if clipped is None else _clipped(clipped, unit, panel, flaps)),
            *(_carried(each, motion, unit, panel) for each in carried),
            *(replace(part, unit=unit) for part in attached),
        ),
    )


def document_of_design(
    design: Design,
    unit: str = "unit",
    *,
    frames: int = 25,
    boards: Boards | None = None,
    flaps: Boards | None = None,
) -> Document:
    """The document of a design as a family's design function returns it.

    Its ``boards``, and those of ``flaps`` that are clipped on, are as they are built of its panels.
    """
    return document_of_motion(
        FoldingMotion(design.mechanism, frames),
        unit,
        curves=design.targets,
        clipped=design.clipped,
        panel=None if boards is None else design.panel,
        boards=boards,
        flaps=flaps,
        carried=design.carried,
        attached=design.attached,
    )


def document_at(document: Document, drive: float) -> Document:
    """The document of a designed shell in one state, which takes the name "target".

    Of the parts that go with the sheet it has those that are there in that state.

    Parameters
    ----------
    drive
        The drive angle of the state (radians).
    """
    assert isinstance(document.states, States)
    state = document.states.at(drive)
    stands = drive == document.states.motion.mechanism.target_drive
    attached = []
    for part in document.attached:
        if isinstance(part.states, States):
            if part.is_joined_in(state):
                attached.append(_in_state(part, part.states.at(drive)))
        elif stands:
            attached.append(_in_state(part, part.shell))
    return replace(_in_state(document, state), attached=tuple(attached))


AnyPart = TypeVar("AnyPart", bound=Part)


def _in_state(part: AnyPart, state: DocumentState) -> AnyPart:
    return replace(part, states=(state,), named={SHELL: 0})


def _carried(part: CarriedPart, motion: FoldingMotion, unit: str, panel: PanelSpec | None) -> Part:
    """Strips that the sheet carries, in all states of it."""
    strips = part.strips
    own, flat = replace(motion, mechanism=strips), _flat(strips)
    grid, states = strips.grid, states_of(own)
    return Part(
        title=part.title,
        unit=unit,
        mesh=states.mesh,
        assignment=states.letters(),
        flat=flat,
        fold_angles_deg=states.degrees(strips.target_drive),
        states=states,
        cut=_cut(own, None if flat is not None else in_strips(strips), unit),
        grid_shape=(grid.rows, grid.columns),
        named=motion.named,
        names=part.names,
        panel=panel,
        boards=part.boards,
        joined_from_deg=float(np.rad2deg(part.joined_from)),
        hung=part.hung,
        bears=part.bears,
        kind=part.kind,
        borne_at=part.borne_at,
    )


def _clipped(
    mechanism: Mechanism, unit: str, panel: PanelSpec | None, boards: Boards | None
) -> tuple[Part, ...]:
    """The flaps that are clipped on a sheet, each a part."""
    if isinstance(mechanism, SlitFlaps):
        return tuple(_clipped_pairs(mechanism, unit, panel, boards))
    return _clipped_strips(mechanism, unit, panel, boards)


def _clipped_pairs(
    mechanism: Mechanism, unit: str, panel: PanelSpec | None, boards: Boards | None
) -> Iterator[Part]:
    """Slit flaps, two at a time with the crease between them, in the sheet's frame.

    Panels are called as they are where they fold with the sheet.
    """
    assert isinstance(mechanism, SlitFlaps)
    layout, target = mechanism.layout, mechanism.target_drive
    flat, points = points_of(mechanism, 0.0)[:, :2], points_of(mechanism, target)
    folds, names = mechanism.flap_folds(target), _names(layout)
    for pair, fold in zip(layout.pairs, folds, strict=True):
        own, numbers = np.unique(layout.faces[pair], return_inverse=True)
        mesh = build_mesh(numbers.reshape(2, 4), len(own))
        letters = np.where(mesh.crease, "V" if fold > 0 else "M", "B")
        angles = _degrees(np.full(len(letters), fold), mesh.crease)
        upper, lower = (names[each] for each in pair)
        yield Part(
            title=f"Boards {upper} and {lower}, clipped on",
            unit=unit,
            mesh=mesh,
            assignment=tuple(letters.tolist()),
            flat=_clean(flat[own]),
            fold_angles_deg=angles,
            states=(DocumentState(_clean(points[own]), angles, tidy_degrees(target)),),
            named={SHELL: 0},
            panel=panel,
            boards=boards and _of_pair(boards, pair),
            names=(upper, lower),
            kind="flap",
        )


def _clipped_strips(
    mechanism: Mechanism, unit: str, panel: PanelSpec | None, boards: Boards | None
) -> tuple[Part, ...]:
    """The flaps of a sheet, each a strip of panels on its own, in the sheet's frame.

    Panels have the row and column that they have beside the sheet: left of column 0 is column -1.
    """
    grid, strip = mechanism.grid, Grid(mechanism.grid.rows, 2)
    mesh = build_mesh(strip.faces_vertices(), strip.vertex_count, strip.edges_vertices())
    sides, target = sides_of_strips(mechanism), FoldedState.of(mechanism, mechanism.target_drive)
    signs = find_assignment(mechanism)
    strips = []
    for flap in mechanism.flap_columns:
        ends, column = slice(flap, flap + 2), flap - mechanism.inner_columns.start
        mine, folds = (
            CreaseValues(each.row[:, flap : flap + 1], np.zeros((grid.rows - 1, 0)))
            for each in (signs, target.fold_angles)
        )
        angles = _degrees(folds.on_edges(), mine.on_edges() != 0)
        positions = _clean(target.positions[:, ends].reshape(-1, 3))
        strips.append(
            Part(
                title=f"Board clipped on beside column {max(column - 1, 0)}",
                unit=unit,
                mesh=mesh,
                assignment=tuple(edges_assignment(mine)),
                flat=_clean(np.stack([side[:, flap] for side in sides], axis=1).reshape(-1, 2)),
                fold_angles_deg=angles,
                states=(DocumentState(positions, angles, tidy_degrees(target.drive)),),
                grid_shape=(strip.rows, strip.columns),
                named={SHELL: 0},
                panel=panel,
                boards=boards and _of_column(boards, flap, grid.columns - 1),
                names=tuple(f"{row},{column}" for row in range(grid.rows - 1)),
                kind="flap",
            )
        )
    return tuple(strips)


def _of_column(boards: Boards, column: int, columns: int) -> Boards:
    """The boards of one column of panels, as a strip on its own."""
    mine = boards.chosen(boards.panels % columns == column)
    return replace(mine, panels=mine.panels // columns)


def _of_pair(boards: Boards, pair: Integers) -> Boards:
    """The boards of two panels, as a sheet on their own."""
    mine = boards.chosen(np.isin(boards.panels, pair))
    return replace(mine, panels=np.searchsorted(pair, mine.panels))


def states_of(motion: FoldingMotion, progress: Progress = no_progress, what: str = "") -> States:
    """The states of a motion, made as they are taken; ``what`` is told with their progress."""
    return States(motion, mesh_of(motion.mechanism), edge_signs(motion.mechanism), progress, what)


def _cut(motion: FoldingMotion, made: AsMade | None, unit: str) -> Part | None:
    """The strips that a sheet is made of, in all states of it; None if it is of none."""
    if made is None:
        return None
    own = motion, made.mesh, edge_signs(motion.mechanism)[made.edges]
    states = States(*own, vertices=made.vertices, edges=made.edges)
    return Part(
        title="Strips, to be joined",
        unit=unit,
        mesh=made.mesh,
        assignment=states.letters(),
        flat=_clean(made.flat),
        fold_angles_deg=states.degrees(motion.mechanism.target_drive),
        states=states,
        named=motion.named,
    )


def _flat(mechanism: Mechanism) -> Array | None:
    """Vertices (V, 2) of the flat sheet; None where it is made in strips."""
    flat = laid_flat(mechanism)
    return None if flat is None else _clean(flat)


@record
class States(Sequence[DocumentState]):
    """The states of a motion, made one by one."""

    motion: FoldingMotion
    mesh: QuadMesh  # panels and edges
    # signs (E,) of edges, 0 for those that do not fold: their angle is exactly 0
    signs: Integers
    # is told the share that is done when all are taken, and what for
    progress: Progress = no_progress
    what: str = ""
    # numbers of the vertices (V,) and edges (E,) of the mesh in the mechanism; None: its own
    vertices: Integers | None = None
    edges: Integers | None = None

    def __len__(self) -> int:
        return len(self.motion)

    def __iter__(self) -> Iterator[DocumentState]:
        states = followed(self.motion.drives, len(self.motion), self.progress, self.what)
        return (self.at(float(drive)) for drive in states)

    @overload
    def __getitem__(self, number: int) -> DocumentState: ...

    @overload
    def __getitem__(self, number: slice) -> Sequence[DocumentState]: ...

    def __getitem__(self, number: int | slice) -> DocumentState | Sequence[DocumentState]:
        drives = self.motion.drives[number]
        if isinstance(number, slice):
            return [self.at(float(drive)) for drive in drives]
        return self.at(float(drives))

    def at(self, drive: float) -> DocumentState:
        """The state at any drive.

        Parameters
        ----------
        drive
            The drive angle (radians).
        """
        mechanism = self.motion.mechanism
        points = points_of(mechanism, drive)
        return DocumentState(
            positions=_clean(points if self.vertices is None else points[self.vertices]),
            fold_angles_deg=self.degrees(drive),
            drive_deg=tidy_degrees(drive),
        )

    def degrees(self, drive: float) -> Array:
        """Fold angles (E,) of all edges at a drive, 0 where they do not fold (degrees).

        Parameters
        ----------
        drive
            The drive angle (radians).
        """
        folds = edge_folds(self.motion.mechanism, drive)
        if self.edges is not None:
            folds = folds[self.edges]
        return _degrees(folds, self.mesh.crease & (self.signs != 0))

    def letters(self) -> tuple[str, ...]:
        """Assignment letters (E,) of all edges."""
        found = np.where(self.mesh.crease, np.array([*"MFV"])[self.signs + 1], "B")
        return tuple(found.tolist())


def _names(layout: Layout) -> tuple[str, ...]:
    return tuple(f"{row},{column}" for row, column in layout.names.tolist())


def _degrees(angles: Array, folds: Booleans) -> Array:
    """Angles (E,) of edges in degrees, 0 where they do not fold."""
    return _clean(np.where(folds, np.rad2deg(angles), 0.0))


def _clean(array: Array) -> Array:
    """Contiguous, read-only, and without negative zeros."""
    result = np.ascontiguousarray(array + 0.0)
    result.flags.writeable = False
    return result
