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
    """What is loaded, and how it stands."""

    mesh: Facets  # nodes (N, 3) and triangles (T, 3), all panels' cells one way round
    panels: Integers  # the panel (T,) of every triangle, as the grid counts it
    grid: Grid  # the grid of the sheet between its flaps; its vertices are the first nodes
    # number of columns of folded flaps before its first column, which points are counted with
    before: int
    areal_mass: Array  # mass (T,) per area of every triangle (kg per square of the unit)
    hung: Array  # mass (N,) of flaps that hang on nodes (kg)
    unit: str  # the design's unit of length
    ground: float  # height of the ground (length)
    span: float | None  # from foot to foot; None if it does not stand on two feet (length)

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
    """Loads of a case against what bears them."""

    load: Array  # sum of all loads (3,) (N)
    reaction: Array  # sum of all reactions (3,) (N)
    # largest of force and moment that are missing, relative to the loads (their forces' sizes, and
    # those times the size of the shell)
    residual: float


Hold = Literal["ties", "pinned"]
"""What may hold a shell: ties between its feet, or its supports pinned."""


@record
class FreeMotion:
    """A motion that the loads drive, and that nothing resists, or next to nothing."""

    displacements: Array  # of all nodes (N, 3), the largest is 1, the way that the loads drive it
    folding: bool  # whether it is the shell's own folding motion, not one of the shell as a whole
    # Whether it opens the shell; it closes it otherwise. None where it is no folding motion.
    opens: bool | None
    holds: tuple[Hold, ...] = ()  # what would hold the shell: each was tried with these loads
    # whether something resists it, but so little that it goes beyond the size of the shell
    soft: bool = False


@record
class CaseResult:
    """A load case with one stiffness of creases."""

    name: str  # the case
    stiffness: float  # of creases (force per radian); 0 free, infinite rigid
    loads: Array  # forces on nodes (N, 3) (N)
    # What nothing resists; None if the shell stands. Where it does not, the rest is not a number or
    # None.
    motion: FreeMotion | None
    balance: Balance  # loads against reactions
    displacements: Array  # of nodes (N, 3) (length)
    # forces on supported vertices (S, 3), in the order of ``Analysis.supported`` (N)
    reactions: Array
    # the largest share of the friction of rough ground that a foot uses, which sticks as long as it
    # presses; None where no ground is rough
    friction: float | None
    tie_forces: Array  # of ties (K,), 0 where they are slack (N)
    # with which two neighbouring flaps keep the vertices at their outer corners apart (C,), in the
    # order of ``Analysis.flaps``; 0 where they part (N)
    flap_forces: Array
    crease_moments: Array  # largest moment per length (E,) about every edge, 0 at the border (N)
    # von Mises' stress (T, 2) of every triangle at its lower and upper face (force per area)
    stresses: Array
    # the larger and the smaller principal stress (T, 2) of both faces (force per area)
    principal: Array
    # factor of all loads at which the shell buckles, by linear theory; None if it does not, and the
    # mode (N, 3), the largest displacement is 1
    buckling: tuple[float, Array] | None
    # lowest natural frequencies (M,), loaded as it is: ties that are slack are left out, and free
    # motions, which have none (Hz)
    frequencies: Array
    modes: Array  # their modes (M, N, 3), the largest displacement is 1


@record
class Analysis:
    """A shell as a structure, and what was found of it."""

    grid: Grid  # the grid of the sheet between its flaps
    # number of columns of folded flaps before its first column: the column of a vertex of the
    # folding sheet is that of this grid and these
    before: int
    # nodes, in the design's frame, and triangles; the vertices of the grid come first
    mesh: SheetMesh
    section: Section  # sections of the triangles
    supported: tuple[Vertex, ...]  # supported vertices, rows and columns of the folding sheet
    ties: tuple[VertexPair, ...]  # its ties, rows and columns of the folding sheet
    # what two neighbouring panels of a flap keep apart: vertices of the folding sheet
    flaps: tuple[VertexPair, ...]
    mass: float  # of all panels (kg)
    cases: tuple[CaseResult, ...]  # all load cases, those with the least stiffness of creases first
    exposure: Exposure  # what was loaded, and how it stands
    # supported freedoms (H, 2): a node, and 0 to 2 for a displacement, 3 to 5 for a rotation along
    # x, y, z; feet on the ground as if they were pinned
    held: Integers
    # by what share the largest displacement of a case changed when cells were halved for the last
    # time
    change: float
