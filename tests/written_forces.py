"""What ``forces.csv`` says, by panels and creases, for tests that balance them on their own."""

from __future__ import annotations

import csv
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document
from orishell.numerics.arrays import Array
from orishell.structure.pages.force_tables import write_forces
from orishell.structure.results import Analysis

Place = tuple[int, int]


@record
class Acts:
    """A line of the file."""

    share: float  # of the loads
    panel: Place
    acts: str
    beside: Place | None
    vertex: Place | None
    at: Array  # (3,)
    force: Array  # (3,)
    moment: Array  # about that point (3,)

    def about(self, point: Array) -> Array:
        """Force and moment (6,) about another point (3,)."""
        turning = self.moment + np.cross(self.at - point, self.force)
        return np.concatenate([self.force, turning])


def written_forces(
    analysis: Analysis, document: Document, path: Path
) -> dict[tuple[str, str], list[Acts]]:
    """The lines of every case and stiffness of creases, as they are written to a path."""
    write_forces(path, analysis, document)
    found = defaultdict(list)
    with path.open(newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            values = [float(value) for value in list(row.values())[-9:]]
            found[row["case"], row["creases"]].append(
                Acts(
                    float(row["share of loads"]),
                    (int(row["row"]), int(row["column"])),
                    row["acts"],
                    _place(row, "other"),
                    _place(row, "vertex"),
                    *np.reshape(values, (3, 3)),
                )
            )
    return found


def _place(row: dict[str, str], what: str) -> Place | None:
    if not row[f"{what} row"]:
        return None
    return int(row[f"{what} row"]), int(row[f"{what} column"])


def summed(rows: Sequence[Acts], point: Array) -> Array:
    """Their force and moment (6,) about a point (3,)."""
    return np.sum([each.about(point) for each in rows], axis=0) if rows else np.zeros(6)


def size(rows: Sequence[Acts]) -> float:
    """The sizes of their forces together."""
    return float(sum(np.linalg.norm(each.force) for each in rows))


def by_panel(rows: Sequence[Acts]) -> dict[Place, list[Acts]]:
    """Lines of every panel."""
    found = defaultdict(list)
    for each in rows:
        found[each.panel].append(each)
    return found


def both_sides(rows: Sequence[Acts], point: Array) -> Array:
    """Force and moment (C, 2, 6) about a point of both sides of every crease that passes any on."""
    found = {
        (each.panel, each.beside): each.about(point)
        for each in rows
        if each.acts == "crease" and each.beside is not None
    }
    assert len(found) == sum(each.acts == "crease" for each in rows)
    none = np.zeros(6)
    pairs = {(min(pair), max(pair)) for pair in found}
    return np.array([[found.get(pair, none), found.get(pair[::-1], none)] for pair in pairs])
