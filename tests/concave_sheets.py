"""Random sheets whose border panels are concave or not, and an intersection of the tests' own."""

from __future__ import annotations

import numpy as np
import shapely

from mechanisms import flat_foldable, random_net
from orishell.families.drawn import DrawnSheet
from orishell.families.drawn.sheet import drawn_sheet
from orishell.motion import find_assignment
from orishell.motion.layout import Layout

Array = np.ndarray
INSIDE = 1e-6
"""A side that goes through a panel does so so far from both their borders, of their sizes."""


def random_sheet(seed: int) -> tuple[DrawnSheet, int]:
    """A sheet that folds, and how many panels are concave: some are, but for each fourth seed.

    Creases that end at the border keep their directions and get other lengths, so that no sector of
    an inner vertex changes. Corners reach out beside the border, past the vertex next to them.
    Panels neither cross themselves nor each other.
    """
    rng = np.random.default_rng(seed)
    rows, columns = rng.integers(2, 5, 2)
    sheet = flat_foldable(random_net(int(rows), int(columns), seed))
    flat, signs = sheet.positions(0.0)[..., :2], find_assignment(sheet)
    faces = Layout.of(sheet).faces
    while True:
        moved = flat.copy()
        for border, inner in (
            (np.s_[0, 1:-1], np.s_[1, 1:-1]),
            (np.s_[-1, 1:-1], np.s_[-2, 1:-1]),
            (np.s_[1:-1, 0], np.s_[1:-1, 1]),
            (np.s_[1:-1, -1], np.s_[1:-1, -2]),
        ):
            way = flat[border] - flat[inner]
            share = rng.uniform(0.1, 0.6) * rng.uniform(0.7, 1.3, (len(way), 1))
            moved[border] = flat[inner] + share * way
        for turned in (moved, moved[::-1], moved[:, ::-1], moved[::-1, ::-1]):
            line = turned[0] if rng.random() < 0.5 else turned[:, 0]
            if seed % 4 == 0 or rng.random() < 0.5:
                continue
            # The corner goes along the side of the next panel, beside it.
            beside = line[1] - (turned[1, 1] - line[1]) * rng.uniform(0.1, 3.0)
            line[0] = beside + rng.uniform(0.2, 1.2) * (line[2] - line[1])
        panels = shapely.polygons(moved.reshape(-1, 2)[faces])
        if not shapely.is_valid(panels).all() or (shapely.area(panels) < 1e-3).any():
            continue
        whole = float(shapely.area(shapely.union_all(panels)))
        if abs(whole - float(shapely.area(panels).sum())) < 1e-9 * whole:
            hulls = shapely.area(shapely.convex_hull(panels))
            concave = int((hulls > shapely.area(panels) * (1 + 1e-9)).sum())
            if concave or seed % 4 == 0:
                return drawn_sheet(moved, signs, np.pi), concave


def triangles(flat: Array, faces: Array) -> Array:
    """Corners (2 F, 3) of two triangles of each panel, parted inside it."""
    corners = flat[faces][..., :2]
    first = shapely.linestrings(corners[:, [0, 2]])
    inside = shapely.covers(shapely.buffer(shapely.polygons(corners), 1e-9), first)
    turned = np.where(inside[:, None], faces, np.roll(faces, -1, axis=1))
    return np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]])


def panels_through(points: Array, flat: Array, faces: Array) -> Array:
    """Pairs (P, 2) of panels, a side of one of which goes through the inside of the other.

    Moller and Trumbore's test of a line and a triangle (Journal of Graphics Tools 2 (1997) 21).
    """
    sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    parts = triangles(flat, faces)
    begin, end = points[sides].swapaxes(0, 1)[:, :, None]
    a, b, c = points[parts].swapaxes(0, 1)[:, None]
    way, u, v = end - begin, b - a, c - a
    across = np.cross(way, v)
    area = (across * u).sum(axis=-1)
    size = np.linalg.norm(way, axis=-1) * np.linalg.norm(np.cross(u, v), axis=-1)
    steep = np.abs(area) > INSIDE * size
    area = np.where(steep, area, 1.0)
    start = begin - a
    turned = np.cross(start, u)
    one, other = (across * start).sum(axis=-1) / area, (way * turned).sum(axis=-1) / area
    along = (v * turned).sum(axis=-1) / area
    # Parts of a panel meet inside it: there the diagonal is no border, and points on it count.
    within = (one > INSIDE) & (other > INSIDE) & (one + other < 1 - INSIDE)
    within &= (along > INSIDE) & (along < 1 - INSIDE)
    of_side, of_part = np.repeat(np.arange(len(faces)), 4), np.tile(np.arange(len(faces)), 2)
    found = np.argwhere(steep & within)
    pairs = np.stack([of_side[found[:, 0]], of_part[found[:, 1]]], axis=-1)
    return np.unique(np.sort(pairs[pairs[:, 0] != pairs[:, 1]], axis=1), axis=0)
