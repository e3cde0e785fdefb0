"""Distances between shells and surfaces: by hand, and against dense samples."""

import tracemalloc
from dataclasses import asdict
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from scipy.optimize import least_squares
from scipy.spatial import cKDTree

from orishell.curves import curve_from_points, trace_curve
from orishell.design import Design, Path, Surface, Turning
from orishell.deviation import (
    COARSE,
    SAMPLES,
    Deviation,
    Distances,
    find_excess,
    locked_shell,
    measure_approach,
    measure_deviation,
    measure_distance,
    measure_signed,
)
from orishell.deviation.report import ApproachReport, describe_deviation
from orishell.deviation.triangles import FINEST, mesh_surface
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalPattern,
    design_longitudinal_linear_repeating,
)
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from samples import examples, thorough
from strategies import (
    Request,
    graph,
    orthodiagonal_requests,
    pair,
    requests,
)


def strip(height: float = 0.0, slope: float = 0.0) -> Surface:
    """The rectangle with x from 0 to 3 and y from -1 to 1, at z = height - slope * y."""
    f = trace_curve(graph(f"{height} + {slope}*x", -1, 1))
    return Surface(f, np.zeros(2), Turning(Path.of(trace_curve(graph("0*x", 0, 3))), np.pi / 2))


def plate(x: float = 0.0, z: float = 0.0, slope: float = 0.0) -> np.ndarray:
    """Panels, 4 by 6, over the same rectangle, moved by x."""
    row, column = np.meshgrid(np.linspace(1, -1, 5), np.linspace(0, 3, 7), indexing="ij")
    return np.stack([column + x, row, z - slope * row], axis=-1)


def ways(deviation: Deviation) -> tuple[Distances, Distances]:
    return deviation.shell_to_surface, deviation.surface_to_shell


def test_a_plate_above_a_strip() -> None:
    deviation = measure_distance(plate(z=0.25), strip(), samples=2000)
    for way in ways(deviation):
        for value in (way.max, way.rms, way.mean, way.p95):
            assert value == pytest.approx(0.25, rel=1e-12)
        assert way.sample_spacing < 1e-12
        assert 0.01 < way.grid_spacing < 0.1


def test_a_plate_beside_a_strip() -> None:
    # A tenth of either has nothing of the other above it, and is 0.15 from it on average.
    deviation = measure_distance(plate(x=0.3), strip(), samples=20_000)
    for way in ways(deviation):
        assert way.max == pytest.approx(0.3, rel=1e-12)
        assert way.mean == pytest.approx(0.015, rel=1e-2)
        assert way.rms == pytest.approx(0.3 * np.sqrt(0.1 / 3), rel=1e-2)
        assert way.p95 == pytest.approx(0.15, abs=0.02)
        assert way.sample_spacing < 1e-9


def test_a_plate_across_a_strip() -> None:
    # Along its slope a plate is up to z = 0.1 off: from the plane it is that, and linear.
    deviation = measure_distance(plate(slope=0.1), strip(), samples=20_000)
    there = deviation.shell_to_surface
    assert there.max == pytest.approx(0.1, rel=1e-12)
    assert there.mean == pytest.approx(0.05, rel=1e-3)
    assert there.rms == pytest.approx(0.1 / np.sqrt(3), rel=1e-3)
    assert there.p95 == pytest.approx(0.095, rel=1e-2)


def test_exchange_exchanges_both_ways() -> None:
    first = measure_distance(plate(slope=0.4), strip(0.2, 0.1), samples=10_000)
    other = measure_distance(plate(z=0.2, slope=-0.1), strip(0, -0.4), samples=10_000)
    mirrored = measure_distance(plate(z=0.2, slope=0.1), strip(0, 0.4), samples=10_000)
    for deviation in (other, mirrored):
        for one, two in zip(ways(first), ways(deviation)[::-1], strict=True):
            assert one.max == pytest.approx(two.max, rel=2e-3)
            assert one.rms == pytest.approx(two.rms, rel=2e-3)
            assert one.mean == pytest.approx(two.mean, rel=2e-2)


