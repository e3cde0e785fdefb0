"""Plates in box girders: where they are, what they hold, and that they meet nothing at the target.

Limit: as gussets, plates of box girders are examined at the target only. The lower line of a box is
joined once its plates are in.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.clash.bodies import Bodies
from orishell.clash.separation import corners_of, overlaps
from orishell.clash.state import deepest_between, near_panels
from orishell.conventions.errors import DesignError, Remedy
from orishell.design import Design
from orishell.design.stiffeners import Stiffeners
from orishell.locking.fold_rows import fold_columns
from orishell.locking.plates import require_folds, with_plates
from orishell.locking.result import Lock
from orishell.motion import diagonal
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import join_boards
from orishell.motion.complex import Complex
from orishell.motion.layout import Layout, points_of
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_largest
from orishell.solids.box_plates import BoxPlates, box_plate_parts
from orishell.solids.carried import moving_boards


def with_box_plates(
    design: Design, lock: Lock, asked: Stiffeners | None, tolerance: float
) -> Design:
    """The design with plates across its box girders, proved to meet nothing at the target.

    lock: How its motion ends, with its boards.
    tolerance: By how much they may reach into others, relative to the flat sheet's diagonal.

    Raises InputError if there are no such columns.
    Raises DesignError if there is no room for them.
    """
    if not design.boxes or asked is None or asked.columns == "none":
        return design
    span = design.boxes[0].sleeve.columns
    columns = np.array(fold_columns(asked.columns, range(span.start, span.stop), "plate"))
    at = np.array([(box.sleeve.row, column) for box in design.boxes for column in columns.tolist()])
    require_folds(design, at, "plate")
    every = [BoxPlates.of(design, box, columns) for box in design.boxes]
    levels = 0 if lock.built is None else lock.built.boards.outlines.shape[1]
    met = _met(design, lock, every, levels, tolerance * diagonal(design.mechanism.positions(0.0)))
    if met is not None:
        first, second, depth = met
        raise DesignError(
            f"{first} and {second} meet",
            place="at the target",
            keys=("stiffeners.columns", "panel.thickness"),
            size=f"one reaches {depth:.4g} into the other",
            candidates=[Remedy({"stiffeners.columns": "none"})],
            excess=1.0,
        )
    parts = [part for plates in every for part in box_plate_parts(design, plates, levels)]
    return with_plates(design, at, parts)


def _met(
    design: Design, lock: Lock, every: list[BoxPlates], levels: int, tolerance: float
) -> tuple[str, str, float] | None:
    """What a plate reaches deepest into at the target, and how far; None if nothing."""
    whole, target = design.moving, design.mechanism.target_drive
    assert isinstance(whole, Complex)
    layout = Layout.of(whole)
    grid = whole.grid.panel_count
    names = [f"panel {list(each)}" for each in layout.names[:grid].tolist()]
    names += [each for box in design.boxes for each in box.names]
    count = len(names)
    names += [each for plates in every for each in plates.names]
    corners = np.concatenate([plates.corners for plates in every])
    points = points_of(whole, target)
    own: Integers = len(points) + np.arange(4 * len(corners)).reshape(-1, 4)
    faces = np.concatenate([layout.faces, own])
    places = np.concatenate([points, corners.reshape(-1, 3)])
    if lock.built is None:
        return _panels_met(whole, faces, places, names, tolerance)
    lying = np.concatenate([panels_laid_flat(whole), *(plates.lying() for plates in every)])
    boards = [moving_boards(lock.built.boards, whole, design.carried)]
    behind = count
    for plates in every:
        made = plates.boards(np.zeros((len(plates), 2)), levels)
        boards.append(replace(made, panels=made.panels + behind))
        behind += len(plates)
    bodies = Bodies(join_boards(boards), faces, lying)
    groups = np.maximum(bodies.panels - count + 1, 0)
    met = deepest_between(bodies, places, tolerance, groups)
    if met is None or met[1] <= tolerance:
        return None
    first, second = bodies.carriers(met[0])
    return names[first], names[second], met[1]


def _panels_met(
    whole: Complex, faces: Integers, places: Array, names: list[str], tolerance: float
) -> tuple[str, str, float] | None:
    """Likewise of panels without a thickness: a plate shares its corners with those around it."""
    count = len(whole.layout.faces)
    first, second = near_panels(places, faces, tolerance)
    chosen = second >= count
    first, second = first[chosen], second[chosen]
    corners = corners_of(places, faces[first]), corners_of(places, faces[second])
    # Those around a plate have corners, or points of their sides, where it has its own.
    loops = whole.layout.loops
    padded = np.where(loops < 0, loops[:, :1], loops)
    sheet = first < count
    shared = np.zeros(len(first), np.bool_)
    around = places[padded[first[sheet]]][:, :, None] - places[faces[second[sheet]]][:, None]
    shared[sheet] = (np.linalg.norm(around, axis=-1) <= tolerance).any(axis=(1, 2))
    depths = np.where(shared, 0.0, overlaps(*corners))
    if not len(depths) or depths.max() <= tolerance:
        return None
    worst = first_largest(depths)
    return names[int(first[worst])], names[int(second[worst])], float(depths[worst])
