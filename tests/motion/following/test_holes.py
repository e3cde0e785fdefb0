"""Closure round holes and cuts: pop-ups against plane linkages, derivatives by differences."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.following import follow
from orishell.motion.following.dofs import find_freedom
from orishell.motion.following.system import Closure
from orishell.numerics.arrays import Array
from patterns import SAMPLES, miura, of_points
from samples import examples

WIDTH, LEFT, RIGHT = 120.0, 40.0, 80.0


def pop_up(low: float, ridge: float, high: float, gutter: float = 60.0) -> CreasePattern:
    """A card folded at a gutter, with a strip cut free of it between two slits.

    The strip is a valley at its ends, where it leaves the card, and a mountain between them.
    """
    # The card goes round the slits: corners at their ends, and where the gutter meets them.
    below = [(0.0, 0.0), (WIDTH, 0.0), (WIDTH, gutter), (RIGHT, gutter), (RIGHT, low)]
    below += [(LEFT, low), (LEFT, gutter), (0.0, gutter)]
    above = [(0.0, gutter), (LEFT, gutter), (LEFT, high), (RIGHT, high), (RIGHT, gutter)]
    above += [(WIDTH, gutter), (WIDTH, 120.0), (0.0, 120.0)]
    strip = [
        [(LEFT, bottom), (RIGHT, bottom), (RIGHT, top), (LEFT, top)]
        for bottom, top in ((low, ridge), (ridge, high))
    ]
    return of_points([below, above, *strip], lambda a, b: "M" if a[1] == b[1] == ridge else "V")


def heights(pattern: CreasePattern) -> Array:
    """The y at which each crease lies (E,)."""
    return np.asarray(pattern.vertices[pattern.edges].mean(axis=1)[:, 1])


@pytest.mark.parametrize("seed", range(examples(16)))
def test_a_pop_up_is_a_plane_linkage(seed: int) -> None:
    """Seen along the gutter the card and the strip are four bars, which close in every state.

    From the card's lower half: bars of the card to the gutter and beyond it, then back along the
    strip. The fold angles that were found turn one into the next.
    """
    rng = np.random.default_rng(seed)
    low, high = 60 - rng.uniform(10, 40), 60 + rng.uniform(10, 40)
    ridge = rng.uniform(low + 5, high - 5)
    if seed == 0:  # a parallelogram: all creases have the gutter's fold angle
        low, high, ridge = 40.0, 90.0, 70.0
    pattern = pop_up(low, ridge, high)
    found = follow(pattern, largest=2.5, states=7)
    at = heights(pattern)
    folds = {
        y: found.folds[:, pattern.crease & (np.abs(at - y) < 1e-9)]
        for y in (60.0, low, ridge, high)
    }
    for each in folds.values():  # both parts of the gutter turn alike
        assert np.ptp(each, axis=1).max(initial=0.0) < 1e-9
    gutter, one, two, three = (folds[y][:, 0] for y in (60.0, low, ridge, high))
    way = {
        "card": (60 - low) + (high - 60) * np.exp(1j * gutter),
        "strip": (ridge - low) * np.exp(1j * one) + (high - ridge) * np.exp(1j * (one + two)),
    }
    np.testing.assert_allclose(way["card"], way["strip"], atol=1e-9)
    np.testing.assert_allclose(one + two + three, gutter, atol=1e-11)
    assert (gutter[1:] > 0).all()
    assert (two[1:] < 0).all()
    assert found.placed(6)[1] < 1e-10 * pattern.diagonal
    if seed == 0:
        alike = np.abs(found.folds[:, pattern.crease])
        np.testing.assert_allclose(alike, np.tile(found.drives[:, None], 5), atol=1e-9)
    assert found.degrees_of_freedom == 1  # four bars


def test_two_slits_are_two_holes_and_a_whole_sheet_has_none() -> None:
    assert len(Closure.of(pop_up(40, 70, 90)).holes) == 2
    assert len(Closure.of(SAMPLES["Miura with a hole"].make()).holes) == 1
    assert len(Closure.of(miura()).holes) == 0


def test_derivatives_are_those_of_what_is_left() -> None:
    """By central differences, in a closed state; truncation and rounding leave 1e-9."""
    pattern = SAMPLES["Miura with a hole"].make()
    closure = Closure.of(pattern)
    folds = follow(pattern, largest=1.2, states=2).folds[-1][closure.edges]
    exact = closure.matrix(closure.residuals(folds)[1]).toarray()
    step = 1e-5
    moved = (
        closure.residuals(folds + sign * step * each)[0].ravel()
        for each in np.eye(len(folds))
        for sign in (1, -1)
    )
    plus_minus = np.array(list(moved)).reshape(len(folds), 2, -1)
    differences = (plus_minus[:, 0] - plus_minus[:, 1]).T / (2 * step)
    np.testing.assert_allclose(exact, differences, atol=1e-8)


def test_a_cut_that_reaches_the_border_closes_nothing() -> None:
    """A column crease cut from the border inwards: one border, but one vertex less to close."""
    pattern = miura(3, 3)
    closure = Closure.of(pattern)
    inner = set(pattern.inner.tolist())
    to_border = np.array(
        [
            pattern.crease[k] and len(inner & set(e)) == 1
            for k, e in enumerate(pattern.edges.tolist())
        ]
    )
    cut = pattern.letters.copy()
    cut[int(to_border.argmax())] = "C"
    parted = Closure.of(replace(pattern, letters=cut))
    assert len(parted.holes) == 0
    assert len(parted.vertices) == len(closure.vertices) - 1


def test_triangles_round_a_hole_have_six_freedoms_less() -> None:
    """Taking a triangle from a sheet of triangles takes three creases and gives a border of three.

    Its three vertices lose their equations, nine in all, and the hole has six: of E creases and I
    inner vertices E - 3 I freedoms are left before, and E - 3 - 3 (I - 3) - 6 after: as many.
    """
    whole = SAMPLES["Yoshimura"].make()
    inside = np.isin(whole.faces, whole.inner).all(axis=1).argmax()
    holed = pattern_of_panels(whole.vertices, np.delete(whole.faces, inside, axis=0))
    counts = []
    for pattern in (replace(whole, letters=np.where(whole.letters == "B", "B", "U")), holed):
        closure = Closure.of(pattern)
        folds = follow(pattern, largest=0.6, states=2).folds[-1][closure.edges]
        counts.append(find_freedom(closure, folds).count)
    assert counts[0] == counts[1]