def test_a_spike_between_the_samples_is_found_or_admitted() -> None:
    # A narrow pyramid of the surface between samples of few: the bound must not miss it.
    bump = curve_from_points(
        np.array([[-1, 0], [0.41, 0], [0.43, 0.3], [0.45, 0], [1, 0]], float), smooth=False
    )
    rail = Turning(Path.of(trace_curve(graph("0*x", 0, 3))), np.pi / 2)
    surface = Surface(trace_curve(bump), np.zeros(2), rail)
    for samples in (100, 1000):
        deviation = measure_distance(plate(), surface, samples=samples)
        assert deviation.max == pytest.approx(0.3, rel=1e-9)
    bent = plate()
    bent[2, 3, 2] = 0.2
    for samples in (100, 1000):
        assert measure_distance(bent, strip(), samples=samples).max == pytest.approx(0.2)


def test_signs() -> None:
    for height, sign in ((0.2, -1), (-0.2, 1)):
        signed = measure_signed(plate(), strip(height), 500, 70)
        np.testing.assert_allclose(signed.distances, -height, atol=1e-12)
        assert (np.sign(signed.distances) == sign).all()
        assert signed.strides == (1, 1)
        assert [int(each.sum()) for each in signed.creases] == [5, 7]
    coarse = measure_signed(plate(), strip(), 500, 4)
    assert coarse.strides == (1, 3)
    assert int(coarse.creases[1].sum()) == 5  # columns 0, 1, 4, 5, 6


def test_distances_from_a_torus() -> None:
    full = np.pi * (1 - 1e-12)
    tube, circle = pair("0.5*cos(t)", "0.5*sin(t)", -full, full), pair("3*cos(t)", "3*sin(t)", 0, 6)
    rail = Turning(Path.of(trace_curve(circle)), np.pi / 2)
    mesh, sagitta = mesh_surface(Surface(trace_curve(tube), np.zeros(2), rail), 20_000)
    assert 0 < sagitta < 1e-3
    rng = np.random.default_rng(1)
    angle, radius, height = rng.uniform((0.5, 2, -1), (5.5, 4, 1), (500, 3)).T
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), height], axis=-1)
    exact = 0.5 - np.hypot(radius - 3, height)  # f's left is inside the tube
    found = mesh.nearest(points)
    np.testing.assert_allclose(found.sides * found.distances, exact, atol=sagitta)


def test_distances_from_a_sweep_by_newton() -> None:
    surface = figure_1().surface
    assert isinstance(surface, Surface)
    mesh, sagitta = mesh_surface(surface, 20_000)
    shell = locked_shell(figure_1())
    points = shell[1:-1:3, ::3].reshape(-1, 3)
    low, high = surface.profile.t[[0, -1]]
    u, v = np.linspace(0, 1, 101), np.linspace(low, high, 81)
    lattice = surface.points(u[:, None], v[None, :])
    for point, distance in zip(points, mesh.nearest(points).distances, strict=True):

        def away(at: np.ndarray, point: np.ndarray = point) -> np.ndarray:
            return np.asarray(surface.points(at[0], at[1]) - point)

        near = np.linalg.norm(lattice - point, axis=-1)
        starts = [np.unravel_index(k, near.shape) for k in near.argsort(axis=None)[:4]]
        best = min(
            np.linalg.norm(
                least_squares(away, np.array([u[i], v[j]]), bounds=([0, low], [1, high])).fun
            )
            for i, j in starts
        )
        assert abs(best - distance) <= sagitta + 1e-9


def figure_1(**options: object) -> Design:
    arguments: dict[str, Any] = {
        "rows": 9,
        "columns": 11,
        "xi_deg": 50,
        "flap": 0.3,
        **options,
    }
    return design_parallel_repeating(
        graph("-x**2", -1, 1), graph("5*sin(pi*x/10)", 0, 20), ParallelRepeatingPattern(**arguments)
    )


def test_flaps_are_not_measured() -> None:
    with_flaps, without = figure_1(), figure_1(flap=0.0)
    assert locked_shell(with_flaps).shape == locked_shell(without).shape == (11, 11, 3)
    measured, same = (measure_deviation(each, samples=COARSE) for each in (with_flaps, without))
    assert asdict(measured) == asdict(same)
    longitudinal = design_longitudinal_linear_repeating(
        pair("cos(t)", "sin(t)", 0.3, 2.8),
        graph("0*x", 0, 3),
        LongitudinalPattern(rows=7, columns=9, sector_deg=[85, 80, 95, 100]),
    )
    assert locked_shell(longitudinal).shape == (9, 9, 3)


def test_more_samples_agree_and_know_better() -> None:
    design = figure_1()
    found = [measure_deviation(design, samples=samples) for samples in (3_000, 30_000)]
    coarse, fine = found
    assert abs(coarse.max - fine.max) <= coarse.sample_spacing + fine.sample_spacing
    assert coarse.sample_spacing < 0.15 * coarse.max
    assert fine.sample_spacing < 0.01 * fine.max
    assert coarse.rms == pytest.approx(fine.rms, rel=0.05)
    assert coarse.p95 == pytest.approx(fine.p95, rel=0.05)


