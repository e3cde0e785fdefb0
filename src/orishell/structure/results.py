"""What an analysis found: of every load case, with every stiffness of creases."""

from __future__ import annotations

from typing import Literal

from orishell.conventions.record import record
from orishell.motion.grid import Grid, Vertex, VertexPair
from orishell.numerics.arrays import Array, Integers
from orishell.structure.sections import Section
from orishell.structure.sheet import SheetMesh
from orishell.structure.triangle import Facets


@record
class Exposure:
    """What is loaded, and how it stands.

    Parameters
    ----------
    mesh
        Nodes (N, 3) and triangles (T, 3), all panels' cells one way round.
    panels
        The panel (T,) of every triangle, as the grid counts it.
    grid
        The grid of the sheet between its flaps; its vertices are the first nodes.
    before
        Number of columns of folded flaps before its first column, which points are counted with.
    areal_mass
        Mass (T,) per area of every triangle (kg per square of the unit).
    hung
        Mass (N,) of flaps that hang on nodes (kg).
    unit
        The design's unit of length.
    ground
        Height of the ground (length).
    span
        From foot to foot; None if it does not stand on two feet (length).
    """

    mesh: Facets
    panels: Integers
    grid: Grid
    before: int
    areal_mass: Array
    hung: Array
    unit: str
    ground: float
    span: float | None

    @property
    def rise(self) -> float:
        """Height of its top over the ground (length)."""
        return float(self.mesh.points[:, 2].max()) - self.ground

    def outer(self) -> Array:
        """Unit normals (T, 3) of the outer face: that which looks up, all panels together."""
        normals = self.mesh.axes()[:, 2]
        up = float(self.mesh.areas() @ normals[:, 2])
        return -normals if up < 0 else normals


@record
class Balance:
    """Loads of a case against what bears them.

    Parameters
    ----------
    load
        Sum of all loads (3,) (N).
    reaction
        Sum of all reactions (3,) (N).
    residual
        Largest of force and moment that are missing, relative to the loads (their forces' sizes,
        and those times the size of the shell).
    """

    load: Array
    reaction: Array
    residual: float


Hold = Literal["ties", "pinned"]
"""What may hold a shell: ties between its feet, or its supports pinned."""


@record
class FreeMotion:
    """A motion that the loads drive, and that nothing resists, or next to nothing.

    Parameters
    ----------
    displacements
        Of all nodes (N, 3), the largest is 1, the way that the loads drive it.
    folding
        Whether it is the shell's own folding motion, not one of the shell as a whole.
    opens
        Whether it opens the shell; it closes it otherwise. None where it is no folding motion.
    holds
        What would hold the shell: each was tried with these loads.
    soft
        Whether something resists it, but so little that it goes beyond the size of the shell.
    """

    displacements: Array
    folding: bool
    opens: bool | None
    holds: tuple[Hold, ...] = ()
    soft: bool = False


@record
class CaseResult:
    """A load case with one stiffness of creases.

    Parameters
    ----------
    name
        The case.
    stiffness
        Of creases (force per radian); 0 free, infinite rigid.
    loads
        Forces on nodes (N, 3) (N).
    motion
        What nothing resists; None if the shell stands. Where it does not, the rest is not a number
        or None.
    balance
        Loads against reactions.
    displacements
        Of nodes (N, 3) (length).
    reactions
        Forces on supported vertices (S, 3), in the order of ``Analysis.supported`` (N).
    friction
        The largest share of the friction of rough ground that a foot uses, which sticks as long as
        it presses; None where no ground is rough.
    tie_forces
        Of ties (K,), 0 where they are slack (N).
    flap_forces
        With which two neighbouring flaps keep the vertices at their outer corners apart (C,), in
        the order of ``Analysis.flaps``; 0 where they part (N).
    crease_moments
        Largest moment per length (E,) about every edge, 0 at the border (N).
    stresses
        Von Mises' stress (T, 2) of every triangle at its lower and upper face (force per area).
    principal
        The larger and the smaller principal stress (T, 2) of both faces (force per area).
    buckling
        Factor of all loads at which the shell buckles, by linear theory; None if it does not, and
        the mode (N, 3), the largest displacement is 1.
    frequencies
        Lowest natural frequencies (M,), loaded as it is: ties that are slack are left out, and free
        motions, which have none (Hz).
    modes
        Their modes (M, N, 3), the largest displacement is 1.
    """

    name: str
    stiffness: float
    loads: Array
    motion: FreeMotion | None
    balance: Balance
    displacements: Array
    reactions: Array
    friction: float | None
    tie_forces: Array
    flap_forces: Array
    crease_moments: Array
    stresses: Array
    principal: Array
    buckling: tuple[float, Array] | None
    frequencies: Array
    modes: Array


@record
class Analysis:
    """A shell as a structure, and what was found of it.

    Parameters
    ----------
    grid
        The grid of the sheet between its flaps.
    before
        Number of columns of folded flaps before its first column: the column of a vertex of the
        folding sheet is that of this grid and these.
    mesh
        Nodes, in the design's frame, and triangles; the vertices of the grid come first.
    section
        Sections of the triangles.
    supported
        Supported vertices, rows and columns of the folding sheet.
    ties
        Its ties, rows and columns of the folding sheet.
    flaps
        What two neighbouring panels of a flap keep apart: vertices of the folding sheet.
    mass
        Of all panels (kg).
    cases
        All load cases, those with the least stiffness of creases first.
    exposure
        What was loaded, and how it stands.
    held
        Supported freedoms (H, 2): a node, and 0 to 2 for a displacement, 3 to 5 for a rotation
        along x, y, z; feet on the ground as if they were pinned.
    change
        By what share the largest displacement of a case changed when cells were halved for the last
        time.
    """

    grid: Grid
    before: int
    mesh: SheetMesh
    section: Section
    supported: tuple[Vertex, ...]
    ties: tuple[VertexPair, ...]
    flaps: tuple[VertexPair, ...]
    mass: float
    cases: tuple[CaseResult, ...]
    exposure: Exposure
    held: Integers
    change: float
