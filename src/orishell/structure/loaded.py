"""A loaded shell as files and pages show it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.document.loaded import (
    LoadedCase,
    LoadedCreases,
    LoadedParts,
    LoadedShell,
)
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import SOLVED, largest_along_first
from orishell.structure.case import CaseResult
from orishell.structure.crease_forces import FORCES, worst_forces
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.mesh.edge_forces import crease_sides
from orishell.structure.model import Model
from orishell.structure.plates import stiffener_names

Named = Sequence[tuple[str, CaseResult]]
"""Cases, each with what it is called."""


def loaded_shell(model: Model, cases: Named) -> LoadedShell:
    """A model under its cases as files and pages show it."""
    section, facets = model.section, model.mesh.facets
    count = len(facets.triangles)
    return LoadedShell(
        points=facets.points,
        triangles=facets.triangles,
        panels=_numbered(model, model.mesh.panels),
        membrane=np.broadcast_to(np.asarray(section.membrane, np.float64), count),
        bending=np.broadcast_to(np.asarray(section.bending, np.float64), count),
        poisson=section.poisson,
        areal_mass=model.exposure.areal_mass,
        restrained=model.supports.as_if_pinned(),
        ties=model.nodes_of(model.site.ties),
        tie_stiffness=model.structure.tie_stiffness,
        whole_boards=model.design.has_whole_boards,
        parts=_parts(model),
        creases_turn=bool(np.isfinite(model.structure.crease_stiffness[0])),
        rails=bool(model.rails),
        cases=tuple(_loaded(name, case, model) for name, case in cases),
        creases=_creases(model, cases),
    )


def _numbered(model: Model, panels: Integers) -> Integers:
    """Numbers (...) of panels (...) of the model's grid, flaps counted."""
    row, column = np.divmod(panels, model.grid.columns - 1)
    return row * (model.design.mechanism.grid.columns - 1) + column + model.before


def _parts(model: Model) -> LoadedParts | None:
    """All that stiffens the sheet; None if nothing does."""
    if not model.plates:
        return None
    names, first = stiffener_names(model), model.design.mechanism.grid.panel_count
    counts, membrane, bending, mass = [], [], [], []
    for each, section, masses in zip(
        model.plates, model.stiffened.sections, model.plate_masses, strict=True
    ):
        own, shape = each.own, len(each.own.places)
        whole = np.bincount(own.panels, own.facets.areas())
        by_panel = masses.reshape(len(whole), -1).sum(axis=1) / whole
        counts.append(np.bincount(own.panels))
        membrane.append(np.broadcast_to(np.ravel(section.membrane), shape))
        bending.append(np.broadcast_to(np.ravel(section.bending), shape))
        mass.append(by_panel[own.panels])
    return LoadedParts(
        names=names,
        triangles=np.concatenate([each.triangles for each in model.plates]),
        panels=np.repeat(first + np.arange(len(names)), np.concatenate(counts)),
        membrane=np.concatenate(membrane),
        bending=np.concatenate(bending),
        poisson=model.stiffened.sections[0].poisson,
        areal_mass=np.concatenate(mass),
    )


def _creases(model: Model, cases: Named) -> LoadedCreases | None:
    """The largest force along every crease, of all cases in balance; None without such a case."""
    balanced = [(name, case.equilibrium) for name, case in cases if case.equilibrium is not None]
    if not balanced:
        return None
    sizes, worst = worst_forces(model, [found.edges for _, found in balanced])
    names = [name for name, _ in balanced]
    which = largest_along_first(sizes[:, : len(FORCES)].T, SOLVED)
    at = np.arange(len(which))
    there = sizes[at, which] > 0
    return LoadedCreases(
        panels=_numbered(model, crease_sides(model.grid)[1][..., 0]),
        sizes=sizes[at, which],
        what=tuple(FORCES[k] if one else "" for k, one in zip(which, there, strict=True)),
        cases=tuple(
            names[k] if one else "" for k, one in zip(worst[at, which], there, strict=True)
        ),
    )


def _loaded(name: str, case: CaseResult, model: Model) -> LoadedCase:
    found = case.equilibrium
    shown = case.motion or found
    assert shown is not None
    return LoadedCase(
        name=name,
        sign=case.sign,
        balanced=case.motion is None,
        forces=case.forces,
        displacements=shown.displacements,
        # Where large displacements are followed there is a factor, but no mode.
        buckling=()
        if found is None
        else tuple(zip(found.buckling_factors, found.buckling_modes, strict=False)),
        stresses=_stresses(model, found),
        strength=None if found is None else found.strength,
        parts_strength=None if found is None else found.plate_strength,
    )


def _stresses(model: Model, found: Equilibrium | None) -> Array:
    """Von Mises' stresses (T + S,) of panels and what stiffens them; 0 without balance."""
    if found is None:
        count = len(model.mesh.places) + sum(len(each.own.places) for each in model.plates)
        return np.zeros(count)
    on_parts = [each.von_mises() for each in found.in_plates]
    return np.asarray(np.concatenate([found.stresses, *on_parts]).max(axis=1))
