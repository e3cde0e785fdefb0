"""Sheets of few panels, fitted to surfaces of the benchmark and to a roof, a second each."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

from kept import kept

from orishell.design import Design
from orishell.design_file.surface import SurfaceTable
from orishell.families.flat_foldable.pattern import FlatFoldablePattern

EXAMPLES = Path(__file__).parents[1] / "examples"
SURFACES: dict[str, dict[str, Any]] = {
    **runpy.run_path(str(EXAMPLES / "surfaces.py"))["SURFACES"],
    "roof": {"mesh": "roof.obj", "unit": "mm"},
}


@kept
def fitted(surface: str, panels: int = 8) -> Design:
    """The design of so many panels each way on a surface of ``examples/surfaces.py``."""
    pattern = FlatFoldablePattern(rows=panels - 1, columns=panels - 1, direction_deg=0, fold_deg=92)
    return pattern.design_on(SurfaceTable.model_validate(SURFACES[surface]).surface(EXAMPLES, "m"))
