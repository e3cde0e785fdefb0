"""A designed shell as a structure: analysed, and as its files and pages show it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.deployment import Site
from orishell.design import Design
from orishell.document import LoadedCase, LoadedShell
from orishell.locking import Lock
from orishell.structure.analyse import analyse
from orishell.structure.build_warnings import name_of
from orishell.structure.model import Frame
from orishell.structure.report import StructureReport, describe_structure
from orishell.structure.results import Analysis, CaseResult
from orishell.structure.settings import Structure

if TYPE_CHECKING:
    from orishell.shell.make import Shell


@record
class Loaded:
    """A shell as a structure."""

    analysis: Analysis  # what was found
    report: StructureReport  # the same as the report says it
    drawn: LoadedShell  # the same as files and pages show it


def analyse_structure(
    shell: Shell, structure: Structure | None = None, progress: Progress = no_progress
) -> Analysis:
    """Analyse a designed shell as a structure at its target.

    Parameters
    ----------
    shell
        The shell.
    structure
        What holds and loads it; None for the tables of its design file.

    Raises
    ------
    InputError
        If this is no shell, there is no structure to analyse, supports or loads do not fit the
        sheet, or own weight is asked for and not known.
    """
    from orishell.shell.make import Shell

    if not isinstance(shell, Shell):
        raise InputError(
            "only a shell is analysed as a structure",
            got=type(shell).__name__,
            expected="a Shell, which design_shell makes from a design file",
        )
    if not isinstance(structure, Structure | None):
        raise InputError(
            "this value does not fit",
            where="analyse_structure: structure",
            got=repr(structure)[:60],
            expected="a Structure",
        )
    structure = structure or shell.file.structure
    if structure is None:
        raise InputError(
            "there is no structure to analyse",
            where=f"{shell.file.path}: [structure]",
            remedy="add the table [structure], or pass a Structure",
        )
    try:
        return analyse(shell.design, structure, _frame(shell.site, shell.lock), progress)
    except InputError as error:
        raise error.located(f"{shell.file.path}:") from None


def load_shell(
    design: Design, lock: Lock, site: Site, structure: Structure, progress: Progress
) -> Loaded:
    """Analyse a design as a structure, and say what was found.

    Raises InputError: As :func:`analyse_structure` does.
    """
    analysis = analyse(design, structure, _frame(site, lock), progress)
    report = describe_structure(structure, analysis, design.panel)
    return Loaded(analysis, report, _drawn(structure, analysis, report))


def _frame(site: Site, lock: Lock) -> Frame:
    return Frame(
        unit=site.unit,
        feet=None if site.feet is None else site.feet.rows,
        ties=site.ties,
        areal_mass=site.areal_density * site.metres**2,
        built=lock.built,
    )


def _drawn(structure: Structure, analysis: Analysis, report: StructureReport) -> LoadedShell:
    mesh, section, grid = analysis.mesh, analysis.section, analysis.grid
    count = len(mesh.facets.triangles)
    ties = [
        [row * grid.columns + column - analysis.before for row, column in each]
        for each in analysis.ties
    ]
    return LoadedShell(
        points=mesh.facets.points,
        triangles=mesh.facets.triangles,
        panels=mesh.panels,
        membrane=np.broadcast_to(np.asarray(section.membrane, np.float64), count),
        bending=np.broadcast_to(np.asarray(section.bending, np.float64), count),
        poisson=section.poisson,
        areal_mass=analysis.exposure.areal_mass,
        held=analysis.held,
        ties=np.array(ties, np.int64).reshape(-1, 2),
        tie_stiffness=structure.tie_stiffness,
        cases=tuple(
            _case(found, name_of(described, report.cases))
            for found, described in zip(analysis.cases, report.cases, strict=True)
        ),
    )


def _case(found: CaseResult, name: str) -> LoadedCase:
    moves = found.motion
    stresses = found.stresses.max(axis=1)
    return LoadedCase(
        name=name,
        stands=moves is None,
        forces=found.loads,
        displacements=found.displacements if moves is None else moves.displacements,
        stresses=stresses if moves is None else np.zeros_like(stresses),
    )
