"""Traces of very many samples, thinned."""

import numpy as np

from orishell.curves import curve_from_points, trace_curve
from orishell.polylines import measure_closeness, place_chords
from orishell.polylines.closeness import MOST_SAMPLES, thinned
from strategies import graph


def test_ordinary_traces_stay_as_they_are() -> None:
    trace = trace_curve(graph("sin(3*x)", 0, 6))
    assert thinned(trace) is trace


def test_ends_and_corners_are_kept() -> None:
    wavy = trace_curve(graph("0.2*sin(200*x)", 0, 4))
    assert len(wavy.t) > 2 * MOST_SAMPLES
    assert MOST_SAMPLES <= len(thinned(wavy).t) < 2 * MOST_SAMPLES
    np.testing.assert_array_equal(thinned(wavy).points[[0, -1]], wavy.points[[0, -1]])
    points = np.stack([np.arange(60_000.0), np.arange(60_000) % 2 * 0.3], axis=-1)
    corners = trace_curve(curve_from_points(points, smooth=False))
    assert len(thinned(corners).corners) == len(corners.corners)


def test_polylines_of_wild_curves_are_as_close_as_measured() -> None:
    trace = trace_curve(graph("0.2*sin(200*x)", 0, 4))
    chords = place_chords(trace, 9)
    found = measure_closeness(trace, chords.vertices).max
    # By all samples: the first and the last chord are nearly along the axis, the crests 0.2 off it.
    part = np.linspace(0, 1, 500)[:, None, None]
    along = (chords.vertices[:-1] * (1 - part) + chords.vertices[1:] * part).reshape(-1, 2)
    from scipy.spatial import cKDTree

    brute = np.max(cKDTree(along).query(trace.points)[0])
    assert abs(found - brute) < 2e-3
