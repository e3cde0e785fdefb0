"""Designs of every family whose shells are asked for sizes, and OBJ files as a reader measures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.numerics.arrays import Array

Tables = dict[str, Any]

ARCH = {"formula": ["1.5*cos(t)", "2.4*sin(t)"], "range": [0, 3.141592653589793]}
WAVE = {"formula": "0.1*cos(2*pi*x)", "range": [0, 3]}
LOW = {"formula": "2.6 - 0.8*x**2", "range": [-1.5, 1.5]}
BEND = {"formula": ["8*sin(t)", "8*cos(t) - 8"], "range": [0, 0.7]}
LINE = {"formula": "0*x", "range": [0, 4]}
BARREL = {"formula": "sqrt(5 - x**2)", "x": [-1.8, 1.8], "y": [-1.5, 1.5]}
SADDLE = {"formula": "1.5 + 0.1*x**2 - 0.2*y**2", "x": [-2, 2], "y": [-2, 2]}


def design(family: str, target: Tables, pattern: Tables, **tables: Any) -> Tables:
    """A design in metres, of few states."""
    return {
        "shell": {"family": family, "unit": "m"},
        "target": target,
        "pattern": pattern,
        "motion": {"frames": 3},
        **tables,
    }


SQUARE = {"rows": 7, "columns": 7, "depth": 0.15, "heading_deg": 90, "spacing": "equal"}
PACK = {"from": "pack", "flap_attachment": "clipped"}
DESIGNS: dict[str, Tables] = {
    "orthodiagonal": design("orthodiagonal", {"f": ARCH, "g": WAVE}, {**SQUARE, "flap": 0.1}),
    "clipped": design(
        "orthodiagonal", {"f": ARCH, "g": WAVE}, {**SQUARE, "flap": 0.1}, deployment=PACK
    ),
    "auto": design("orthodiagonal", {"f": ARCH, "g": WAVE}, {"rows": 7, "columns": 7}),
    "boards": design(
        "orthodiagonal",
        {"f": ARCH, "g": WAVE},
        {**SQUARE, "flap": 0.1},
        panel={"thickness": 0.01, "membrane": 0.0005},
    ),
    "hinged": design(
        "orthodiagonal",
        {"f": ARCH, "g": WAVE},
        {**SQUARE, "flap": 0},
        panel={"thickness": 0.01, "construction": "hinged"},
        deployment={"from": "pack"},
    ),
    "parallel": design("parallel-repeating", {"f": LOW, "g": LINE}, {"rows": 9, "columns": 9}),
    "bend": design("parallel-repeating", {"f": LOW, "g": BEND}, {"rows": 9, "columns": 11}),
    "longitudinal": design(
        "longitudinal-linear-repeating",
        {"f": {"formula": ["2*cos(t)", "2*sin(t)"], "range": [0.1, 3.04]}, "g": LINE},
        {"rows": 7, "columns": 9, "sector_deg": [88, 86, 92, 94]},
    ),
    "fitted": design(
        "flat-foldable",
        {"surface": SADDLE},
        {"rows": 5, "columns": 5, "direction_deg": 0, "fold_deg": 92},
    ),
    "swept": design("orthodiagonal", {"surface": BARREL}, {"rows": 9, "columns": 7}),
    "tolerance": design(
        "orthodiagonal", {"f": ARCH, "g": LINE}, {"depth": 0.12}, tolerance={"surface": 0.2}
    ),
}
DESIGNS["drawn"] = {**parse_toml(starter_file("pattern")), "motion": {"frames": 3}}


def _own(outside: str, inside: str) -> dict[str, dict[str, float]]:
    sizes = (dict(each.split("=") for each in text.split()) for text in (outside, inside))
    out, within = ({key: float(each) for key, each in found.items()} for found in sizes)
    return {"outside": out, "inside": within}


ROOM = "depth=1.8 height=2.2"
OWN = {
    "orthodiagonal": _own("width=3 depth=3.1 height=2.4", ROOM),
    "clipped": _own("width=3 depth=3.1 height=2.4", ROOM),
    "auto": _own("width=3 depth=4 height=2.9", "depth=1.6 height=1.9"),
    "boards": _own("width=3.1 depth=3.1 height=2.4", ROOM),
    "hinged": _own("width=3 depth=3 height=2.4", ROOM),
    "parallel": _own("width=4.8 depth=3.4 height=2.3", "depth=1.7 height=1.8"),
    "bend": _own("width=6.1 depth=5.2 height=2", "height=1.5"),
    "longitudinal": _own("width=5.5 depth=4.1 height=2.2", "depth=1.7 height=1.9"),
    "fitted": _own("width=4.3 depth=4.8 height=1.6", "height=0.7"),
    "swept": _own("width=4.3 depth=3 height=1.2", "width=1.7 height=0.66"),
    "tolerance": _own("width=4 depth=3 height=2.3", ROOM),
    "drawn": _own("width=5 depth=4 height=1.5", "depth=1.5 height=1.2"),
}
"""Sizes that the designs have by themselves, about."""


def read_obj(path: Path) -> list[Array]:
    """The faces of an OBJ file, each with its corners (K, 3), z up and the lowest of all at 0."""
    points, faces = [], []
    for line in path.read_text().splitlines():
        kind, *rest = line.split()
        if kind == "v":
            x, up, back = map(float, rest)
            points.append((x, -back, up))
        elif kind == "f":
            faces.append([int(each) - 1 for each in rest])
    places = np.array(points)
    places[:, 2] -= places[:, 2].min()
    return [places[face] for face in faces]


def outside(faces: list[Array]) -> tuple[float, float, float]:
    """The box around all faces."""
    x, y, z = np.ptp(np.concatenate(faces), axis=0).tolist()
    return x, y, z


def clipped(face: Array, axis: int, limit: float) -> list[Array]:
    """Corners of the part of a face up to a limit along an axis: side after side."""
    kept = []
    for here, there in zip(face, np.roll(face, -1, axis=0), strict=True):
        if here[axis] <= limit:
            kept.append(here)
        if (here[axis] - limit) * (there[axis] - limit) < 0:
            share = (limit - here[axis]) / (there[axis] - here[axis])
            kept.append(here + share * (there - here))
    return kept


def clear(faces: list[Array], axis: int, head: float) -> float:
    """How far one can go from the middle of the box both ways along an axis, below a height."""
    every = np.concatenate(faces)[:, axis]
    middle = 0.5 * (every.min() + every.max())
    low, high = -np.inf, np.inf
    for face in faces:
        part = clipped(face, 2, head)
        if part:
            along = [place[axis] for place in part]
            if min(along) <= middle <= max(along):
                return 0.0
            low = max(low, *(each for each in [max(along)] if each < middle), -np.inf)
            high = min(high, *(each for each in [min(along)] if each > middle), np.inf)
    return float(high - low)


def headroom(faces: list[Array]) -> float:
    """The lowest height over the middle line along x or y, the higher of both."""
    found = []
    for across in (0, 1):
        every = np.concatenate(faces)[:, across]
        middle = 0.5 * (every.min() + every.max())
        heights = [
            place[2]
            for face in faces
            if face[:, across].min() <= middle <= face[:, across].max()
            for place in clipped(face, across, middle)
            if abs(place[across] - middle) < 1e-9
        ]
        found.append(min(heights, default=0.0))
    return float(max(found))


def sizes(path: Path, of: str, head: float) -> dict[str, float]:
    """Sizes of a shell in an OBJ file."""
    faces = read_obj(path)
    if of == "outside":
        return dict(zip(("width", "depth", "height"), outside(faces), strict=True))
    return {
        "width": clear(faces, 0, head),
        "depth": clear(faces, 1, head),
        "height": headroom(faces),
    }
