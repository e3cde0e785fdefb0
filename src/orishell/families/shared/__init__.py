"""What several families share: sheets of the paper's sections 2 and 3, candidates, staircases."""

from orishell.families.shared.sheets import (
    FlapSheet,
    column_fold_angle,
    row_fold_angle,
    target_drive,
)

__all__ = ["FlapSheet", "column_fold_angle", "row_fold_angle", "target_drive"]
