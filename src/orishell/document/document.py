"""The document that files are written from: a sheet, its unit, its states and its curves.

A designed shell and a FOLD file by another program become the same thing here, so that every
format has one writer.

Limit: coordinates are written in double precision, in the place of the curves. A shell a thousand
kilometres from the origin keeps its lengths to ten digits, not fifteen. Put curves near the origin.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Self

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.record import record
from orishell.design.part import FLAT, OPEN, DocumentState, Part
from orishell.document.ground import GroundPlan
from orishell.document.joined import joined, joined_states
from orishell.document.loaded import LoadedShell
from orishell.document.measures import Measures
from orishell.motion.grid import VertexPair
from orishell.numerics.arrays import Array, Integers, nearby_origin

LARGEST_COORDINATE = 1e36
"""Coordinates above this are refused: many formats have single precision, which ends at 3e38."""


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
class Document(Part):
    """A sheet to be written, with all that goes with it.

    Coordinates of states, curves and surface are in the document's frame: :meth:`in_world` makes
    world coordinates of them, when they are written.
    """

    # numbers (V,) that vertices of its strips have in the sheet; empty without strips
    cut_from: Integers = field(default_factory=lambda: np.zeros(0, np.int64), repr=False)
    # polylines (k, 3) beside the last state: the curves that the shell follows, by name
    curves: Mapping[str, Array] = field(default_factory=dict)
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
    # parts that go with the sheet, in the same frame: each has the states in which it is there
    attached: tuple[Part, ...] = field(default=(), repr=False)
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
    def sheet(self) -> Self:
        """The sheet that folds, without the parts that go with it."""
        return replace(self, attached=()) if self.attached else self

    def boards_in(self, state: DocumentState) -> Array:
        """Corners (B, H, K, 3) of the outlines of all boards in a state, in the document's frame.

        Raises
        ------
        InputError
            If panels have no thickness.
        """
        if self.cut is None:
            return Part.boards_in(self, state)
        cut = replace(self.cut, panel=self.panel, boards=self.boards)
        return cut.boards_in(replace(state, positions=state.positions[self.cut_from]))

    def as_cut(self) -> Self:
        """The document whose parts are what is cut: itself, or strips in place of whole sheets."""
        off = self.distances
        if self.cut is not None and off is not None:
            off = off[self.cut_from]
        attached = tuple(part.as_cut() for part in self.attached)
        if self.cut is None and attached == self.attached:
            return self
        return replace(Part.as_cut(self), attached=attached, distances=off)

    @property
    def parts(self) -> tuple[Part, ...]:
        """The sheet and all parts that go with it."""
        return (self.sheet, *self.attached)

    def parts_in(self, which: int | str) -> tuple[tuple[Part, DocumentState], ...]:
        """The sheet, and the other parts that are there in a state, each as it is then.

        Parameters
        ----------
        which
            The state by its number or its name.

        Raises
        ------
        InputError
            If there is no such state.
        """
        state = self.state(which)
        if which == FLAT and OPEN in self.named:
            return ((self.sheet, state),)  # strips lie somewhere else than in the shell
        number = self.named.get(which) if isinstance(which, str) else which
        names = {which, *(name for name, at in self.named.items() if at == number)}
        found: list[tuple[Part, DocumentState]] = [(self.sheet, state)]
        for part in self.attached:
            if self.moves(part):
                if part.is_joined_in(state):
                    found.append((part, part.state(which)))
            elif own := names & part.named.keys():
                found.append((part, part.state(own.pop())))
        return tuple(found)

    @property
    def moving(self) -> tuple[Part, ...]:
        """The sheet and all parts that move with it, those that are not there in all states too."""
        return (self.sheet, *(part for part in self.attached if self.moves(part)))

    def with_moving(self, parts: Sequence[Part]) -> Document:
        """The sheet with parts that move with it, as one; itself where there are none."""
        if not parts:
            return self.sheet
        assert not self.hinges.beside, "nothing moves beside whole boards"
        every: tuple[Part, ...] = (self.sheet, *parts)
        flats = [part.require_flat() for part in every]
        return joined(self.sheet, parts, flats, joined_states(every))

    def moves(self, part: Part) -> bool:
        """Whether a ``part`` is there in all states of the sheet, and so moves with it."""
        return len(part.states) == len(self.states) and part.named == self.named

    def in_world(self, points: Array) -> Array:
        """World coordinates (..., 3) of points (..., 3) of the document's frame."""
        return points + self.origin if self.origin.any() else points

    @property
    def nearby(self) -> Array:
        """An origin (3,) near the shell, for formats with coordinates in single precision.

        In the world, and zero where the shell stands near the world's origin.
        """
        return nearby_origin(self.in_world(self.shell.positions))

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
