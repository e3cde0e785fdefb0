"""The table [pattern] of drawn sheets, and how they are listed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from orishell.conventions.table import Knob, Number
from orishell.design import Design
from orishell.families.drawn.design import design_drawn
from orishell.families.pattern import Auto, Family, Pattern, RowCount, Width
from orishell.motion.drawing import Drawing


class DrawnPattern(Pattern):
    """What is asked of a drawn sheet; rows and columns are those of the drawing."""

    rows: RowCount
    columns: RowCount
    fold_deg: Annotated[
        Annotated[Number, Field(gt=0, le=180)] | Auto,
        Knob.angle("Fold", "Largest fold angle of the shell; as far as it goes", (5, 180), step=1),
    ] = 90.0
    move: Annotated[
        Width | Auto,
        Knob(
            "Move",
            "How far vertices may be moved so that the sheet folds exactly",
            "length",
        ),
    ] = "auto"
    flap: Literal[0] = 0  # a drawing has the panels that it has

    def design_drawn(self, drawing: Drawing) -> Design:
        """Design the shell of a drawing.

        Raises
        ------
        DesignError
            If it does not fold.
        """
        fold = None if self.fold_deg == "auto" else float(np.deg2rad(self.fold_deg))
        return design_drawn(drawing, fold=fold, move=None if self.move == "auto" else self.move)


FAMILY = Family(
    name="pattern",
    pattern=DrawnPattern,
    label="Drawn",
    what="A crease pattern of quadrilaterals from a file",
    starter=Path(__file__).with_name("starter.toml"),
    borders="a border",
)
