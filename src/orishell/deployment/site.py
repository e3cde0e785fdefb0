"""Where a shell stands, what ties it, and what it weighs."""

from __future__ import annotations

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import conversion
from orishell.conventions.record import record
from orishell.deployment.feet import Feet
from orishell.deployment.settings import Deployment, FoldTies
from orishell.deployment.ties import feet_ties, fold_ties
from orishell.design import Design
from orishell.design.fittings import fit_hinges
from orishell.motion import area_of
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.grid import VertexPair
from orishell.motion.hinges import Hinges
from orishell.solids import BuiltPanels


@record
class Site:
    """Where a shell stands, what ties it, and what it weighs."""

    unit: str  # of its lengths
    feet: Feet | None  # what it stands on; None if it cannot stand
    ties: tuple[VertexPair, ...]  # rows and columns of both ends in the folding sheet
    areal_density: float  # mass per area of the sheet (kg/m^2); 0 where it is not known

    @property
    def metres(self) -> float:
        """Its unit of length."""
        return conversion(self.unit, "m")

    @property
    def areal_mass(self) -> float:
        """Mass per area of the sheet (kg per square of the unit); 0 where it is not known."""
        return self.areal_density * self.metres**2

    @property
    def rows(self) -> tuple[int, int] | None:
        """Rows of vertices that are its feet; None if it cannot stand."""
        return None if self.feet is None else self.feet.rows


def find_site(
    design: Design,
    feet: Feet | None,
    deployment: Deployment,
    built: BuiltPanels | None,
    *,
    unit: str,
    areal_density: float | None = None,
    hinges_kg: float = 0.0,
) -> Site:
    """Return where a shell stands, what ties it, and what it weighs.

    Parameters
    ----------
    feet
        What it stands on; None if it cannot stand.
    built
        Its panels where they have a thickness: they are weighed.
    unit
        The unit of lengths of the design, such as "mm".
    areal_density
        Mass per area that is given instead (kg/m^2).
    hinges_kg
        Mass of hinges in the creases, spread over the sheet where that of its panels is known (kg).

    Raises
    ------
    InputError
        If its feet are to be tied, and there are none.
    """
    density = areal_density or (0.0 if built is None else _weighed(design, built, unit))
    if density:
        density += hinges_kg / (area_of(design.mechanism) * conversion(unit, "m") ** 2)
    return Site(unit, feet, _ties(design, deployment, feet), density)


def _ties(design: Design, deployment: Deployment, feet: Feet | None) -> tuple[VertexPair, ...]:
    if isinstance(deployment.ties, tuple):
        return deployment.ties
    if deployment.ties == "none":
        return ()
    folds = []
    if deployment.ties != "feet":
        rows = deployment.ties.folds if isinstance(deployment.ties, FoldTies) else None
        folds = fold_ties(design.mechanism, rows)
    if folds and feet is None:
        return tuple(folds)
    if feet is None:
        raise InputError(
            "there are no feet to tie",
            keys=("deployment.ties",),
            got='"feet"',
            expected="a shell that stands on two of its rows",
            remedy="name pairs of vertices, [[row, column], [row, column]], or leave ties out",
        )
    columns = feet.columns(design.mechanism).tolist()
    return tuple(dict.fromkeys([*feet_ties(design.mechanism, feet.rows, columns), *folds]))


def _weighed(design: Design, built: BuiltPanels, unit: str) -> float:
    """Mass of built panels per area of the sheet; 0 where the density of a part is not known.

    That of arms and hinges of whole boards is added where it is known.
    """
    build, area, metres = built.build, area_of(design.mechanism), conversion(unit, "m")
    if not build.density or (build.membrane and not build.membrane_density):
        return 0.0
    boards = build.density * float(built.boards.chosen(~built.boards.arms).volumes().sum())
    mass = metres * (boards + build.membrane_density * build.membrane * area)
    if isinstance(design.hinges, Hinges):
        panels = panels_laid_flat(design.mechanism)
        fittings = fit_hinges(panels, design.hinges, build)
        mass += metres * fittings.arm_mass(build) + fittings.hinge_mass(build) / metres
    return mass / area
