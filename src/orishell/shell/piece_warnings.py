"""Warnings about the joints between pieces of whole boards."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.row import Note
from orishell.design import Design
from orishell.locking import Lock
from orishell.motion.quads import lengths
from orishell.solids.hinged.joints import joint_openings

OPEN = 1e-6
"""Boards that are farther apart at a joint than their gap and this share of the thickness stay so:
no cut brings them together."""
DEEP = 0.1
"""Boards cut back by this share of the way across their panels leave a strip that one sees."""


def warn_of_joints(design: Design, lock: Lock, unit: str) -> Iterator[str]:
    """Joints that stay open at the target, or for which much of a board is cut away."""
    built = lock.built
    if built is None or not design.in_pieces:
        return
    mechanism, build = design.mechanism, built.build
    apart = float(joint_openings(mechanism, built.boards).max())
    if apart > build.gap + OPEN * build.thickness:
        yield Note(
            f"boards of two pieces stay up to {plain(apart, 3)} {unit} apart where they are "
            "joined: cover their joints, or make pieces of more rows (pieces in [panel])",
            "open joints",
        )
    cut = float(np.max(design.hinges.cut_back))
    across = float(np.median(lengths(np.diff(mechanism.positions(0.0), axis=0))))
    if cut > DEEP * across:
        yield Note(
            f"boards are cut back by up to {plain(cut, 3)} {unit} along joints, "
            f"{plain(100 * cut / across, 2)} % of the way across a panel: pieces of fewer rows, or "
            "thinner boards, need less",
            "cut joints",
        )
