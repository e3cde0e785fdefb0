"""What a file of a crease pattern says."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES, conversion
from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.numerics.arrays import Array, Integers


@record
class PatternState:
    """A state of the sheet that a file has."""

    title: str  # what the file calls it; empty if it has no name
    positions: Array  # vertices (V, 3)
    fold_angles: Array | None  # fold angles (E,) that the file gives (radians), NaN where none


@record
class ReadPattern:
    """A crease pattern, its folded states, and what was done to read it."""

    path: Path  # where it was read from
    title: str  # what the file calls itself; its name if it does not
    unit: str  # unit of length: mm, cm, m, in, ft; "unit" if the file names none of these
    flat: CreasePattern | None  # the flat sheet; None if there is none
    not_flat: str  # why there is none, in a sentence; empty if there is one
    faces: Integers  # vertices (F, K) around every panel, -1 behind the last
    edges: Integers  # vertices (E, 2) of every edge
    edge_faces: Integers  # panels (E, 2) to the left and to the right of every edge, or -1
    letters: NDArray[np.str_]  # letter (E,) of every edge
    fold_angles: Array  # fold angles (E,) that the file asks for (radians); NaN where for none
    states: tuple[PatternState, ...]  # folded states
    notes: tuple[str, ...]  # what was mended or assumed, in sentences

    def scaled(self, scale: float, unit: str | None = None) -> ReadPattern:
        """All lengths times a number.

        Parameters
        ----------
        scale
            The number.
        unit
            What the unit is then; None if it stays.
        """
        flat = self.flat
        if flat is not None and scale != 1:
            flat = CreasePattern(
                scale * flat.vertices, flat.edges, flat.letters, flat.faces, flat.edge_faces
            )
        states = tuple(replace(each, positions=scale * each.positions) for each in self.states)
        return replace(self, flat=flat, states=states, unit=unit or self.unit)

    def in_unit(self, unit: str) -> ReadPattern:
        """The pattern and its states in another unit.

        Parameters
        ----------
        unit
            The unit: mm, cm, m, in, ft.

        Raises
        ------
        InputError
            If the file does not say what its unit is.
        """
        if self.unit not in MILLIMETRES:
            raise InputError(
                "the pattern has no unit of length",
                where=f"{self.path}:",
                expected="a file that states one, or the unit of its coordinates",
                remedy='unit = "mm" for coordinates in millimetres',
            )
        return self.scaled(conversion(self.unit, unit), unit)
