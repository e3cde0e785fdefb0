"""The table [workshop]: how the flat sheet is drawn and cut."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, ValidationError

from orishell.conventions.table import Number, Table
from orishell.conventions.toml_file import read_toml
from orishell.design_file.faults import explain
from orishell.errors import InputError
from orishell.workshop import Workshop
from orishell.workshop.palettes import load_palette, palette_names

Auto = Literal["auto"]
LEAST, MOST = 1e-12, 1e12
"""Numbers beyond these are refused: what is computed from them would overflow in the end."""
Length = Annotated[Number, Field(ge=LEAST, le=MOST)]
NoLength = Annotated[Number, Field(ge=0, le=MOST)]


class WorkshopTable(Table):
    """Keys of the table; their meaning is said in :class:`orishell.workshop.Workshop`."""

    palette: str = "plain"
    creases: Literal["score", "dashes", "perforation"] = "score"
    dash: Length | Auto = "auto"
    duty: Annotated[Number, Field(gt=0, lt=1)] = 0.7
    corner_gap: NoLength | Auto = "auto"
    relief_hole: NoLength = 0.0
    labels: Literal["none", "panels", "creases", "both"] = "none"
    title_block: bool = True
    stock: Annotated[list[Length], Field(min_length=2, max_length=2)] | None = None
    margin: NoLength = 0.0
    spacing: NoLength = 0.0
    joint: Literal["tabs", "strips"] = "tabs"
    joint_width: Length | Auto = "auto"
    paper: Literal["A4", "A3"] = "A4"
    paper_scale: Annotated[Number, Field(gt=0, le=1)] | Auto = "auto"
    model_scale: Annotated[Number, Field(ge=LEAST, le=MOST)] = 1.0
    areal_density: NoLength = 0.0

    def settings(self, directory: Path | None) -> Workshop:
        """The settings that the table asks for.

        Parameters
        ----------
        directory
            Where a palette of one's own is found; None if no file may be read.

        Raises
        ------
        InputError
            If the palette is not one of ours, nor a file of one.
        """
        values = self.model_dump()
        own = self.palette.endswith(".toml")
        if own and directory is None:
            raise InputError(
                "files are not opened here",
                where="[workshop] palette",
                got=repr(self.palette),
                expected="one of " + ", ".join(palette_names()),
            )
        if own and directory is not None:
            values["palette"] = str(directory / self.palette)
        try:
            load_palette(values["palette"])
        except InputError as error:
            raise (error.located("[workshop] palette") if own else error) from None
        if values["stock"] is not None:
            values["stock"] = tuple(values["stock"])
        return Workshop(**values)


def read_workshop(path: Path) -> Workshop:
    """The table [workshop] of a TOML file, which may hold others: a design file will do.

    Raises
    ------
    InputError
        Naming the file, the key, what was found and what is expected.
    """
    raw = read_toml(path, "workshop file")
    if "workshop" not in raw:
        raise InputError("this file has no table [workshop]", where=str(path))
    try:
        table = WorkshopTable.model_validate(raw["workshop"])
    except ValidationError as error:
        keys = list(WorkshopTable.model_fields)
        raise explain(path, raw, error, lambda _: keys, ("workshop",)) from None
    try:
        return table.settings(path.parent)
    except InputError as error:
        raise error.located(f"{path}:") from None
