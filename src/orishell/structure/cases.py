"""What was found of a load case, as the report says it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import GRAVITY, conversion, plain
from orishell.locking.result import Panel
from orishell.motion.grid import VertexPair
from orishell.numerics.arrays import Array
from orishell.structure.build_warnings import motion_in_words
from orishell.structure.case_report import (
    CaseReport,
    CreaseReport,
    DisplacementReport,
    Limiting,
    LoadReport,
    PairReport,
    ReactionReport,
    StandingReport,
    Stiffness,
    StressReport,
    UtilisationReport,
    Vector,
)
from orishell.structure.loads import (
    Load,
    case_loads,
    cylinder_coefficient,
    gusts,
    wind_height,
    wind_pressure,
)
from orishell.structure.results import Analysis, CaseResult, Exposure
from orishell.structure.settings import LoadCase, Structure, Wind


def describe_case(
    structure: Structure,
    analysis: Analysis,
    case: LoadCase,
    found: CaseResult,
) -> CaseReport:
    """A load case with one stiffness of creases.

    Parameters
    ----------
    structure
        What was asked.
    case
        The case as it was asked for.
    found
        What was found of it.
    """
    exposure = analysis.exposure
    loads = case_loads(exposure, case, structure.cases)
    stands = found.motion is None
    return CaseReport(
        name=found.name,
        creases=stiffness_in_words(found.stiffness),
        loads=tuple(_load(exposure, each) for each in loads),
        load=_vector(found.balance.load),
        moves=None if found.motion is None else motion_in_words(found.motion),
        stands=_standing(structure, analysis, found) if stands else None,
    )


def stiffness_in_words(stiffness: float) -> Stiffness:
    """A stiffness of creases, 0 and infinite in words.

    Parameters
    ----------
    stiffness
        Moment per length and angle (force per radian).
    """
    return "free" if not stiffness else "rigid" if np.isinf(stiffness) else stiffness


def _standing(structure: Structure, analysis: Analysis, found: CaseResult) -> StandingReport:
    stress, crease = _stress(analysis, found), _crease(analysis, found)
    ties = _pairs(analysis.ties, found.tie_forces)
    factor = None if found.buckling is None else found.buckling[0]
    used: dict[Limiting, float | None] = {
        "panels": _share(stress.size, structure.strength),
        "creases": _share(0.0 if crease is None else crease.moment, structure.crease_strength),
        "ties": _share(ties[0].force if ties else 0.0, structure.tie_strength),
        "buckling": None if factor is None else 1 / factor,
    }
    return StandingReport(
        reaction=_vector(found.balance.reaction),
        residual=found.balance.residual,
        displacement=_displacement(analysis, found),
        reactions=tuple(
            ReactionReport(at, _vector(force))
            for at, force in zip(analysis.supported, found.reactions, strict=True)
        ),
        friction=found.friction,
        ties=ties,
        flaps=_pairs(analysis.flaps, found.flap_forces),
        crease=crease,
        stress=stress,
        utilisation=UtilisationReport(
            used["panels"], used["creases"], used["ties"], used["buckling"], _largest(used)
        ),
        buckling=factor,
        frequencies=tuple(found.frequencies.tolist()),
    )


def height_of(analysis: Analysis) -> float:
    """Height of a shell between its flaps (length)."""
    return float(np.ptp(analysis.mesh.facets.points[:, 2]))


def _displacement(analysis: Analysis, found: CaseResult) -> DisplacementReport:
    sizes = np.linalg.norm(found.displacements, axis=1)
    node = int(sizes.argmax())
    panel = int(np.argmax((analysis.mesh.nodes == node).any(axis=(1, 2))))
    return DisplacementReport(
        size=float(sizes[node]),
        vector=_vector(found.displacements[node]),
        panel=_panel(analysis, panel),
        share=float(sizes[node] / height_of(analysis)),
    )


def _stress(analysis: Analysis, found: CaseResult) -> StressReport:
    triangle, face = np.unravel_index(found.stresses.argmax(), found.stresses.shape)
    return StressReport(
        size=float(found.stresses[triangle, face]),
        panel=_panel(analysis, int(analysis.mesh.panels[triangle])),
        face="upper" if face else "lower",
        largest=float(found.principal[:, 0].max()),
        least=float(found.principal[:, 1].min()),
    )


def _crease(analysis: Analysis, found: CaseResult) -> CreaseReport | None:
    moments = np.abs(found.crease_moments)
    beside = (analysis.grid.faces_edges() == moments.argmax()).any(axis=1)
    panels = np.flatnonzero(beside).tolist()
    if len(panels) < 2 or not found.stiffness:
        return None
    first, second = (_panel(analysis, panel) for panel in panels)
    return CreaseReport(float(moments.max()), (first, second))


def _pairs(ends: Sequence[VertexPair], forces: Array) -> tuple[PairReport, ...]:
    """Forces between pairs of vertices, the largest first, none left out."""
    order = np.argsort(-forces, kind="stable").tolist()
    return tuple(PairReport(ends[number], float(forces[number])) for number in order)


def _panel(analysis: Analysis, number: int) -> Panel:
    row, column = divmod(number, analysis.grid.columns - 1)
    return row, column + analysis.before


def _vector(values: Array) -> Vector:
    x, y, z = values.tolist()
    return x, y, z


def _share(found: float, strength: float | None) -> float | None:
    return None if strength is None else found / strength


def _largest(shares: Mapping[Limiting, float | None]) -> Limiting | None:
    known = [(share, part) for part, share in shares.items() if share]
    return max(known)[1] if known else None


def _load(exposure: Exposure, load: Load) -> LoadReport:
    pressure, rule = _origin(exposure, load)
    force = _vector(load.forces.sum(axis=0))
    return LoadReport(load.case.name, load.factor, load.kind, pressure, rule, force)


def _origin(exposure: Exposure, load: Load) -> tuple[float | None, str]:
    """The pressure that a load comes from, and how it does."""
    case = load.case
    if load.kind == "snow" and case.snow is not None:
        rule = "mu_1 by the slope of each panel"
        if case.snow.shape == "cylinder":
            rule = (
                f"mu_3 = {plain(cylinder_coefficient(exposure))} by a rise of "
                f"{plain(exposure.rise)} and a span of {plain(exposure.span or 0.0)} "
                f"{exposure.unit}, to a slope of 60 degrees"
            )
        return case.snow.ground, f"{rule}, on plan areas (EN 1991-1-3)"
    if load.kind == "wind" and case.wind is not None:
        return wind_pressure(exposure, case.wind), _gusts(exposure, case.wind)
    if load.kind == "pressure":
        return case.pressure, "square on the outer face"
    if load.kind == "points":
        return None, "at vertices {}".format(", ".join(str(list(each.at)) for each in case.points))
    return None, f"mass of panels times {GRAVITY:g} m/s2"


def _gusts(exposure: Exposure, wind: Wind) -> str:
    height = wind_height(exposure, wind)
    mean, turbulence = gusts(wind.speed, wind.terrain, height * conversion(exposure.unit, "m"))
    kind = "by the angle between each panel and the wind"
    if wind.is_of_no_code:
        kind += ", of no code"
    elif wind.zones:
        kind = "by rows of panels"
    return (
        f"{wind.speed:g} m/s towards {in_degrees(wind.direction)} degrees from x, terrain "
        f"{wind.terrain}, {plain(height)} {exposure.unit} over the ground: mean wind "
        f"{plain(mean)} m/s, "
        f"turbulence {plain(turbulence, 3)} (EN 1991-1-4); pressure coefficients {kind}"
    )
