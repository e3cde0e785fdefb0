"""The flat shell triangle: membrane (OPT) and bending (DKT).

Every node has six dofs, three translations and three rotations, in the world's axes.

C. A. Felippa, "A study of optimal membrane triangles with drilling dofs", Computer Methods in
Applied Mechanics and Engineering 192 (2003). With x_ij = x_i - x_j and side lengths l_ij the
stiffness is a basic part, which alone passes the patch test, and a part of higher order from
deviatoric corner rotations,

    K = L E L^T / A + 3/4 beta_0 T^T K_theta T,

the last from strains along the three sides at their middles.

J.-L. Batoz, K.-J. Bathe and L.-W. Ho, "A study of three-node triangular plate bending elements",
International Journal for Numerical Methods in Engineering 15 (1980). Rotations are quadratic, and
free of shear at corners and middles of sides; curvatures are linear in area coordinates, so that
the three middles of the sides integrate their products exactly.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.elements import Elements, chunks
from orishell.structure.mesh.sections import Section

DOFS = 6
IN_PLANE, OUT_OF_PLANE = (0, 1, 5), (2, 3, 4)
"""Dofs of a node in its triangle's axes: u, v, rotation about z; w, rotations about x and y."""


@record
class Facets:
    """Triangles in space."""

    points: Array  # nodes (N, 3)
    triangles: Integers  # corners (T, 3)

    def axes(self) -> Array:
        """Axes (T, 3, 3) of every triangle, as rows: along its first side, in its plane, normal."""
        corners = self.points[self.triangles]
        x = corners[:, 1] - corners[:, 0]
        z = np.cross(x, corners[:, 2] - corners[:, 0])
        x, z = (each / np.linalg.norm(each, axis=1, keepdims=True) for each in (x, z))
        return np.stack([x, np.cross(z, x), z], axis=1)

    def flat(self) -> Array:
        """Corners (T, 3, 2) of every triangle in its own axes, the first in the origin."""
        corners = self.points[self.triangles]
        away = corners - corners[:, :1]
        return np.asarray(np.einsum("tij,tkj->tki", self.axes(), away)[..., :2])

    def areas(self) -> Array:
        """Area (T,) of every triangle."""
        corners = self.points[self.triangles]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return np.asarray(0.5 * np.linalg.norm(normal, axis=1))

    def element_stiffness(self, section: Section) -> Array:
        """Stiffness (T, 18, 18) of every triangle in the world's axes."""
        found = np.empty((len(self.triangles), 18, 18))
        plane, bending = (
            np.broadcast_to(section.matrix(each), (len(found), 3, 3))
            for each in (section.membrane, section.bending)
        )
        for some in chunks(len(found), 18 * 18):
            part = Facets(self.points, self.triangles[some])
            flat = part.flat()
            membrane = membrane_stiffness(flat, plane[some], section.poisson)
            plate = plate_stiffness(flat, bending[some])
            local = np.zeros((len(flat), 18, 18))
            for stiffness, own in ((membrane, IN_PLANE), (plate, OUT_OF_PLANE)):
                places = (DOFS * np.arange(3)[:, None] + np.array(own)).ravel()
                local[:, places[:, None], places] = stiffness
            found[some] = part.turned(local)
        return found

    def turned(self, local: Array) -> Array:
        """Matrices (T, 18, 18) in the world's axes, of those in every triangle's own axes."""
        axes = self.axes()
        turn = np.zeros((len(axes), 18, 18))
        for k in range(6):
            turn[:, 3 * k : 3 * k + 3, 3 * k : 3 * k + 3] = axes
        return np.asarray(turn.swapaxes(1, 2) @ local @ turn)

    def elements(self, section: Section, dofs: Integers, count: int) -> Elements:
        """The triangles as elements.

        dofs: Freedoms (T, 18) of their corners: displacements, then rotations, of each.
        count: Number of all dofs.
        """
        corners = self.points[self.triangles]
        arms = corners[:, 1:] - corners[:, :1]
        return Elements(self.element_stiffness(section), dofs, arms, count)

    def dofs(self) -> Integers:
        """Dofs (T, 18) of the corners of every triangle, where no node has rotations apart."""
        places = DOFS * self.triangles[..., None] + np.arange(DOFS)
        return np.asarray(places.reshape(-1, 18))


LUMPING = 1.5
"""The template's alpha_b."""
BETAS = np.array([[1.0, 2.0, 1.0], [0.0, 1.0, -1.0], [-1.0, -1.0, -2.0]])
"""The template's beta_1 ... beta_9, row by row."""
LEAST_BETA = 0.01
"""Smallest beta_0: it would be 0 for a Poisson's ratio of 1/2."""


