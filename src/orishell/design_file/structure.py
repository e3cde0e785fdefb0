"""What the tables [structure], [[load_case]] and [panel] ask of each other."""

from __future__ import annotations

from orishell.conventions.errors import InputError
from orishell.design import PanelSpec
from orishell.structure.settings import OWN_WEIGHT, LoadCase, Structure, StructureTable


def structure_of(
    table: StructureTable | None, cases: tuple[LoadCase, ...], panel: PanelSpec | None
) -> Structure | None:
    """The structure that a design file asks for; None without the table.

    Parameters
    ----------
    cases
        Its load cases; none for its own weight.
    panel
        What the table [panel] says.

    Raises
    ------
    InputError
        If load cases or the thickness of panels do not fit.
    """
    if table is None:
        if cases:
            raise InputError(
                "load cases need a structure that they load",
                where="[[load_case]]",
                remedy="add the table [structure], or remove the load cases",
            )
        return None
    _require_one_thickness(table, panel)
    _require_names(cases)
    return table.under(cases or (OWN_WEIGHT,))


def _require_names(cases: tuple[LoadCase, ...]) -> None:
    """Refuse two cases of one name, and combinations of what is not there or combines itself."""
    for number, case in enumerate(cases):
        if case.name in [each.name for each in cases[:number]]:
            raise InputError(
                "two load cases have one name",
                where=f"[[load_case]][{number}] name",
                got=repr(case.name),
            )
    loaded = [case.name for case in cases if not case.combine]
    for number, case in enumerate(cases):
        for name in case.combine:
            if name not in loaded:
                raise InputError(
                    "there is no such load case that has loads of its own",
                    where=f"[[load_case]][{number}] combine",
                    got=repr(name),
                    expected="one of " + ", ".join(map(repr, loaded)) if loaded else "",
                    remedy="" if loaded else "add the cases that are to be combined",
                )


def _require_one_thickness(table: StructureTable, panel: PanelSpec | None) -> None:
    if panel is None and table.thickness is None:
        raise InputError(
            "the thickness of panels is not known",
            where="[structure] thickness",
            remedy="write it here, or in [panel] if the motion is to leave room for it",
        )
    if panel is not None and table.thickness is not None:
        raise InputError(
            "panels have a thickness already",
            where="[structure] thickness",
            got=f"{table.thickness:g}, and {panel.thickness:g} in [panel]",
            remedy="remove it here",
        )
    if table.membrane_modulus and (panel is None or panel.construction != "sandwich"):
        raise InputError(
            "there is no membrane between boards",
            where="[structure] membrane_modulus",
            got=f"{table.membrane_modulus:g}",
            expected='a table [panel] with a thickness and construction = "sandwich"',
            remedy="remove it",
        )
