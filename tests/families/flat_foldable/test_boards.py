"""Boards of 2 % of the median edge on fitted shells: apart from the flat sheet to the pack."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from fitted_shells import fitted
from orishell.design import Design, PanelSpec
from orishell.locking import find_lock
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.layout import Layout
from orishell.solids import largest_folds
from orishell.solids.setbacks import allowed_heights
from orishell.solids.sides import SideFolds
from overlaps import NOTHING, overlap
from samples import THOROUGH, led_by

STATES = 40 if THOROUGH else 16
THICKNESS = 0.02
"""Of the median edge."""
BEYOND = 1e-3
"""Where boards meet, they overlap so far beyond (radians)."""


def boards(design: Design, construction: str) -> PanelSpec:
    flat = design.mechanism.positions(0.0)
    edges = [np.linalg.norm(np.diff(flat, axis=axis), axis=-1).ravel() for axis in (0, 1)]
    thickness = THICKNESS * float(np.median(np.concatenate(edges)))
    if construction == "sandwich":
        return PanelSpec(thickness=thickness, membrane=0.05 * thickness)
    return PanelSpec(thickness=thickness, construction="bevel", gap=0.1 * thickness)


def thickest(design: Design, end: float) -> float:
    """The largest thickness with which boards have room up to a drive (radians)."""
    assert design.panel is not None
    layout = Layout.of(design.mechanism)
    sides = SideFolds.of(layout, largest_folds(design.mechanism, end))
    panels = panels_laid_flat(design.mechanism)
    return 2 * float(allowed_heights(panels, layout, sides, design.panel).min())


@pytest.mark.parametrize("count", led_by([5, 8, 16]))
@pytest.mark.parametrize("construction", ["sandwich", "bevel"])
@pytest.mark.parametrize("surface", led_by(["cap", "saddle .5"]))
def test_boards_are_apart_to_the_pack(surface: str, construction: str, count: int) -> None:
    """Seen of manifold3d: overlaps of 1e-16 at most, and of 1e-7 and more just beyond the pack."""
    bare = fitted(surface, count)
    design = replace(bare, panel=boards(bare, construction), opens_from_pack=True)
    lock = find_lock(design)
    assert lock.built is not None
    assert (lock.cause, lock.first_contact) == ("boards", None)
    mechanism, placed = design.mechanism, lock.built.boards
    assert mechanism.target_drive < lock.closes_to < np.pi
    # They close as far as set-backs of half a panel let them: thicker boards would have no room.
    assert design.panel is not None
    assert thickest(design, lock.closes_to) == pytest.approx(design.panel.thickness, rel=1e-9)
    for drive in np.linspace(0.0, lock.closes_to, STATES):
        assert overlap(mechanism, placed, drive) < NOTHING
    assert overlap(mechanism, placed, lock.closes_to + BEYOND) > NOTHING
