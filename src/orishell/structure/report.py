"""The shell as a structure, in the report: forces in newtons, all else in the design's unit."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.design import PanelSpec
from orishell.motion.grid import Vertex
from orishell.structure.build_warnings import NOT_COVERED, warn_of_structure
from orishell.structure.case_report import CaseReport, Limiting, Stiffness
from orishell.structure.cases import describe_case, height_of, stiffness_in_words
from orishell.structure.results import Analysis
from orishell.structure.settings import Place, Structure, SupportKind


@record
class SupportReport:
    """What holds some vertices."""

    # the rows that are feet, the first and last columns, or vertices
    at: Place | tuple[Vertex, ...]
    kind: SupportKind  # how they are held
    friction: float  # coefficient of friction of the ground


@record
class ModelReport:
    """What is analysed."""

    # size of the mesh
    nodes: int
    triangles: int
    freedoms: int
    # by what share the largest displacement of a case changed when cells were halved for the last
    # time
    change: float
    mass: float  # of all panels (kg)
    height: float  # of the shell between its flaps
    thickness: float  # of panels
    # Young's modulus of panels or boards, their Poisson's ratio, and Young's modulus of the
    # membrane between boards (force per area)
    modulus: float
    poisson: float
    membrane_modulus: float
    # of the sections of panels, the least and the largest: force per length by strain, and moment
    # per length by curvature
    membrane_stiffness: tuple[float, float]
    bending_stiffness: tuple[float, float]
    # the least and the largest with which all is analysed
    crease_stiffness: tuple[Stiffness, Stiffness]
    tie_stiffness: float | None  # force by strain; None if ties do not stretch
    # what panels bear (force per area), creases (moment per length) and ties (force); None if it is
    # not known
    strength: float | None
    crease_strength: float | None
    tie_strength: float | None
    supports: tuple[SupportReport, ...]  # what holds the shell


@record
class GoverningReport:
    """What is nearest to the end of what it bears, of all cases."""

    part: Limiting  # what it is
    # the load case, and the stiffness of its creases
    case: str
    creases: Stiffness
    utilisation: float  # the share of what it bears


@record
class StructureReport:
    """The shell as a structure."""

    model: ModelReport  # what is analysed
    cases: tuple[CaseReport, ...]  # all load cases, those with the least stiffness of creases first
    # what is nearest to the end of what it bears; None if that of nothing is known
    governs: GoverningReport | None
    warnings: tuple[str, ...]  # sentences an engineer should read
    not_covered: tuple[str, ...]  # what the analysis says nothing of


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
