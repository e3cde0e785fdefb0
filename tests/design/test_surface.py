"""The swept surface: where its points lie, its normals, its area and its meshes."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings

from orishell.curves import Curve, curve_from_points, trace_curve
from orishell.design import Design, Path, Sliding, Surface, Turning
from orishell.deviation.triangles import Triangles
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalPattern,
    design_longitudinal_linear_repeating,
)
from samples import examples
from strategies import (
    Request,
    graph,
    orthodiagonal_requests,
    pair,
    requests,
)

RIGHT = np.pi / 2


def turning(f: Curve, g: Curve, plane: float = RIGHT, *, affine: bool = False) -> Surface:
    return Surface(trace_curve(f), np.zeros(2), Turning(Path.of(trace_curve(g)), plane, affine))


def torus(tube: float, radius: float) -> Surface:
    full = np.pi * (1 - 1e-12)
    f = pair(f"{tube}*cos(t)", f"{tube}*sin(t)", -full, full)
    g = pair(f"{radius}*cos(t)", f"{radius}*sin(t)", 0, 2 * full)
    return turning(f, g)


def samples(surface: Surface, seed: int = 0, count: int = 400) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    low, high = surface.profile.t[[0, -1]]
    return rng.uniform(0, surface.rail.stop, count), rng.uniform(low, high, count)


def test_a_circle_along_a_circle_is_a_torus() -> None:
    surface = torus(0.5, 3.0)
    points = surface.points(*samples(surface))
    from_axis = np.hypot(points[:, 0], points[:, 1])
    np.testing.assert_allclose(np.hypot(from_axis - 3, points[:, 2]), 0.5, rtol=1e-12)
    normals = surface.normals(*samples(surface))
    centre = 3 * points[:, :2] / from_axis[:, None]
    outwards = (points - np.concatenate([centre, np.zeros((400, 1))], axis=1)) / 0.5
    # f is drawn counter-clockwise: its left is inside.
    np.testing.assert_allclose(normals, -outwards, atol=1e-9)


def test_area_of_the_torus_at_order_2() -> None:
    surface, area = torus(0.5, 3.0), 4 * np.pi**2 * 0.5 * 3.0
    errors = [area - surface.area(step) for step in (0.2, 0.1, 0.05, 0.025)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 2, atol=0.1)


def test_normals_point_to_the_left_of_f_and_agree_with_differences() -> None:
    for surface in (
        turning(graph("-x**2", -1, 1), graph("sin(x)", 0, 6)),
        turning(graph("-x**2", -1, 1), graph("sin(x)/3", 0, 6), 1.2),
        turning(graph("-x**2", -1, 1), graph("sin(x)/3", 0, 6), 1.2, affine=True),
    ):
        u, v = samples(surface)
        normals, step = surface.normals(u, v), 1e-6
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, rtol=1e-12)
        along = surface.points(u + step, v) - surface.points(u - step, v)
        across = surface.points(u, v + step) - surface.points(u, v - step)
        different = np.cross(across, along)
        different /= np.linalg.norm(different, axis=1, keepdims=True)
        np.testing.assert_allclose(normals, different, atol=1e-6)
        assert (normals[:, 2] > 0).all()


@pytest.mark.parametrize("plane_deg", [50, 90, 130])
def test_points_of_a_rigid_sweep(plane_deg: float) -> None:
    plane = np.deg2rad(plane_deg)
    surface = turning(graph("-x**2", -1, 1), pair("3*cos(t)", "3*sin(t)", 0, 2), plane)
    u, v = samples(surface)
    angle = 2 * u  # a circle's arc is in proportion to its parameter
    tangent = angle + np.pi / 2
    x = 3 * np.cos(angle) + v * np.cos(tangent - plane)
    y = 3 * np.sin(angle) + v * np.sin(tangent - plane)
    expected = np.stack([x, y, -(v**2)], axis=-1)
    np.testing.assert_allclose(surface.points(u, v), expected, atol=1e-12)


@pytest.mark.parametrize("plane_deg", [50, 130])
def test_points_of_an_affine_sweep(plane_deg: float) -> None:
    plane = np.deg2rad(plane_deg)
    g = graph("sin(x)/2", 0, 5)
    surface = turning(graph("-x**2", -1, 1), g, plane, affine=True)
    u, v = samples(surface)
    x, z = np.zeros_like(v), np.zeros_like(v)
    points, along, axis = surface.rail.carry(u, v)
    middle, tangent, _ = surface.rail.carry(u, x)
    # f is stretched along its plane, by lambda' / lambda = cot(plane) times the turning.
    turn = np.arctan2(tangent[:, 1], tangent[:, 0]) - np.arctan(0.5)
    stretch = np.exp(turn / np.tan(plane))
    np.testing.assert_allclose(np.linalg.norm(axis, axis=1), stretch, rtol=1e-9)
    np.testing.assert_allclose(points - middle, v[:, None] * axis, atol=1e-12)
    # All points of f are carried parallel to g.
    np.testing.assert_allclose(np.cross(along, tangent)[:, 2], z, atol=1e-12)
    assert isinstance(surface.rail, Turning)
    low, high = surface.rail.scale_range()
    assert low == pytest.approx(stretch.min(), rel=1e-3)
    assert high == pytest.approx(stretch.max(), rel=1e-3)


def test_a_corner_of_g_is_a_mitre() -> None:
    flat = graph("0*x", -1, 1)
    corner = curve_from_points(np.array([[0, 0], [3, 0], [3, 3]], float), smooth=False)
    surface = turning(flat, corner)
    assert surface.area(0.3) == pytest.approx(12, rel=1e-12)
    np.testing.assert_allclose(surface.points(np.ones(3), np.array([-1.0, 0, 1])),
                               [[2, 1, 0], [3, 0, 0], [4, -1, 0]], atol=1e-12)  # fmt: skip
    slanted = turning(flat, corner, np.deg2rad(70), affine=True)
    assert isinstance(slanted.rail, Turning)
    ends = slanted.rail.scales()
    jump = np.sin(np.deg2rad(70 + 45)) / np.sin(np.deg2rad(70 - 45))
    np.testing.assert_allclose(ends, [[1, 1], [jump, jump]], rtol=1e-12)


@pytest.mark.parametrize("plane_deg", [70, 90])
@pytest.mark.parametrize("affine", [False, True])
def test_curved_pieces_meet_at_corners(plane_deg: float, *, affine: bool) -> None:
    # A corner with curved pieces on both sides, the inner parts of which are cut off.
    g = graph("abs(x - 0.3) + 0.15*x**2 + 0.02*x**3", -3, 3)
    surface = turning(graph("-x**2", -1, 1), g, np.deg2rad(plane_deg), affine=affine)
    v = np.linspace(-1, 1, 41)
    for corner in range(1, int(surface.rail.stop)):
        before = surface.points(np.full(41, corner - 1e-9), v)
        np.testing.assert_allclose(before, surface.points(np.full(41, corner), v), atol=1e-7)
        after = surface.points(np.full(41, corner + 1e-9), v)
        np.testing.assert_allclose(after, surface.points(np.full(41, corner), v), atol=1e-7)


def test_a_tilted_slide_is_a_sum_of_curves() -> None:
    f, g = trace_curve(graph("-x**2", -1, 1)), trace_curve(graph("sin(x)", 0, 6))
    surface = Surface(f, np.array([0.2, -0.1]), Sliding(Path.of(g), complex(np.exp(-2j)), 0.3))
    u, v = samples(surface)
    start = np.zeros(1)
    ends = np.full(1, 0.5)
    whole = surface.points(u, v)
    parts = surface.points(u, ends) + surface.points(start, v) - surface.points(start, ends)
    np.testing.assert_allclose(whole, parts, atol=1e-12)
    # g keeps its length, f is upright.
    g_points = surface.rail.carry(np.linspace(0, 1, 2001), np.zeros(()))[0]
    length = np.linalg.norm(np.diff(g_points, axis=0), axis=1).sum()
    assert length == pytest.approx(g.length, rel=1e-6)
    np.testing.assert_allclose(surface.points(start, v)[:, 2], -(v**2) + 0.1, atol=1e-12)


def meets_targets(design: Design) -> None:
    surface = design.surface
    assert isinstance(surface, Surface)
    f = surface.points(np.zeros(()), surface.profile.t)
    size = np.ptp(design.targets["g"]) + np.ptp(f)
    np.testing.assert_allclose(f, design.targets["f"], atol=1e-9 * size)
    assert isinstance(surface.rail, Turning | Sliding)
    path = surface.rail.path
    if len(path) == 1:
        u = path.trace.arc / path.trace.length
        g = surface.rail.carry(u, np.zeros(()))[0]
        targets = design.targets["g"]
        if len(targets) == 2:
            g = g[[0, -1]]
        np.testing.assert_allclose(g, targets, atol=1e-9 * size)


@settings(max_examples=examples(20), deadline=None)
@given(requests())
def test_it_passes_through_the_targets(request: Request) -> None:
    meets_targets(request.feasible())


@settings(max_examples=examples(20), deadline=None)
@given(orthodiagonal_requests())
def test_it_passes_through_the_targets_orthodiagonal(request: Request) -> None:
    meets_targets(request.feasible())


def test_it_passes_through_the_targets_longitudinal() -> None:
    meets_targets(
        design_longitudinal_linear_repeating(
            pair("cos(t)", "sin(t)", 0.3, 2.8),
            curve_from_points(np.array([[1, 2], [3, 3.5]], float), smooth=False),
            LongitudinalPattern(rows=7, columns=7, sector_deg=[85, 80, 95, 100]),
        )
    )


@pytest.mark.parametrize("options", [{}, {"plane": 1.2}, {"plane": 1.2, "affine": True}])
def test_scale_and_rigid_motion(options: dict[str, Any]) -> None:
    f, g = graph("-x**2 + x/5", -1, 1), graph("sin(x)/3", 0, 5)
    surface = turning(f, g, **options)
    u, v = samples(surface)
    larger = turning(f.scaled(7), g.scaled(7), **options)
    np.testing.assert_allclose(larger.points(u, v), 7 * surface.points(u, v), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(larger.area(0.7), 49 * surface.area(0.1), rtol=1e-9)
    turned = turning(f, g.rotated(0.7), **options)
    cos, sin = np.cos(0.7), np.sin(0.7)
    rotation = np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])
    np.testing.assert_allclose(turned.points(u, v), surface.points(u, v) @ rotation.T, atol=1e-9)
    np.testing.assert_allclose(turned.normals(u, v), surface.normals(u, v) @ rotation.T, atol=1e-9)


def test_corners_are_among_the_lattice() -> None:
    f = curve_from_points(np.array([[-1, 0], [-0.3, 0.5], [1, 0]], float), smooth=False)
    g = curve_from_points(np.array([[0, 0], [4, 1], [9, 0]], float), smooth=False)
    lattice = turning(f, g).lattice(np.inf)
    assert lattice.u.tolist() == [0, 1, 2]
    np.testing.assert_allclose(lattice.v, [0, np.hypot(0.7, 0.5), np.hypot(0.7, 0.5)
                                           + np.hypot(1.3, 0.5)])  # fmt: skip
    finer = turning(f, g).lattice(0.2)
    assert {0.0, 1.0, 2.0} <= set(finer.u.tolist())
    assert set(lattice.v.tolist()) <= set(finer.v.tolist())
    steps = np.linalg.norm(np.diff(finer.points, axis=1), axis=-1)
    assert 0.1 < steps.max() < 0.21  # the mitre is stretched


def test_triangles_face_the_normals() -> None:
    surface = turning(graph("-x**2", -1, 1), graph("sin(x)", 0, 6))
    lattice = surface.lattice(0.1)
    corners = lattice.points.reshape(-1, 3)[lattice.triangles()]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (normals[:, 2] > 0).all()
    area = 0.5 * np.linalg.norm(normals, axis=1).sum()
    assert area == pytest.approx(surface.area(0.02), rel=1e-2)


def test_many_corners_are_not_all_kept() -> None:
    x = np.linspace(0, 20, 1500)
    wave = curve_from_points(np.stack([x, 5 * np.sin(np.pi * x / 10)], axis=-1), smooth=False)
    x = np.linspace(-1, 1, 1000)
    arch = curve_from_points(np.stack([x, -(x**2)], axis=-1), smooth=False)
    surface = turning(arch, wave)
    lattice = surface.lattice(0.5, 1e-3)
    assert lattice.points.size < 3e5
    assert 0 < lattice.left_out < 3e-3
    smooth = turning(graph("-x**2", -1, 1), graph("5*sin(pi*x/10)", 0, 20))
    assert lattice.area() == pytest.approx(smooth.area(0.1), rel=1e-3)
    # Noise that moves what is far from g by much is kept.
    noise = 0.002 * np.random.default_rng(0).normal(size=1500)
    x = np.linspace(0, 20, 1500)
    rough = curve_from_points(np.stack([x, noise], axis=-1), smooth=False)
    assert len(turning(arch, rough).lattice(0.5, 1e-3).u) > 1400


def test_a_lattice_has_as_many_cells_as_it_may_and_says_what_it_left_out() -> None:
    surface = turning(graph("0.01*sin(100*x)", -1, 1), graph("0.02*sin(50*x)", 0, 6), np.pi / 2)
    fine = surface.lattice(0.1)
    cells = (len(fine.u) - 1) * (len(fine.v) - 1)
    assert cells > 50_000
    coarse = surface.lattice(0.1, most=10_000)
    assert (len(coarse.u) - 1) * (len(coarse.v) - 1) <= 10_000
    same = surface.lattice(0.1, most=cells)
    np.testing.assert_array_equal(same.points, fine.points)
    assert same.left_out == fine.left_out == 0
    # No point of the surface is farther from the coarse cells than is admitted.
    cells_of = Triangles.of(coarse.points, coarse.triangles())
    u, v = samples(surface, count=100_000)
    away = cells_of.nearest(surface.points(u, v)).distances.max()
    assert 0.1 * coarse.left_out < away < coarse.left_out
