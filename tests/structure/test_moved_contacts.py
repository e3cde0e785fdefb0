"""Ties, flaps and feet of a structure that is moved far: their forces and tangents."""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.mesh.corotational import Moved
from orishell.structure.solve.contacts import Feet, Links

NONE = np.zeros((0, 3, 3))


def links() -> Links:
    """A tie that is taut, one that is slack, a flap that bears and one that does not."""
    points = np.zeros((4, 2, 3))
    points[:, 1] = [3.0, 4.0, 0.0]
    return Links(
        points=points,
        dofs=np.arange(24).reshape(4, 6),
        sign=np.array([1.0, 1.0, -1.0, -1.0]),
        stiffness=np.array([50.0, 50.0, 80.0, 80.0]),
        hard=np.array([False, False, True, True]),
        borne=np.array([0.0, 0.0, 7.0, 0.0]),
    )


def feet() -> Feet:
    """One that sticks, two that slide, one of them the way it rubbed, and one in the air."""
    return Feet(
        dofs=np.arange(12).reshape(4, 3),
        stiffness=100.0,
        friction=np.full(4, 0.5),
        borne=np.full(4, 8.0),
        rubbed=np.array([[1.0, 1.0], [2.0, 0.0], [0.0, -3.0], [0.0, 0.0]]),
        stood=np.zeros((4, 2)),
    )


STRETCHED = np.zeros((4, 6))
STRETCHED[:, 3:] = [[0.2, 0.3, -0.1], [-0.2, -0.3, 0.1], [0.01, 0.02, 0.0], [0.3, 0.1, 0.2]]
WENT = np.array([[0.01, 0.0, 0.01], [0.3, 0.1, -0.02], [0.1, -0.2, 0.0], [0.2, 0.0, 0.2]])


def test_tangents_are_those_of_the_forces() -> None:
    """Central differences; that of a foot that slides is not symmetric."""
    for part, start in ((links(), STRETCHED.ravel()), (feet(), WENT.ravel())):
        found = part.tangent(Moved(start, NONE))
        for number, dofs in enumerate(part.dofs):
            for k, dof in enumerate(dofs):
                step = 1e-6 * np.eye(len(start))[dof]
                ahead, behind = (
                    part.forces(Moved(start + sign * step, NONE))[number] for sign in (1, -1)
                )
                np.testing.assert_allclose(
                    found.matrices[number, :, k], (ahead - behind) / 2e-6, atol=1e-6
                )
    slides = found.matrices[1]
    assert np.abs(slides - slides.T).max() > 1


def test_friction_is_within_coulomb_s() -> None:
    """And against the way a foot slides; in the air there is none."""
    part, moved = feet(), Moved(WENT.ravel(), NONE)
    forces, presses = part.forces(moved), part.bears(moved)
    rubs = np.linalg.norm(forces[:, :2], axis=1)
    np.testing.assert_allclose(rubs[1:3], 0.5 * presses[1:3])
    assert rubs[0] < 0.5 * presses[0]
    assert (np.sum(forces[1:3, :2] * WENT[1:3, :2], axis=1) > 0).all()
    np.testing.assert_array_equal(forces[3], 0)


def test_who_bears_is_told_by_what_was_expected() -> None:
    """With a force of the other sign, and by how much that is off; none if it is as expected."""
    part, moved = links(), Moved(STRETCHED.ravel(), NONE)
    now = part.borne + part.stiffness * part.gaps(moved)
    as_it_is = part.tangent(moved, now[:, None])
    np.testing.assert_array_equal(as_it_is.forces, part.forces(moved))
    assert as_it_is.other == 0
    other = part.tangent(moved, -now[:, None])
    borne: Array = np.linalg.norm(other.forces[:, :3], axis=1)
    np.testing.assert_allclose(borne, np.maximum(-now, 0))
    np.testing.assert_allclose(other.other, np.linalg.norm(now))
