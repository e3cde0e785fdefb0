"""Panels that are thick under loads and have no thickness where they fold: said, and mended.

``[structure] thickness`` is that of solid panels, for the analysis alone. Motion, contact, ties and
pack are then of panels without a thickness, which those that carry the loads do not have.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Final

from orishell.conventions.errors import Remedy, Value
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import size
from orishell.conventions.record import record
from orishell.conventions.row import Row
from orishell.design_file import DesignFile
from orishell.shell.facts import Facts
from orishell.shell.instead import first_that_does, trying

if TYPE_CHECKING:
    from orishell.shell.report import Report

GAP: Final = 0.2
"""Between boards that are tried, relative to their thickness: room for a hinge."""
MOST_PANELS: Final = 1_500
"""Boards of more panels are not tried."""


@record
class TwoThicknesses:
    """A thickness that only the structure has."""

    thickness: float  # of panels under loads (length)
    # values of keys with which panels have it where they fold, too, tried; empty if they cannot
    changes: Mapping[str, Any]


def find_two_thicknesses(
    file: DesignFile, progress: Progress, *, mended: bool
) -> TwoThicknesses | None:
    """The thickness that only the structure of a file has; None where there are no two.

    mended: Whether it is tried that panels have it where they fold, too.
    """
    if file.structure is None or file.panel is not None or file.structure.thickness is None:
        return None
    thickness = file.structure.thickness
    changes: dict[str, Value | None] = {
        "structure.thickness": None,
        "panel.thickness": thickness,
        "panel.construction": "bevel",  # solid panels, as they are analysed
        "panel.gap": rounded(GAP * thickness),
    }
    if mended and file.panel_count <= MOST_PANELS:
        work = trying(progress, "trying boards of the structure's thickness")
        if first_that_does(file, [Remedy(changes)], _reaches, work):
            return TwoThicknesses(thickness, changes)
    return TwoThicknesses(thickness, {})


def _reaches(made: Facts) -> bool:
    return made.found.lock.reaches_target is True


def thickness_rows(report: Report, two: TwoThicknesses | None) -> Iterator[Row]:
    """That what is said of the way is not of the panels that are analysed, where that is so.

    It fails where these cannot be: thicker than set-backs leave room for, or in the pack that is
    said, whose panels lie on each other.
    """
    if two is None:
        return
    thick, unit, deployment = two.thickness, report.unit, report.deployment
    said, packed, most = "", deployment.packed, deployment.largest_thickness
    fails = False
    if most is not None and thick > most:
        fails = True
        said += f"; set-backs leave room for {size(most, unit)} at most at the target"
    if packed is not None and deployment.start == "pack" and packed.layers > 1:
        stack = packed.layers * thick
        fails |= stack > packed.height
        said += f"; {packed.layers} of them on each other make {size(stack, unit)} at least"
    finding = (
        f"two thicknesses: the structure has panels {size(thick, unit)} thick, but folding, "
        f"contact and pack are of panels without a thickness{said}"
    )
    words = ""
    if two.changes:
        given = [(key.partition(".")[2], each) for key, each in two.changes.items() if each]
        keys = ", ".join(f"{key} = {json.dumps(each)}" for key, each in given)
        words = f"with {keys} in [panel], and no thickness in [structure], it folds (tried)"
    yield Row("fails" if fails else "warns", "boards", finding, words, two.changes)