def membrane_stiffness(corners: Array, elasticity: Array, poisson: float) -> Array:
    """Stiffness (T, 9, 9) of triangles for u, v and the rotation about z at every corner.

    corners: Corners (T, 3, 2), counter-clockwise (length).
    elasticity: Forces per length by strains xx, yy, xy (T, 3, 3), or one for all (3, 3).
    poisson: Poisson's ratio, which the template's beta_0 depends on.
    """
    x, y = corners[..., 0], corners[..., 1]
    x21, x32, x13 = x[:, 1] - x[:, 0], x[:, 2] - x[:, 1], x[:, 0] - x[:, 2]
    y21, y32, y13 = y[:, 1] - y[:, 0], y[:, 2] - y[:, 1], y[:, 0] - y[:, 2]
    x12, x23, x31, y12, y23, y31 = -x21, -x32, -x13, -y21, -y32, -y13
    zero = np.zeros_like(x21)
    area = 0.5 * (x21 * -y13 - -x13 * y21)
    mean = strains(corners)
    basic = mean.swapaxes(1, 2) @ elasticity @ mean * area[:, None, None]

    # Corner rotations less that of the triangle as a whole.
    whole = np.stack([x32, y32, zero, x13, y13, zero, x21, y21, zero], axis=-1)
    rotations = np.repeat(whole[:, None], 3, axis=1) / (4 * area[:, None, None])
    rotations[:, [0, 1, 2], [2, 5, 8]] += 1.0

    side = np.stack([x21**2 + y21**2, x32**2 + y32**2, x13**2 + y13**2], axis=-1)
    sides = np.stack(
        [
            _rows(y23 * y13, y31 * y21, y12 * y32),
            _rows(x23 * x13, x31 * x21, x12 * x32),
            _rows(y23 * x31 + x32 * y13, y31 * x12 + x13 * y21, y12 * x23 + x21 * y32),
        ],
        axis=1,
    ) * (side[:, None] / (4 * area[:, None, None] ** 2))
    natural = sides.swapaxes(1, 2) @ elasticity @ sides
    scale = (2 * area / 3)[:, None, None] / side[..., None]
    turned = [np.roll(np.roll(BETAS, k, axis=0), k, axis=1) for k in range(3)]
    corner = [scale * each for each in turned]
    higher = np.zeros_like(natural)
    for first, second in ((0, 1), (1, 2), (2, 0)):
        middle = 0.5 * (corner[first] + corner[second])
        higher += middle.swapaxes(1, 2) @ natural @ middle
    beta = max(0.5 * (1 - 4 * poisson**2), LEAST_BETA)
    higher *= 0.75 * beta * area[:, None, None]
    return np.asarray(basic + rotations.swapaxes(1, 2) @ higher @ rotations)


def strains(corners: Array) -> Array:
    """Mean strains (T, 3, 9) xx, yy, xy by u, v and the rotation about z at every corner.

    corners: Corners (T, 3, 2), counter-clockwise (length).
    """
    x, y = corners[..., 0], corners[..., 1]
    x21, x32, x13 = x[:, 1] - x[:, 0], x[:, 2] - x[:, 1], x[:, 0] - x[:, 2]
    y21, y32, y13 = y[:, 1] - y[:, 0], y[:, 2] - y[:, 1], y[:, 0] - y[:, 2]
    x12, x23, x31, y12, y23, y31 = -x21, -x32, -x13, -y21, -y32, -y13
    area = 0.5 * (x21 * -y13 - -x13 * y21)
    zero, a = np.zeros_like(area), LUMPING
    lumping = 0.5 * np.stack(
        [
            _rows(y23, zero, x32),
            _rows(zero, x32, y23),
            a * _rows(y23 * (y13 - y21) / 6, x32 * (x31 - x12) / 6, (x31 * y13 - x12 * y21) / 3),
            _rows(y31, zero, x13),
            _rows(zero, x13, y31),
            a * _rows(y31 * (y21 - y32) / 6, x13 * (x12 - x23) / 6, (x12 * y21 - x23 * y32) / 3),
            _rows(y12, zero, x21),
            _rows(zero, x21, y12),
            a * _rows(y12 * (y32 - y13) / 6, x21 * (x23 - x31) / 6, (x23 * y32 - x31 * y13) / 3),
        ],
        axis=1,
    )
    return np.asarray(lumping.swapaxes(1, 2) / area[:, None, None])


def _rows(*parts: Array) -> Array:
    return np.stack(parts, axis=-1)


MIDDLES = ((0.5, 0.0), (0.5, 0.5), (0.0, 0.5))
"""Middles of the sides in the coordinates xi, eta."""


