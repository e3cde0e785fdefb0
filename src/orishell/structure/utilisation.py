"""What of a shell bears something, and how near it is to the end of what it can bear."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from orishell.conventions.record import record

Limiting = Literal[
    "panels",
    "panel_shear",
    "rolling_shear",
    "core_shear",
    "wrinkling",
    "membrane",
    "creases",
    "lines",
    "arms",
    "gussets",
    "boxes",
    "box_lines",
    "plate_edges",
    "ties",
    "rail",
    "buckling",
]
"""What may be at the end of what it bears."""
GOVERNING: Mapping[Limiting, str] = {
    "panels": "the stress in panels",
    "panel_shear": "shear of panels in their plane",
    "rolling_shear": "rolling shear in panels",
    "core_shear": "shear of the core in panels",
    "wrinkling": "wrinkling of faces of panels",
    "membrane": "the stress in the membrane between boards",
    "creases": "the moment of creases",
    "lines": "the force along a crease line",
    "arms": "the stress in the arms of hinges",
    "gussets": "the stress in gussets",
    "boxes": "the stress in box girders",
    "box_lines": "the force along a hinge of a box girder",
    "plate_edges": "the force along an edge of a gusset or plate",
    "ties": "the force in a tie",
    "rail": "the stress in the base rail",
    "buckling": "buckling",
}
"""What governs, in the words of terminal, page and studio."""
NAMED: Mapping[Limiting, str] = {
    "lines": "crease lines",
    "boxes": "box girders",
    "box_lines": "hinges of box girders",
    "plate_edges": "edges of gussets and plates",
    "rail": "base rail",
    "panel_shear": "panels against shear in their plane",
    "rolling_shear": "panels against rolling shear",
    "core_shear": "cores of panels in shear",
    "wrinkling": "faces of panels against wrinkling",
}
"""What bears, where its name is not the word for it."""
OF_SKIN: Mapping[Limiting, tuple[str, str]] = {
    "boxes": ("the stress in the second skin", "second skin"),
    "box_lines": ("the force along a hinge of the second skin", "hinges of the second skin"),
}
"""The words of both for what a sheet carries, where that is a second skin and its walls."""


def governing(part: Limiting, *, skin: bool) -> str:
    """What governs, in words; ``skin``: whether the sheet carries a second skin."""
    return OF_SKIN[part][0] if skin and part in OF_SKIN else GOVERNING[part]


def named(part: Limiting, *, skin: bool) -> str:
    """What bears, in words, likewise."""
    return OF_SKIN[part][1] if skin and part in OF_SKIN else NAMED.get(part, part)


NOT_EVERYWHERE: frozenset[Limiting] = frozenset(
    {"panel_shear", "rolling_shear", "core_shear", "wrinkling", "rail", "buckling"}
)
"""What is not known only where there is nothing of the kind."""
BY_DIRECTION: frozenset[Limiting] = frozenset({"lines", "box_lines", "plate_edges"})
"""What bears one direction otherwise than another: one may be known where another is not."""
LEAST_LINE = 100.0
"""Less is taken as borne by any crease line (N/m): a masking tape of coated paper is peeled off
steel by 330 and torn by 4370 (3M 226, product data sheet of March 1996, by ASTM D-3330 and
D-3759)."""


@record
class Utilisation:
    """Shares of what is borne, by what can be borne."""

    REPORTED = (*GOVERNING, "governs")

    # of their strength; None where that is not known
    panels: float | None
    # of boards with a grain, shear in the plane, which is in the first, too, and rolling of plies
    panel_shear: float | None
    rolling_shear: float | None
    # of boards with a core, shear of that, and the pressure at which faces wrinkle on it
    core_shear: float | None
    wrinkling: float | None
    membrane: float | None  # None, too, where panels have none
    creases: float | None  # of the moments that they bear
    lines: float | None  # of the forces that creases bear as crease lines
    arms: float | None  # None, too, where hinges have none
    gussets: float | None  # None, too, where there are none
    boxes: float | None  # likewise
    box_lines: float | None  # of the forces that their hinges bear as crease lines
    plate_edges: float | None  # of what edges of gussets and plates are held by
    ties: float | None
    rail: float | None  # None, too, without base rails
    buckling: float | None  # of the load at which the shell buckles; None if it does not

    @property
    def shares(self) -> dict[Limiting, float | None]:
        """All of them by name."""
        return {part: getattr(self, part) for part in GOVERNING}

    @property
    def governs(self) -> Limiting | None:
        """The largest of these; None if there is none."""
        known = [(share, part) for part, share in self.shares.items() if share]
        return max(known)[1] if known else None


def share_of(found: float, strength: float | None) -> float | None:
    """What is found, as a share of what is borne; None if that is not known."""
    return None if strength is None else found / strength
