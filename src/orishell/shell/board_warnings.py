"""Warnings about boards: chamfers that are hard to cut, whole boards far from where they belong."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.row import Note
from orishell.design import Design
from orishell.locking import Lock
from orishell.motion import diagonal
from orishell.motion.hinges import Hinges
from orishell.motion.quads import lengths
from orishell.solids.hinged import board_offsets
from orishell.workshop.boards import chamfer_angles

BESIDE_TARGET = 0.01
"""Whole boards this share of the diagonal from where they should be are seen to be elsewhere."""
LONG_ARM = 0.5
"""Arms this share of an edge long catch on whatever stands beside the shell, and bend."""
SAW, TRACK_SAW = 45, 48
"""Table saws tilt their blades from 0 to 45 degrees (manuals of Ryobi RTS08, DeWalt DWE7470 and
others), the farthest of three track saws to 48 (Popular Woodworking 175, April 2009, page 43); a
V-bit with an edge of 90 degrees leans by 45 (degrees)."""


def warn_of_boards(design: Design, lock: Lock, unit: str) -> list[str]:
    """Warnings of chamfers, and of whole boards on hinges."""
    return [*_of_chamfers(lock), *_of_whole_boards(design, unit)]


def _of_whole_boards(design: Design, unit: str) -> Iterator[str]:
    """Boards far from where they should be, masses that leave out parts, and long arms."""
    if not isinstance(design.hinges, Hinges):
        return
    mechanism = design.mechanism
    if design.meant is not None:
        shell = mechanism.positions(mechanism.target_drive)
        off = float(board_offsets(design.hinges, shell, design.meant).max())
        if off > BESIDE_TARGET * diagonal(design.meant):
            yield Note(
                f"boards on their hinges lie up to {plain(off, 3)} {unit} from the panels that "
                "would meet the target: thinner boards, fewer rows or straight columns bring them "
                "nearer",
                "off",
            )
    if design.panel is not None and design.panel.weighs_boards_alone:
        yield (
            "masses leave out arms or hinges: say what these weigh (arm_density and "
            "hinge.linear_density in [panel])"
        )
    flat = mechanism.positions(0.0)
    edges = np.concatenate([lengths(np.diff(flat, axis=axis)).ravel() for axis in (0, 1)])
    if design.hinges.longest_arm > LONG_ARM * np.median(edges):
        yield Note(
            f"hinges stand up to {plain(design.hinges.longest_arm, 3)} {unit} off their boards, "
            f"and edges of panels are {plain(float(np.median(edges)), 3)} {unit} long: fewer rows "
            "or straight columns need shorter arms, and a limit refuses longer ones (largest_arm "
            "in [panel])",
            "arms",
        )


def _of_chamfers(lock: Lock) -> Iterator[str]:
    """Chamfers of solid panels that ordinary machines do not make."""
    built = lock.built
    if built is None:
        return
    each = (boards for boards in (built.boards, built.flaps) if boards is not None)
    angles = np.concatenate([chamfer_angles(boards) for boards in each])
    steep = int((angles > SAW).sum())
    if steep:
        yield Note(
            f"{steep} of {len(angles)} chamfers lean by more than {SAW} degrees from a square "
            f"cut, up to {angles.max():.3g}: table saws tilt no further (track saws to "
            f"{TRACK_SAW}), nor does a V-bit of {2 * SAW} degrees; mill them on five axes or print "
            'the panels, or make boards that are cut square (construction = "sandwich")',
            "chamfers",
        )
