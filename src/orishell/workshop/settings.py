"""The table [workshop]: how a pattern is drawn for a machine, and on what it is cut."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal, Self

from pydantic import Field

from orishell.conventions.errors import InputError
from orishell.conventions.table import Knob, Number, Pair, Size, Table
from orishell.workshop.palettes import load_palette, palette_names

CreaseStyle = Literal["score", "dashes", "perforation"]
"""One continuous line; cuts with bridges between them; short cuts, as many as fit."""
Labels = Literal["none", "panels", "creases", "both"]
Joint = Literal["tabs", "strips"]
Paper = Literal["A4", "A3"]
Language = Literal["en", "de"]
Cutting = Literal["boards", "sheet"]
"""Boards cut apart, every corner with an error of its own; or creases drawn in one sheet, where a
vertex errs for all its panels alike."""
HingeKind = Literal["membrane", "piano hinge", "tape"]
"""What joins panels along a crease."""
Auto = Literal["auto"]
SMALLEST_NUMBER, LARGEST_NUMBER = 1e-12, 1e12
"""Numbers beyond these are refused: what is computed from them would overflow in the end."""
Length = Annotated[Number, Field(ge=SMALLEST_NUMBER, le=LARGEST_NUMBER)]
NoLength = Annotated[Size, Field(le=LARGEST_NUMBER)]


def _length(label: str, text: str) -> Knob:
    return Knob(label, text, "length")


def _price(label: str, text: str) -> Knob:
    return Knob(label, f"{text}, in any currency; 0 if not known", advanced=True)


class Workshop(Table):
    """Settings for the workshop's files; lengths in the document's unit.

    What a key means stands beside it; ``"auto"`` follows the sheet or its panels.
    """

    palette: Annotated[
        str,
        Knob(
            "Palette",
            "Colours and line widths by which a machine tells layers apart",
            choices=palette_names(),
        ),
    ] = "plain"
    creases: Annotated[
        CreaseStyle,
        Knob(
            "Creases", "Scores are one line, dashes are cuts with bridges, perforations short cuts"
        ),
    ] = "score"
    dash: Annotated[Length | Auto, _length("Dash", "Length of a dash with the bridge after it")] = (
        "auto"
    )
    duty: Annotated[
        Number,
        Field(gt=0, lt=1),
        Knob("Cut share", "Share of a dash that is cut, between 0 and 1", step=0.05),
    ] = 0.7
    corner_gap: Annotated[
        NoLength | Auto,
        _length("Corner gap", "Length left uncut at both ends of a crease"),
    ] = "auto"
    relief_hole: Annotated[
        NoLength, _length("Relief hole", "Diameter of a hole at every inner vertex; 0 for none")
    ] = 0.0
    labels: Annotated[
        Labels,
        Knob("Labels", "What is engraved: row and column of panels, fold angles of creases"),
    ] = "none"
    title_block: Annotated[bool, Knob("Title block", "Title and scale bar below the sheet")] = True
    stock: Annotated[
        Pair[Length] | None,
        Knob(
            "Stock",
            "Width and height of the sheets to cut from; empty: one as large as needed",
            "length",
        ),
    ] = None
    roll: Annotated[
        Pair[Length] | None,
        Knob(
            "Roll",
            "Width and length of the rolls of a membrane; empty: it is cut from stock",
            "length",
        ),
    ] = None
    hinge_stock: Annotated[
        Length | None, _length("Hinge stock", "Length of the bars that hinges are cut from")
    ] = None
    tie_stock: Annotated[
        Length | None, _length("Tie stock", "Length of the coils that ties are cut from")
    ] = None
    tie_end: Annotated[
        NoLength, _length("Tie ends", "Length that ties have beyond either end, to be fixed by")
    ] = 0.0
    row_hinge: Annotated[
        HingeKind | Auto,
        Knob("Row hinges", "What joins panels along row creases; auto: as they are built"),
    ] = "auto"
    column_hinge: Annotated[
        HingeKind | Auto,
        Knob("Column hinges", "What joins panels along column creases; auto: as they are built"),
    ] = "auto"
    stock_price: Annotated[NoLength, _price("Stock price", "Of one sheet of stock")] = 0.0
    roll_price: Annotated[NoLength, _price("Roll price", "Of one roll")] = 0.0
    hinge_price: Annotated[NoLength, _price("Hinge price", "Of one bar of hinge")] = 0.0
    tie_price: Annotated[NoLength, _price("Tie price", "Of one coil")] = 0.0
    hinge_linear_density: Annotated[
        NoLength,
        Knob(
            "Hinge mass",
            "Of hinges by their length, but of whole boards; 0 if not known",
            "kg/m",
        ),
    ] = 0.0
    tie_linear_density: Annotated[
        NoLength, Knob("Tie mass", "Of ties by their length; 0 if not known", "kg/m")
    ] = 0.0
    margin: Annotated[NoLength, _length("Margin", "Rim of stock and rolls that is not cut")] = 0.0
    spacing: Annotated[
        NoLength, _length("Spacing", "Least distance between parts, and the saw's cut in bars")
    ] = 0.0
    joint: Annotated[
        Joint, Knob("Joints", "Tabs on one of two parts, or strips glued under both")
    ] = "tabs"
    joint_width: Annotated[
        Length | Auto, _length("Joint width", "Width of tabs, or half that of strips")
    ] = "auto"
    paper: Annotated[Paper, Knob("Paper", "Pages of the paper model")] = "A4"
    paper_scale: Annotated[
        Annotated[Number, Field(gt=0, le=1)] | Auto,
        Knob("Paper scale", "Size of the paper model relative to the sheet"),
    ] = "auto"
    language: Annotated[Language, Knob("Language", "Of the booklet: English or German")] = "en"
    model_scale: Annotated[
        Length, Knob("Print scale", "Size of a printed model relative to the shell")
    ] = 1.0
    areal_density: Annotated[
        NoLength, Knob("Mass per area", "Of the sheet; 0 if not known", "kg/m²")
    ] = 0.0

    cutting_error: Annotated[
        NoLength,
        _length("Cutting error", "Standard deviation of corners, along each axis; 0: not asked"),
    ] = 0.0
    cutting_bias: Annotated[
        Annotated[Number, Field(ge=-LARGEST_NUMBER, le=LARGEST_NUMBER)],
        _length(
            "Cutting bias", "By how much every board is cut too small all around, as by a kerf"
        ),
    ] = 0.0
    cutting: Annotated[
        Cutting | Auto,
        Knob(
            "Cut as",
            "Boards err corner by corner, a sheet vertex by vertex; auto: boards have a thickness",
        ),
    ] = "auto"

    def beside(self, directory: Path | None) -> Self:
        """The settings with a palette of one's own found in a ``directory``, if files may be read.

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
        return self.replace_unchecked(palette=path)

    def for_membrane(self) -> Workshop:
        """The settings by which a membrane is laid out: rolls, where there are any, are stock."""
        return self if self.roll is None else self.replace_unchecked(stock=self.roll)

    @property
    def usable_stock(self) -> tuple[float, float]:
        """Width and height of the stock without its margins, where there is stock.

        Raises
        ------
        InputError
            If the margins leave nothing.
        """
        if self.stock is None:
            raise AssertionError("only stock has a margin")
        width, height = (side - 2 * self.margin for side in self.stock)
        if min(width, height) <= 0:
            raise InputError(
                "the margins leave nothing of the stock",
                keys=("workshop.margin",),
                got=f"{self.margin:g}",
                expected=f"less than {min(self.stock) / 2:g}",
            )
        return width, height


DEFAULT = Workshop()
