"""What only some constructions of panels have, asked for by other tables of a design file."""

from __future__ import annotations

from orishell.conventions.errors import InputError
from orishell.design import PanelSpec
from orishell.families.tolerance import Tolerance
from orishell.structure.settings import Structure, StructureTable
from orishell.workshop import Workshop

ONLY_WITH = (
    (
        "sandwich",
        ("membrane_modulus", "membrane_strength"),
        "there is no membrane between boards",
    ),
    ("hinged", ("arm_modulus", "arm_strength"), "there are no arms that hinges stand on"),
)
"""Constructions, the keys of [structure] that go with them alone, and what others lack."""


def require_one_thickness(table: StructureTable, panel: PanelSpec | None) -> None:
    """Refuse a structure of panels without a thickness, or with two, and of what they lack."""
    if panel is None and table.thickness is None:
        raise InputError(
            "the thickness of panels is not known",
            keys=("structure.thickness",),
            remedy="write it here, or in [panel] if the motion is to leave room for it",
        )
    if panel is not None and table.thickness is not None:
        raise InputError(
            "panels have a thickness already",
            keys=("structure.thickness",),
            got=f"{table.thickness:g}, and {panel.thickness:g} in [panel]",
            remedy="remove it here",
        )
    for construction, keys, problem in ONLY_WITH:
        if panel is not None and panel.construction == construction:
            continue
        for key in keys:
            if value := getattr(table, key):
                raise InputError(
                    problem,
                    keys=(f"structure.{key}",),
                    got=f"{value:g}",
                    expected="a table [panel] with a thickness and construction = "
                    f'"{construction}"',
                    remedy="remove it",
                )


def require_a_core(structure: Structure, panel: PanelSpec | None) -> None:
    """Refuse boards that their faces fill, or more than that."""
    board = structure.thickness if panel is None else panel.thickness
    if panel is not None and not panel.is_solid:
        board = 0.5 * (panel.thickness - panel.membrane)
    faces = 0.0 if structure.sandwich is None else 2 * structure.sandwich.core.face
    if board is not None and faces >= board:
        raise InputError(
            "faces leave no room for a core",
            keys=("structure.sandwich.face", "structure.material"),
            got=f"twice {faces / 2:g} in boards of {board:g}",
            remedy="make boards thicker, or faces thinner",
        )


def require_one_hinge_density(panel: PanelSpec | None, workshop: Workshop) -> None:
    """Refuse a density of hinges in creases where these are of whole boards, beside them."""
    if workshop.hinge_linear_density and panel is not None and panel.construction == "hinged":
        raise InputError(
            "hinges of whole boards have their mass in [panel.hinge]",
            keys=("workshop.hinge_linear_density",),
            got=f"{workshop.hinge_linear_density:g}",
            remedy="write it there, as linear_density, and remove it here",
        )


def require_boards(tolerance: Tolerance | None, panel: PanelSpec | None) -> None:
    """Refuse a limit of boards, or of their chamfers, where panels have none."""
    if tolerance is None:
        return
    if tolerance.least_share and panel is None:
        raise InputError(
            "panels without a thickness have no boards",
            keys=("tolerance.least_share",),
            got=f"{tolerance.least_share:g}",
            expected="a table [panel] with a thickness",
            remedy="remove it",
        )
    steepest = tolerance.steepest_chamfer_deg
    if steepest is not None and (panel is None or panel.construction != "bevel"):
        raise InputError(
            "there are no chamfers",
            keys=("tolerance.steepest_chamfer_deg",),
            got=f"{steepest:g}",
            expected='a table [panel] with a thickness and construction = "bevel"',
            remedy="remove it",
        )
