"""A shell as a structure, as files and pages show it: meshed, supported, loaded and deflected."""

from __future__ import annotations

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers


@record
class LoadedCase:
    """One load case with one stiffness of creases.

    Parameters
    ----------
    name
        What it is called, the stiffness of creases said where there are two.
    stands
        Whether it is in balance; displacements are those of its free motion otherwise, the largest
        is 1.
    forces
        Loads on nodes (N, 3) (N).
    displacements
        Of nodes (N, 3) (length).
    stresses
        The larger of von Mises' stresses (T,) at both faces (force per area).
    """

    name: str
    stands: bool
    forces: Array
    displacements: Array
    stresses: Array


@record
class LoadedShell:
    """A meshed shell at its target, in the document's frame, with its load cases.

    Parameters
    ----------
    points
        Nodes (N, 3).
    triangles
        Corners (T, 3), all one way round; the two of every cell follow each other.
    panels
        The panel (T,) of every triangle, flaps counted.
    membrane, bending
        Stiffness (T,) of sections: force per length by strain, moment per length by curvature.
    poisson
        Poisson's ratio.
    areal_mass
        Mass (T,) per area (kg per square of the unit).
    held
        Supported freedoms (H, 2): a node, and 0 to 2 for a displacement, 3 to 5 for a rotation
        along x, y, z; feet on the ground as if they were pinned.
    ties
        Ends (K, 2) of ties.
    tie_stiffness
        Their force by strain; infinite if they do not stretch (N).
    cases
        The load cases.
    """

    points: Array
    triangles: Integers
    panels: Integers
    membrane: Array
    bending: Array
    poisson: float
    areal_mass: Array
    held: Integers
    ties: Integers
    tie_stiffness: float
    cases: tuple[LoadedCase, ...]
