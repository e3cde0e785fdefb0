"""What only some constructions of panels have, asked for by other tables of a design file."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from orishell.conventions.errors import InputError
from orishell.conventions.meant import no_such
from orishell.conventions.quantities import MILLIMETRES, conversion
from orishell.deployment import Deployment
from orishell.design import PanelSpec
from orishell.design.stiffeners import Stiffeners
from orishell.families.tolerance import Tolerance
from orishell.structure.materials import materials
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


FROM_PACK = 3
"""Fewest states of a motion from the pack: it, the target and the flat sheet."""


def require_frames(frames: int, deployment: Deployment) -> None:
    """Refuse too few states for a motion from the pack."""
    if deployment.start == "pack" and frames < FROM_PACK:
        raise InputError(
            "too few states for a motion from the pack over the target to the flat sheet",
            keys=("motion.frames",),
            got=str(frames),
            expected=f"{FROM_PACK} to 1000",
            remedy=f"frames = {FROM_PACK}, or more",
        )


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
    board = structure.thickness if panel is None else panel.board
    if board is not None:
        _require_room(structure, board, ("structure.sandwich.face", "structure.material"))


def _require_room(structure: Structure, board: float, keys: tuple[str, ...]) -> None:
    faces = 0.0 if structure.sandwich is None else 2 * structure.sandwich.core.face
    if faces >= board:
        raise InputError(
            "faces leave no room for a core",
            keys=keys,
            got=f"twice {faces / 2:g} in boards of {board:g}",
            remedy="make boards thicker, or faces thinner",
        )


def require_both_sides(
    structure: Structure | None, asked: Stiffeners | None, panel: PanelSpec | None
) -> None:
    """Refuse loads on boards that are on one side of a membrane, and what stiffens them."""
    if panel is None or panel.sides == "both":
        return
    for key, there in (("structure", structure), ("stiffeners", asked)):
        if there is not None:
            raise InputError(
                "boards on one side of a membrane are no structure"
                if key == "structure"
                else "what stiffens a shell stands between boards on both sides of a membrane",
                keys=("panel.sides", key),
                got=f'"{panel.sides}"',
                expected='"both", of boards that are half as thick',
                remedy=f"remove one of both: sides, or [{key}]",
            )


def require_inner(given: bool, asked: Stiffeners | None) -> None:
    """Refuse a curve of a second skin where there is none, or where it is asked to be moved.

    given: Whether there is such a curve.

    Raises InputError if it has no place.
    """
    if not given:
        return
    if asked is None or asked.kind != "skin":
        raise InputError(
            "a curve of a second skin needs one",
            keys=("target.inner", "stiffeners.kind"),
            expected='kind = "skin" in [stiffeners]',
            remedy="add it, or remove [target.inner]",
        )
    if asked.gap != "auto":
        raise InputError(
            "a second skin follows a curve of its own, or is as far from the sheet as a gap",
            keys=("stiffeners.gap", "target.inner"),
            got=f"{asked.gap:g}, and [target.inner]",
            remedy="remove one of both",
        )


BOARDS: Final = (2e-5, 0.5)
"""How thick panels are, at least and at most (metres): from foil to boards of foam."""
USUAL: Final = (2e-4, 0.1)
"""How thick most are (metres): from card to sandwich boards."""


def require_meant_thickness(raw: Mapping[str, Any], path: Path) -> None:
    """Refuse panels that nobody makes as thick, where in another unit of length they are usual.

    raw: The tables of a design file, not checked yet.
    """
    shell, panel = raw.get("shell"), raw.get("panel")
    unit = shell.get("unit") if isinstance(shell, dict) else None
    thickness = panel.get("thickness") if isinstance(panel, dict) else None
    if unit not in MILLIMETRES or not isinstance(thickness, int | float) or thickness <= 0:
        return
    least, most = BOARDS
    if least < thickness * conversion(unit, "m") <= most:
        return
    for other in MILLIMETRES:
        if USUAL[0] <= thickness * conversion(other, "m") <= USUAL[1]:
            meant = f"{thickness * conversion(other, unit):.6g}"
            raise InputError(
                "panels are hardly as thick as that",
                file=path,
                keys=("panel.thickness",),
                got=f"{thickness:g} {unit}, the unit of this file",
                remedy=f"did you mean {thickness:g} {other}, which is thickness = {meant}?",
            )


def plates_of(
    asked: Stiffeners | None, structure: Structure | None, panel: PanelSpec | None, unit: str
) -> Stiffeners | None:
    """Plates that stiffen the shell: of a material of their own, if that is not the structure's.

    Raises InputError if there is no such material, it has no room for its core, or panels without a
    thickness have no boards beside which such plates stand.
    """
    if asked is None:
        return None
    name, keys = asked.material, ("stiffeners.thickness", "stiffeners.material")
    if name is not None and name not in materials():
        expected = "one of " + ", ".join(f'"{each}"' for each in materials())
        what = "there is no such material"
        raise no_such(what, name, materials(), keys=keys[1:], expected=expected)
    own = [key for key, each in zip(keys, (asked.thickness, name), strict=True) if each is not None]
    needed = [*own, *([] if asked.bolts is None else ["stiffeners.bolts"])]
    if needed and panel is None:
        raise InputError(
            "gussets have boards, and holes in them, only beside panels with a thickness",
            keys=(needed[0],),
            got="none",
            expected="a table [panel] with a thickness",
            remedy="add it, or remove the key",
        )
    if structure is not None and name == structure.material:
        asked = asked.replace_unchecked(material=None)
    if own and panel is not None and structure is not None:
        made = structure if asked.material is None else structure.made_of(asked.material, unit)
        _require_room(made, asked.made_of(panel, 0.0).board, (own[0], "structure.sandwich.face"))
    return asked


def plate_density(
    asked: Stiffeners | None,
    structure: StructureTable | None,
    panels: tuple[PanelSpec, PanelSpec | None],
    workshop: Workshop,
    unit: str,
) -> float:
    """Mass by volume (kg/m^3) of plates that have boards of their own; 0 if it is not known.

    panels: What panels are made of, as the file has it, and with the densities that it leaves open.
    """
    given, panel = panels
    if asked is None or panel is None:
        return 0.0
    metres, weighed = conversion(unit, "m"), given.density or workshop.areal_density
    name = asked.material or (None if weighed or structure is None else structure.material)
    if name is not None:
        return materials()[name].density_of(asked.made_of(panel, 0.0).thickness * metres)
    return panel.density or workshop.areal_density / (panel.thickness * metres)


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
