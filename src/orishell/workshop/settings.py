"""The table [workshop]: how a pattern is drawn for a machine, and on what it is cut."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal, Self, get_args

from pydantic import Field

from orishell.conventions.errors import InputError
from orishell.conventions.table import Knob, Number, Pair, Size, Table
from orishell.workshop.palettes import load_palette, palette_names

CreaseStyle = Literal["score", "dashes", "perforation"]
"""One continuous line; cuts with bridges between them; short cuts, as many as fit."""
Labels = Literal["none", "panels", "creases", "both"]
Joint = Literal["tabs", "strips"]
Paper = Literal["A4", "A3"]
Auto = Literal["auto"]
LEAST, MOST = 1e-12, 1e12
"""Numbers beyond these are refused: what is computed from them would overflow in the end."""
Length = Annotated[Number, Field(ge=LEAST, le=MOST)]
NoLength = Annotated[Size, Field(le=MOST)]


class Workshop(Table):
    """Settings for the workshop's files; lengths in the document's unit.

    What a key means stands beside it; ``"auto"`` follows the sheet or its panels.
    """

    palette: Annotated[
        str,
        Knob(
            "Palette",
            "Colours and line widths by which a machine tells layers apart",
            "choice",
            choices=palette_names(),
        ),
    ] = "plain"
    creases: Annotated[
        CreaseStyle,
        Knob(
            "Creases",
            "Scores are one line, dashes are cuts with bridges, perforations short cuts",
            "choice",
            choices=get_args(CreaseStyle),
        ),
    ] = "score"
    dash: Annotated[
        Length | Auto,
        Knob("Dash", "Length of a dash with the bridge after it", "number", True, "length"),
    ] = "auto"
    duty: Annotated[
        Number,
        Field(gt=0, lt=1),
        Knob("Cut share", "Share of a dash that is cut, between 0 and 1", "number", step=0.05),
    ] = 0.7
    corner_gap: Annotated[
        NoLength | Auto,
        Knob("Corner gap", "Length left uncut at both ends of a crease", "number", True, "length"),
    ] = "auto"
    relief_hole: Annotated[
        NoLength,
        Knob(
            "Relief hole",
            "Diameter of a hole at every inner vertex; 0 for none",
            "number",
            unit="length",
        ),
    ] = 0.0
    labels: Annotated[
        Labels,
        Knob(
            "Labels",
            "What is engraved: row and column of panels, fold angles of creases",
            "choice",
            choices=get_args(Labels),
        ),
    ] = "none"
    title_block: Annotated[
        bool, Knob("Title block", "Title and scale bar below the sheet", "switch")
    ] = True
    stock: Annotated[
        Pair[Length] | None,
        Knob(
            "Stock",
            "Width and height of the sheets to cut from; empty: one as large as needed",
            "size",
            unit="length",
        ),
    ] = None
    margin: Annotated[
        NoLength, Knob("Margin", "Rim of the stock that is not cut", "number", unit="length")
    ] = 0.0
    spacing: Annotated[
        NoLength, Knob("Spacing", "Least distance between parts", "number", unit="length")
    ] = 0.0
    joint: Annotated[
        Joint,
        Knob(
            "Joints",
            "Tabs on one of two parts, or strips glued under both",
            "choice",
            choices=get_args(Joint),
        ),
    ] = "tabs"
    joint_width: Annotated[
        Length | Auto,
        Knob("Joint width", "Width of tabs, or half that of strips", "number", True, "length"),
    ] = "auto"
    paper: Annotated[
        Paper, Knob("Paper", "Pages of the paper model", "choice", choices=get_args(Paper))
    ] = "A4"
    paper_scale: Annotated[
        Annotated[Number, Field(gt=0, le=1)] | Auto,
        Knob("Paper scale", "Size of the paper model relative to the sheet", "number", True),
    ] = "auto"
    model_scale: Annotated[
        Annotated[Number, Field(ge=LEAST, le=MOST)],
        Knob("Print scale", "Size of a printed model relative to the shell", "number"),
    ] = 1.0
    areal_density: Annotated[
        NoLength,
        Knob("Mass per area", "Of the sheet; 0 if not known", "number", unit="kg/m²"),
    ] = 0.0

    def beside(self, directory: Path | None) -> Self:
        """The settings with a palette of one's own found in a directory.

        Parameters
        ----------
        directory
            Where the file lies; None if no file may be read.

        Raises
        ------
        InputError
            If the palette is not one of ours, nor a file of one.
        """
        if not self.palette.endswith(".toml"):
            load_palette(self.palette)
            return self
        if directory is None:
            raise InputError(
                "files are not opened here",
                keys=("workshop.palette",),
                got=repr(self.palette),
                expected="one of " + ", ".join(palette_names()),
            )
        path = str(directory / self.palette)
        try:
            load_palette(path)
        except InputError as error:
            raise error.at_key("workshop.palette") from None
        return self.having(palette=path)


DEFAULT = Workshop()
