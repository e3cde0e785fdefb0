"""How a pattern is drawn for a machine, and on what it is cut."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

CreaseStyle = Literal["score", "dashes", "perforation"]
Labels = Literal["none", "panels", "creases", "both"]
Joint = Literal["tabs", "strips"]
Paper = Literal["A4", "A3"]
Auto = Literal["auto"]


@dataclass(frozen=True, slots=True)
class Workshop:
    """Settings for the workshop's files; lengths in the document's unit.

    Parameters
    ----------
    palette
        Name of the shop's palette: colours and line widths of the layers.
    creases
        "score": one continuous line; "dashes": cuts with bridges between them; "perforation":
        short cuts, as many as fit.
    dash
        Length of a dash with the bridge after it; "auto" follows the sheet.
    duty
        Share of a dash that is cut, between 0 and 1.
    corner_gap
        Length left uncut at either end of a crease; "auto" is 0 for scores and half a bridge
        for dashes.
    relief_hole
        Diameter of a hole at every inner vertex; 0 for none. Creases end at its rim.
    labels
        What is engraved: row and column of panels, fold angles of creases.
    title_block
        Whether a title and a scale bar stand below the sheet.
    stock
        Width and height of the sheets that are cut; None for one sheet as large as needed.
    margin
        Width along the rim of the stock that is not cut into.
    spacing
        Least distance between parts on one sheet.
    joint
        How parts are joined: "tabs" on one of them, or separate "strips" glued under both.
    joint_width
        Width of tabs, or half the width of strips; "auto" follows the panels.
    paper
        Size of the paper that ``pattern.pdf`` is tiled over.
    paper_scale
        Size of the paper model relative to the sheet.
    model_scale
        Size of a printed model relative to the shell.
    areal_density
        Mass of the sheet in kilograms per square metre; 0 if not known.
    """

    palette: str = "plain"
    creases: CreaseStyle = "score"
    dash: float | Auto = "auto"
    duty: float = 0.7
    corner_gap: float | Auto = "auto"
    relief_hole: float = 0.0
    labels: Labels = "none"
    title_block: bool = True
    stock: tuple[float, float] | None = None
    margin: float = 0.0
    spacing: float = 0.0
    joint: Joint = "tabs"
    joint_width: float | Auto = "auto"
    paper: Paper = "A4"
    paper_scale: float | Auto = "auto"
    model_scale: float = 1.0
    areal_density: float = 0.0


DEFAULT = Workshop()