def test_lengths_scale() -> None:
    def design(scale: float) -> Design:
        f, g = graph("-x**2", -1, 1).scaled(scale), graph("sin(x)", 0, 6).scaled(3 * scale)
        return design_parallel_repeating(
            f,
            g,
            ParallelRepeatingPattern(rows=5, columns=7, xi_deg=np.rad2deg(0.8), flap=0.1 * scale),
        )

    one, thousand = (measure_deviation(design(scale), samples=COARSE) for scale in (1, 1000))
    assert thousand.max == pytest.approx(1000 * one.max, rel=1e-6)
    assert thousand.rms == pytest.approx(1000 * one.rms, rel=1e-6)
    assert thousand.sample_spacing == pytest.approx(1000 * one.sample_spacing, rel=1e-3)


def test_a_target_that_is_met_exactly() -> None:
    # f is a staircase of the angle itself, g a polyline with a column on every corner.
    xi = np.deg2rad(50)
    edges = np.array([0.3, 0.35, 0.4, 0.3]) * np.exp(0.5j * (np.pi - xi) * np.array([1, -1, 1, -1]))
    corners = np.concatenate([[0], np.cumsum(edges)])
    f = curve_from_points(np.stack([corners.real, corners.imag], axis=-1), smooth=False)
    for points in ([[0, 0], [3, 0]], [[0, 0], [4, 1], [8, 0], [12, 3]]):
        g = curve_from_points(points, smooth=False)
        design = design_parallel_repeating(
            f,
            g,
            ParallelRepeatingPattern(
                rows=3, columns=4, xi_deg=np.rad2deg(xi * (1 - 1e-10)), flap=0
            ),
        )
        deviation = measure_deviation(design, samples=5_000)
        assert deviation.max < 1e-9


def test_what_is_approached_instead() -> None:
    assert figure_1().approached is None
    slanted = figure_1(plane_deg=80, columns=41)
    approach = measure_approach(slanted, samples=COARSE)
    assert approach is not None
    assert slanted.approached is not None
    assert "stretched along its plane" in slanted.approached.what
    assert approach.max < 0.8 * measure_deviation(slanted, samples=COARSE).max
    f = graph("-x**2", -1, 1)
    shifted = design_orthodiagonal(
        f, graph("0.25*sin(pi*x/2)", 0, 4), OrthodiagonalPattern(rows=9, columns=13)
    )
    assert shifted.approached is not None
    assert "waves by 0.5 and" in shifted.approached.what
    assert measure_approach(shifted, samples=COARSE) is not None
    straight = design_orthodiagonal(f, graph("0*x", 0, 4), OrthodiagonalPattern(rows=9, columns=13))
    assert straight.approached is None
    report = describe_deviation(shifted, measured=False)
    assert report is not None
    assert report.approached is not None
    meant = ApproachReport(shifted.approached.what, None, None)
    assert asdict(report.approached) == asdict(meant)


def divided(positions: np.ndarray, parts: tuple[int, int]) -> np.ndarray:
    """Points (A, B, 3) of panels given by their vertices, sides divided into so many parts."""

    def refined(values: np.ndarray, parts: int) -> np.ndarray:
        at = np.arange((len(values) - 1) * parts + 1) / parts
        low = np.minimum(at.astype(int), len(values) - 2)
        share = (at - low)[:, None, None]
        return np.asarray(values[low] * (1 - share) + values[low + 1] * share)

    down, right = parts
    return refined(refined(positions, down).swapaxes(0, 1), right).swapaxes(0, 1)


def covering(points: np.ndarray) -> float:
    """A length within which everything between samples (A, B, 3) has one of them."""
    down = np.linalg.norm(np.diff(points, axis=0), axis=-1).max()
    right = np.linalg.norm(np.diff(points, axis=1), axis=-1).max()
    return 0.5 * float(down + right)


