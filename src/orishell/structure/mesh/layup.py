"""What a board is made of through its thickness: solid, or two faces with a core between them.

With E' = E/(1 - nu^2) a solid board of thickness t has E' t in its plane and E' t^3/12 in bending.
Faces of thickness f at a distance d = t - f on a core of thickness c = t - 2 f have

    2 E' f,    E' (f d^2/2 + f^3/6),

and the core, which is soft, shears: by Q/S under shear Q across the plane, with

    S = G_c d^2/c,    tau = Q/d

in it (H. G. Allen, Analysis and design of structural sandwich panels, 1969, chapter 2). What
shears in a solid board is left out. Faces that are pressed wrinkle on the core at

    0.5 (E E_c G_c)^(1/3)

(N. J. Hoff and S. E. Mautner, "The buckling of sandwich-type panels", Journal of the Aeronautical
Sciences 12, 1945). A perfectly flat face on a deep core would bear 0.78 instead of 0.5 (core as an
elastic half-plane, nu 0.3): 0.5 is the value of design, for faces that are not quite flat.
Chamfers are taken to have the face run on over them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.numerics.arrays import Array


@record
class Core:
    """What is between the faces of a sandwich."""

    face: float  # thickness of each face (length)
    shear_modulus: float  # of the core (force per area)
    modulus: float  # Young's modulus of the core across the plane (force per area)


@record
class Layup:
    """What boards are made of."""

    modulus: float  # Young's modulus, that of faces where there is a core (force per area)
    poisson: float  # Poisson's ratio of the same
    core: Core | None = None  # None if boards are solid

    @property
    def plane(self) -> float:
        """Young's modulus where strain across is restrained (force per area)."""
        return self.modulus / (1 - self.poisson**2)

    def area(self, thickness: ArrayLike) -> Array:
        """Thickness (...) of what bears forces in the plane, of boards as thick (...)."""
        whole = np.asarray(thickness, np.float64)
        return whole if self.core is None else np.where(whole > 0, 2 * self.core.face, 0.0)

    def inertia(self, thickness: ArrayLike) -> Array:
        """Moment of inertia per length (...), of boards as thick (...) (length^3)."""
        if self.core is None:
            return np.asarray(np.asarray(thickness, np.float64) ** 3 / 12)
        face = self.core.face
        faces = face * self.depth(thickness) ** 2 / 2 + face**3 / 6
        return np.where(np.asarray(thickness) > 0, faces, 0.0)

    def depth(self, thickness: ArrayLike) -> Array:
        """Over how much (...) shear across the plane is spread, of boards as thick (...)."""
        whole = np.asarray(thickness, np.float64)
        return whole if self.core is None else np.maximum(whole - self.core.face, self.core.face)

    def shear(self, thickness: ArrayLike) -> Array:
        """Force per length by shear strain across the plane (...); infinite of solid boards."""
        whole = np.asarray(thickness, np.float64)
        if self.core is None:
            return np.full(whole.shape, np.inf)
        core = np.maximum(whole - 2 * self.core.face, self.core.face)
        return np.asarray(self.core.shear_modulus * self.depth(whole) ** 2 / core)

    def stresses(self, thickness: float, normal: Array, moment: Array) -> tuple[Array, Array]:
        """Direct and bending stress (...) of the outermost fibres, by force and moment per length.

        thickness: Of a board.
        """
        outermost = 0.5 * thickness / float(self.inertia(thickness))
        return normal / float(self.area(thickness)), moment * outermost

    @property
    def wrinkling(self) -> float | None:
        """The pressure at which faces wrinkle (force per area); None of solid boards."""
        if self.core is None:
            return None
        return 0.5 * float(np.cbrt(self.modulus * self.core.modulus * self.core.shear_modulus))
