"""The folding sheet as a mechanism: its states from flat over the target to the pack."""

from orishell.motion.mechanism import (
    FoldedState,
    FoldingMotion,
    Mechanism,
    find_assignment,
    measure_fold_angles,
    mechanism_in_one_line,
    panel_normals,
)
from orishell.motion.sizes import (
    RESOLUTION,
    area_of,
    corrugation_depth,
    diagonal,
    drive_at_fold,
    extents,
    largest_fold,
    require_resolution,
    sheet_area,
)

__all__ = [
    "RESOLUTION",
    "FoldedState",
    "FoldingMotion",
    "Mechanism",
    "area_of",
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