def agrees_with_dense_samples(design: Design) -> None:
    shell, surface = locked_shell(design), design.surface
    deviation, finer = (measure_deviation(design, samples=samples) for samples in (2_000, 15_000))
    for one, other in zip(ways(deviation), ways(finer), strict=True):
        assert abs(one.max - other.max) <= one.sample_spacing + other.sample_spacing
    assert isinstance(surface, Surface)
    first, last = surface.profile.t[[0, -1]]
    u, v = np.linspace(0, surface.rail.stop, 80), np.linspace(first, last, 80)
    u = np.union1d(u, np.arange(surface.rail.stop))
    v = np.union1d(v, surface.profile.t[surface.profile.corners])
    of_surface = surface.points(u[:, None], v[None, :])
    rows, columns = shell.shape[:2]
    of_shell = divided(shell, (max(80 // rows, 4), max(80 // columns, 4)))
    spacings = covering(of_shell), covering(of_surface)
    flat = of_shell.reshape(-1, 3), of_surface.reshape(-1, 3)
    for way, start in zip(ways(deviation), (0, 1), strict=True):
        apart = np.asarray(cKDTree(flat[1 - start]).query(flat[start], workers=-1)[0])
        largest = float(apart.max())
        # Samples are no nearer than what they are of, and so much farther at most.
        assert largest - spacings[1 - start] <= way.max + way.sample_spacing
        assert largest + spacings[start] >= way.max - way.sample_spacing
        assert 0 <= way.mean <= way.rms <= way.max + 1e-12
        assert way.p95 <= way.max + 1e-12
    assert deviation.max == max(way.max for way in ways(deviation))


@pytest.mark.slow
@settings(max_examples=examples(25), deadline=None)
@given(requests())
def test_random_designs_against_dense_samples(request: Request) -> None:
    agrees_with_dense_samples(request.feasible())


@thorough
@pytest.mark.slow
@settings(max_examples=examples(25), deadline=None)
@given(orthodiagonal_requests())
def test_random_orthodiagonal_designs_against_dense_samples(
    request: Request,
) -> None:
    agrees_with_dense_samples(request.feasible())


def test_a_mesh_of_a_flat_surface_ends_short_of_a_curved_border() -> None:
    """A level line swept along a parabola: all that triangles lack is at the border."""
    f, g = graph("0*x + 0.2", -0.4, 0.4), graph("0.5*x**2", -1, 2)
    rail = Turning(Path.of(trace_curve(g)), np.pi / 2)
    surface = Surface(trace_curve(f), np.zeros(2), rail)
    for samples in (200, 2_000):
        mesh, short = mesh_surface(surface, samples)
        u = np.linspace(0, surface.rail.stop, 4_001)
        border = surface.points(u[:, None], surface.profile.t[None, [0, -1]]).reshape(-1, 3)
        assert np.ptp(border[:, 2]) < 1e-12
        away = float(mesh.nearest(border).distances.max())
        assert 1e-6 < away <= short * (1 + 1e-6)


def test_whether_a_limit_is_exceeded() -> None:
    """Below it by more than the sagitta of the quick mesh, 1.2 % of the distance; never above."""
    design = figure_1()
    deviation = measure_deviation(design)
    for share in (0.5, 0.9, 0.98, 1.0, 1.01, 1.1, 2.0):
        limit = share * deviation.max
        found = find_excess(design, limit, samples=1_000)
        assert (found > limit) == (share < 1), share
        assert found <= deviation.max + deviation.sample_spacing


def test_figure_1_is_known_to_a_thousandth_of_its_diagonal() -> None:
    design = figure_1()
    shell = locked_shell(design)
    diagonal = float(np.linalg.norm(np.ptp(shell.reshape(-1, 3), axis=0)))
    deviation, finer = measure_deviation(design), measure_deviation(design, samples=60_000)
    assert deviation.sample_spacing < 1e-4 * diagonal
    for name in ("max", "rms", "mean", "p95"):
        assert abs(getattr(deviation, name) - getattr(finer, name)) < 1e-4 * diagonal


@thorough
def test_a_small_sheet_over_wild_curves_takes_little_memory() -> None:
    # 2,200 bends of f and g: meshes of a million cells and 390,000 samples took 600 MB.
    design = design_parallel_repeating(
        graph("-x**2/4 + 0.0002*sin(1000*x)", -1, 1),
        graph("0.001*sin(300*x)", 0, 20),
        ParallelRepeatingPattern(rows=3, columns=6, xi_deg=np.rad2deg(0.5), flap=0),
    )
    tracemalloc.start()
    try:
        deviation = measure_deviation(design)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 150e6
    mesh, sagitta = mesh_surface(design.surface, SAMPLES)
    assert len(mesh.corners) <= 2 * FINEST
    # What the bends left out may hide is admitted.
    assert deviation.sample_spacing > sagitta > 0.002
