"""The flat shell triangle: membrane (OPT) and bending (DKT, or DKMT where it shears).

Every node has six dofs, three translations and three rotations, in the world's axes.

C. A. Felippa, "A study of optimal membrane triangles with drilling dofs", Computer Methods in
Applied Mechanics and Engineering 192 (2003). With x_ij = x_i - x_j and side lengths l_ij the
stiffness is a basic part, which alone passes the patch test, and a part of higher order from
deviatoric corner rotations,

    K = L E L^T / A + 3/4 beta_0 T^T K_theta T,

the last from strains along the three sides at their middles.

J.-L. Batoz, K.-J. Bathe and L.-W. Ho, "A study of three-node triangular plate bending elements",
International Journal for Numerical Methods in Engineering 15 (1980). Rotations are quadratic, and
free of shear along sides; curvatures are linear in area coordinates, so that the three middles of
the sides integrate their products exactly.

I. Katili, "A new discrete Kirchhoff-Mindlin element based on Mindlin-Reissner plate theory and
assumed shear strain fields - part I", the same journal 36 (1993). Sides are as soft in shear as
their bending asks for: by what rotations bulge at the middle of a side of length l, db, the moment
changes by -8 D db/l^2, and with shear stiffness S that strains it by gamma = -8 D/(S l^2) db. On
average along the side this is w,s + beta_s, so that with phi = 12 D/(S l^2)

    db = -3/(2 l (1 + phi)) (w_j - w_i + l (beta_i + beta_j)/2),

which is DKT where S is infinite. At corners gamma is that of both sides, and linear between them.
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
            np.broadcast_to(each, (len(found), 3, 3))
            for each in (section.in_plane, section.in_bending)
        )
        softness, shear = (
            np.broadcast_to(np.asarray(each, np.float64), len(found))
            for each in (section.softness, section.shear)
        )
        for some in chunks(len(found), 18 * 18):
            part = Facets(self.points, self.triangles[some])
            flat = part.flat()
            membrane = membrane_stiffness(flat, plane[some], section.poisson)
            plate = plate_stiffness(flat, bending[some], softness[some], shear[some])
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


def plate_stiffness(corners: Array, rigidity: Array, softness: Array, shear: Array) -> Array:
    """Stiffness (T, 9, 9) of triangles for w and the rotations about x and y at every corner.

    corners: Corners (T, 3, 2), counter-clockwise (length).
    rigidity: Moments per length by curvatures xx, yy, xy (T, 3, 3), or one for all (3, 3).
    softness: Bending stiffness by that in shear (T,), 0 where shear does not count (length^2).
    shear: Force per length by shear strain (T,), where softness is not 0.
    """
    area = _area(corners)[:, None, None]
    total = np.zeros((len(corners), 9, 9))
    for middle in MIDDLES:
        curvature = curvatures(corners, middle, softness)
        total += curvature.swapaxes(1, 2) @ rigidity @ curvature
    if softness.any():
        sheared = np.where(softness > 0, shear, 0.0)[:, None, None]
        at_corners = shear_strains(corners, softness)
        for first, second in ((0, 1), (1, 2), (2, 0)):
            strain = 0.5 * (at_corners[:, first] + at_corners[:, second])
            total += sheared * (strain.swapaxes(1, 2) @ strain)
    return np.asarray(total * (area / 3))


SIDES = ((0, 1), (1, 2), (2, 0))
"""Corners at both ends of sides."""


def curvatures(corners: Array, at: tuple[float, float], softness: Array | float = 0.0) -> Array:
    """Curvatures (T, 3, 9) xx, yy and twice xy at a place of every triangle.

    corners: Corners (T, 3, 2), counter-clockwise (length).
    at: Area coordinates of the second and the third corner.
    softness: Bending stiffness by that in shear (T,), 0 where shear does not count (length^2).
    """
    place = 1 - at[0] - at[1], *at
    slopes = _slopes(corners)
    found = np.zeros((len(corners), 3, 9))
    for k in range(3):
        x, y = slopes[:, k].T
        # beta_x is the rotation about y, beta_y that about -x.
        found[:, 0, 3 * k + 2], found[:, 1, 3 * k + 1] = x, -y
        found[:, 2, 3 * k + 2], found[:, 2, 3 * k + 1] = y, -x
    for (i, j), (along, bulge) in zip(SIDES, _bulges(corners, softness), strict=True):
        x, y = 4 * (place[i] * slopes[:, j] + place[j] * slopes[:, i]).T
        c, s = along.T
        bent = np.stack([x * c, y * s, y * c + x * s], axis=1)
        found += bent[:, :, None] * bulge[:, None]
    return found


def shear_strains(corners: Array, softness: Array) -> Array:
    """Shear strains (T, 3, 2, 9) across the plane, along x and y, at corners; linear between them.

    corners: Corners (T, 3, 2), counter-clockwise (length).
    softness: Bending stiffness by that in shear (T,) (length^2).
    """
    sides = _bulges(corners, softness)
    # Along a side the moment changes by -8 D bulge/l^2, and that is its shear.
    strains = []
    for (i, j), (_, bulge) in zip(SIDES, sides, strict=True):
        square = np.sum((corners[:, j] - corners[:, i]) ** 2, axis=1)
        strains.append(-8 * (softness / square)[:, None] * bulge)
    found = np.empty((len(corners), 3, 2, 9))
    for k in range(3):
        before, after = (k + 2) % 3, k
        both = np.stack([sides[before][0], sides[after][0]], axis=1)
        found[:, k] = np.linalg.solve(both, np.stack([strains[before], strains[after]], axis=1))
    return found


def _bulges(corners: Array, softness: Array | float) -> list[tuple[Array, Array]]:
    """Directions (T, 2) of sides, and by how much (T, 9) rotations along them bulge at middles."""
    found = []
    for i, j in SIDES:
        side = corners[:, j] - corners[:, i]
        length = np.linalg.norm(side, axis=1)
        c, s = (side / length[:, None]).T
        bulge = np.zeros((len(corners), 9))
        bulge[:, 3 * i], bulge[:, 3 * j] = -1.0, 1.0
        for k in (i, j):
            bulge[:, 3 * k + 1], bulge[:, 3 * k + 2] = -0.5 * length * s, 0.5 * length * c
        phi = 12 * softness / length**2
        found.append((np.stack([c, s], axis=1), -1.5 / (length * (1 + phi))[:, None] * bulge))
    return found


def _slopes(corners: Array) -> Array:
    """Slopes (T, 3, 2) along x and y of area coordinates."""
    side = np.roll(corners, 1, axis=1) - np.roll(corners, -1, axis=1)
    across = np.stack([-side[..., 1], side[..., 0]], axis=-1)
    return np.asarray(across / (2 * _area(corners))[:, None, None])


CORNERS = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
"""Corners in the coordinates xi, eta."""


def _area(corners: Array) -> Array:
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.asarray(0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]))