def plate_stiffness(corners: Array, rigidity: Array) -> Array:
    """Stiffness (T, 9, 9) of triangles for w and the rotations about x and y at every corner.

    corners: Corners (T, 3, 2), counter-clockwise (length).
    rigidity: Moments per length by curvatures xx, yy, xy (T, 3, 3), or one for all (3, 3).
    """
    area = _area(corners)
    total = np.zeros((len(corners), 9, 9))
    for middle in MIDDLES:
        curvature = curvatures(corners, middle)
        total += curvature.swapaxes(1, 2) @ rigidity @ curvature
    return np.asarray(total * (area / 3)[:, None, None])


def curvatures(corners: Array, at: tuple[float, float]) -> Array:
    """Curvatures (T, 3, 9) xx, yy and twice xy at a place of every triangle.

    corners: Corners (T, 3, 2), counter-clockwise (length).
    at: Area coordinates of the second and the third corner.
    """
    xi, eta = at
    x, y = corners[..., 0], corners[..., 1]
    # Sides 4, 5, 6 of the paper: from corner 2 to 3, 3 to 1, 1 to 2.
    dx = np.stack([x[:, 1] - x[:, 2], x[:, 2] - x[:, 0], x[:, 0] - x[:, 1]])
    dy = np.stack([y[:, 1] - y[:, 2], y[:, 2] - y[:, 0], y[:, 0] - y[:, 1]])
    square = dx**2 + dy**2
    p4, p5, p6 = -6 * dx / square
    t4, t5, t6 = -6 * dy / square
    q4, q5, q6 = 3 * dx * dy / square
    r4, r5, r6 = 3 * dy**2 / square
    a, b = 1 - 2 * xi, 1 - 2 * eta
    x_xi = [
        p6 * a + (p5 - p6) * eta,
        q6 * a - (q5 + q6) * eta,
        -4 + 6 * (xi + eta) + r6 * a - eta * (r5 + r6),
        -p6 * a + eta * (p4 + p6),
        q6 * a - eta * (q6 - q4),
        -2 + 6 * xi + r6 * a + eta * (r4 - r6),
        -eta * (p5 + p4),
        eta * (q4 - q5),
        -eta * (r5 - r4),
    ]
    y_xi = [
        t6 * a + eta * (t5 - t6),
        1 + r6 * a - eta * (r5 + r6),
        -q6 * a + eta * (q5 + q6),
        -t6 * a + eta * (t4 + t6),
        -1 + r6 * a + eta * (r4 - r6),
        -q6 * a - eta * (q4 - q6),
        -eta * (t4 + t5),
        eta * (r4 - r5),
        -eta * (q4 - q5),
    ]
    x_eta = [
        -p5 * b - xi * (p6 - p5),
        q5 * b - xi * (q5 + q6),
        -4 + 6 * (xi + eta) + r5 * b - xi * (r5 + r6),
        xi * (p4 + p6),
        xi * (q4 - q6),
        -xi * (r6 - r4),
        p5 * b - xi * (p4 + p5),
        q5 * b + xi * (q4 - q5),
        -2 + 6 * eta + r5 * b + xi * (r4 - r5),
    ]
    y_eta = [
        -t5 * b - xi * (t6 - t5),
        1 + r5 * b - xi * (r5 + r6),
        -q5 * b + xi * (q5 + q6),
        xi * (t4 + t6),
        xi * (r4 - r6),
        -xi * (q4 - q6),
        t5 * b - xi * (t4 + t5),
        -1 + r5 * b + xi * (r4 - r5),
        -q5 * b - xi * (q4 - q5),
    ]
    hx_xi, hy_xi, hx_eta, hy_eta = (
        np.stack([np.broadcast_to(part, len(corners)) for part in parts], axis=-1)
        for parts in (x_xi, y_xi, x_eta, y_eta)
    )
    x31, y31 = (x[:, 2] - x[:, 0])[:, None], (y[:, 2] - y[:, 0])[:, None]
    x12, y12 = (x[:, 0] - x[:, 1])[:, None], (y[:, 0] - y[:, 1])[:, None]
    rows = [
        y31 * hx_xi + y12 * hx_eta,
        -x31 * hy_xi - x12 * hy_eta,
        -x31 * hx_xi - x12 * hx_eta + y31 * hy_xi + y12 * hy_eta,
    ]
    return np.stack(rows, axis=1) / (2 * _area(corners))[:, None, None]


CORNERS = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
"""Corners in the coordinates xi, eta."""


def _area(corners: Array) -> Array:
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.asarray(0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]))
