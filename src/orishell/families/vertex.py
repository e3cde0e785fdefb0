"""Developable degree-4 vertices: relations between sector angles and fold angles.

Column-straight vertices (sections LU + LD = RU + RD = pi): with psi the angle between the two
column creases, write c = cos(psi/2), and for a row crease with the sector angle a below it
k = cos a, w = sqrt(sin(psi/2)^2 - k^2). The row crease then leaves the column's axis t at the
angle eps with cos eps = k/sin(psi/2), sin eps = w/sin(psi/2); it exists where w is real.

The paper has these relations at lock, within equations (2) and (3); here they hold in every state.
Fold angles are deviations from flat, valley positive, in (-pi, pi]; here without sign.

Derived in docs/theory/vertex.md.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array


def row_fold_angle(c: Array, w: Array) -> Array:
    """Size of the fold angle of a row crease at a column-straight vertex (radians).

    The panels beside the crease are inclined to the row's plane by phi with
    sin phi = c/sin a, cos phi = w/sin a; the crease folds by 2 phi.

    Parameters
    ----------
    c, w
        As in the module's text (...); both may carry the same positive factor.
    """
    angle: Array = 2 * np.arctan2(c, w)
    return angle


def column_fold_angle(
    c: Array, k_left: Array, w_left: Array, k_right: Array, w_right: Array
) -> Array:
    """Fold angle of the column creases at a column-straight vertex (radians).

    Each side's panels make with the normal of the column's plane the angle arctan(c k/w), the
    two of them together the fold angle. Its sign is that of cos eps_L + cos eps_R: zero where
    the row is straight, the same through the whole motion.

    Parameters
    ----------
    c, k_left, w_left, k_right, w_right
        As in the module's text (...); k and w of one side may carry the same positive factor.
    """
    angle: Array = np.arctan2(c * k_left, w_left) + np.arctan2(c * k_right, w_right)
    return angle
