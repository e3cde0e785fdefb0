"""The document of a designed shell: what its files are written from."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import NDArray

from orishell.design import Design
from orishell.document import Document, DocumentState
from orishell.mesh import build_mesh
from orishell.motion import FoldedState, FoldingMotion, find_assignment
from orishell.pattern import CreaseValues, edges_assignment
from orishell.quoting import in_one_line, tidy_degrees

Array = NDArray[np.float64]
Booleans = NDArray[np.bool_]

Passing = Callable[[FoldingMotion], Iterable[FoldedState]]
"""Passes the states of a motion on and may show how far it has come."""


def document_of_motion(
    motion: FoldingMotion,
    unit: str,
    *,
    title: str = "Origami shell",
    curves: Mapping[str, Array] | None = None,
    origin: Array | None = None,
) -> Document:
    """The document of a motion; its states are made when a format asks for them.

    Parameters
    ----------
    motion
        The motion, from flat to locked.
    unit
        Unit of length of the coordinates.
    title
        One line that says what it is.
    curves
        Polylines (k, 3) that the locked shell follows, by name.
    origin
        Where the motion's frame stands in the world (3,); None for the world's origin.
    """
    grid = motion.mechanism.grid
    states = states_of(motion)
    return Document(
        title=title,
        unit=unit,
        mesh=build_mesh(grid.faces_vertices(), grid.vertex_count, grid.edges_vertices()),
        assignment=tuple(edges_assignment(find_assignment(motion.mechanism))),
        flat=_clean(motion.flat.positions[..., :2].reshape(-1, 2)),
        fold_angles_deg=_degrees(motion.locked.fold_angles, states.folds),
        states=states,
        grid_shape=(grid.rows, grid.columns),
        curves=dict(curves or {}),
        origin=np.zeros(3) if origin is None else origin,
    )


def document_of_design(design: Design, unit: str = "unit", *, frames: int = 25) -> Document:
    """The document of what a family's design function returns: to be shown, or written.

    Parameters
    ----------
    design
        The design.
    unit
        Unit of length of the coordinates; "unit" if none is known.
    frames
        Number of states from flat to locked.
    """
    motion = FoldingMotion(design.mechanism, frames)
    return document_of_motion(motion, unit, curves=design.targets)


def _passed_on(motion: FoldingMotion) -> Iterable[FoldedState]:
    return motion


def states_of(motion: FoldingMotion, passing: Passing = _passed_on) -> States:
    """The states of a motion, made as they are taken.

    Parameters
    ----------
    motion
        The motion.
    passing
        Watches the states go by when all are taken.
    """
    return States(motion, passing, find_assignment(motion.mechanism).on_edges() != 0)


@dataclass(frozen=True, slots=True, eq=False)
class States(Sequence[DocumentState]):
    """The states of a motion, made one by one.

    Parameters
    ----------
    motion
        The motion.
    passing
        Watches the states go by when all are taken.
    folds
        Which edges (E,) fold: the others have an angle of exactly 0.
    """

    motion: FoldingMotion
    passing: Passing
    folds: Booleans

    __repr__ = in_one_line

    def __len__(self) -> int:
        return len(self.motion)

    def __iter__(self) -> Iterator[DocumentState]:
        return (self._written(state) for state in self.passing(self.motion))

    @overload
    def __getitem__(self, number: int) -> DocumentState: ...

    @overload
    def __getitem__(self, number: slice) -> Sequence[DocumentState]: ...

    def __getitem__(self, number: int | slice) -> DocumentState | Sequence[DocumentState]:
        drives = self.motion.drives[number]
        if isinstance(number, slice):
            return [self._at(float(drive)) for drive in drives]
        return self._at(float(drives))

    def _at(self, drive: float) -> DocumentState:
        return self._written(FoldedState.of(self.motion.mechanism, drive))

    def _written(self, state: FoldedState) -> DocumentState:
        return DocumentState(
            positions=_clean(state.positions.reshape(-1, 3)),
            fold_angles_deg=_degrees(state.fold_angles, self.folds),
            drive_deg=tidy_degrees(state.drive),
        )


def _degrees(angles: CreaseValues, folds: Booleans) -> Array:
    return _clean(np.where(folds, np.rad2deg(angles.on_edges()), 0.0))


def _clean(array: Array) -> Array:
    """Contiguous, read-only, and without negative zeros."""
    result = np.ascontiguousarray(array + 0.0)
    result.flags.writeable = False
    return result
