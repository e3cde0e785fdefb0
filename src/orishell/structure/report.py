"""The shell as a structure, in the report: forces in newtons, all else in the design's unit."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.design import PanelSpec
from orishell.motion.grid import Vertex
from orishell.structure.build_warnings import NOT_COVERED, warn_of_structure
from orishell.structure.case_report import CaseReport, Part, Stiffness
from orishell.structure.cases import describe_case, height_of, stiffness_in_words
from orishell.structure.results import Analysis
from orishell.structure.settings import Place, Structure, SupportKind


@record
class SupportReport:
    """What holds some vertices.

    Parameters
    ----------
    at
        The rows that are feet, the first and last columns, or vertices.
    kind
        How they are held.
    friction
        Coefficient of friction of the ground.
    """

    at: Place | tuple[Vertex, ...]
    kind: SupportKind
    friction: float


@record
class ModelReport:
    """What is analysed.

    Parameters
    ----------
    nodes, triangles, freedoms
        Size of the mesh.
    change
        By what share the largest displacement of a case changed when cells were halved for the last
        time.
    mass
        Of all panels (kg).
    height
        Of the shell between its flaps.
    thickness
        Of panels.
    modulus, poisson, membrane_modulus
        Young's modulus of panels or boards, their Poisson's ratio, and Young's modulus of the
        membrane between boards (force per area).
    membrane_stiffness, bending_stiffness
        Of the sections of panels, the least and the largest: force per length by strain, and moment
        per length by curvature.
    crease_stiffness
        The least and the largest with which all is analysed.
    tie_stiffness
        Force by strain; None if ties do not stretch.
    strength, crease_strength, tie_strength
        What panels bear (force per area), creases (moment per length) and ties (force); None if it
        is not known.
    supports
        What holds the shell.
    """

    nodes: int
    triangles: int
    freedoms: int
    change: float
    mass: float
    height: float
    thickness: float
    modulus: float
    poisson: float
    membrane_modulus: float
    membrane_stiffness: tuple[float, float]
    bending_stiffness: tuple[float, float]
    crease_stiffness: tuple[Stiffness, Stiffness]
    tie_stiffness: float | None
    strength: float | None
    crease_strength: float | None
    tie_strength: float | None
    supports: tuple[SupportReport, ...]


@record
class GoverningReport:
    """What is nearest to the end of what it bears, of all cases.

    Parameters
    ----------
    part
        What it is.
    case, creases
        The load case, and the stiffness of its creases.
    utilisation
        The share of what it bears.
    """

    part: Part
    case: str
    creases: Stiffness
    utilisation: float


@record
class StructureReport:
    """The shell as a structure.

    Parameters
    ----------
    model
        What is analysed.
    cases
        All load cases, those with the least stiffness of creases first.
    governs
        What is nearest to the end of what it bears; None if that of nothing is known.
    warnings
        Sentences an engineer should read.
    not_covered
        What the analysis says nothing of.
    """

    model: ModelReport
    cases: tuple[CaseReport, ...]
    governs: GoverningReport | None
    warnings: tuple[str, ...]
    not_covered: tuple[str, ...]


def describe_structure(
    structure: Structure, analysis: Analysis, panel: PanelSpec | None
) -> StructureReport:
    """The shell as a structure, and what was found of it.

    Parameters
    ----------
    structure
        What was asked.
    panel
        What panels are made of; None if they have the thickness of ``structure``.
    """
    model = _model(structure, analysis, panel)
    asked = {case.name: case for case in structure.cases}
    cases = tuple(
        describe_case(structure, analysis, asked[found.name], found) for found in analysis.cases
    )
    return StructureReport(
        model=model,
        cases=cases,
        governs=_governing(cases),
        warnings=tuple(warn_of_structure(structure, cases, analysis.change)),
        not_covered=NOT_COVERED,
    )


def _model(structure: Structure, analysis: Analysis, panel: PanelSpec | None) -> ModelReport:
    thickness = structure.thickness if panel is None else panel.thickness
    assert thickness is not None
    mesh, section = analysis.mesh, analysis.section
    low, high = structure.crease_stiffness
    return ModelReport(
        nodes=len(mesh.facets.points),
        triangles=len(mesh.facets.triangles),
        freedoms=mesh.count,
        change=analysis.change,
        mass=analysis.mass,
        height=height_of(analysis),
        thickness=thickness,
        modulus=structure.modulus,
        poisson=structure.poisson,
        membrane_modulus=structure.membrane_modulus,
        membrane_stiffness=_range(section.membrane),
        bending_stiffness=_range(section.bending),
        crease_stiffness=(stiffness_in_words(low), stiffness_in_words(high)),
        tie_stiffness=structure.tie_stiffness if np.isfinite(structure.tie_stiffness) else None,
        strength=structure.strength,
        crease_strength=structure.crease_strength,
        tie_strength=structure.tie_strength,
        supports=tuple(
            SupportReport(each.at, each.kind, each.friction) for each in structure.supports
        ),
    )


def _range(values: ArrayLike) -> tuple[float, float]:
    return float(np.min(values)), float(np.max(values))


def _governing(cases: tuple[CaseReport, ...]) -> GoverningReport | None:
    found = [
        GoverningReport(used.governs, case.name, case.creases, share)
        for case in cases
        if case.stands is not None
        and (used := case.stands.utilisation).governs is not None
        and (share := getattr(used, used.governs)) is not None
    ]
    return max(found, key=lambda each: each.utilisation, default=None)
