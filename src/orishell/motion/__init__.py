"""The folding sheet as a mechanism: its states from flat over the target to the pack."""

from orishell.motion.hinges import drive_at_fold, largest_fold
from orishell.motion.mechanism import (
    FoldedState,
    FoldingMotion,
    Mechanism,
    find_assignment,
    measure_fold_angles,
    mechanism_in_one_line,
    panel_normals,
)
from orishell.motion.resolution import RESOLUTION, require_resolution
from orishell.motion.sizes import corrugation_depth, diagonal, extents, sheet_area

__all__ = [
    "RESOLUTION",
    "FoldedState",
    "FoldingMotion",
    "Mechanism",
    "corrugation_depth",
    "diagonal",
    "drive_at_fold",
    "extents",
    "find_assignment",
    "largest_fold",
    "measure_fold_angles",
    "mechanism_in_one_line",
    "panel_normals",
    "require_resolution",
    "sheet_area",
]
