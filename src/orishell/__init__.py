"""Deployable origami shells: from two curves to a crease pattern that folds and locks."""

from orishell.curves import Curve, curve_from_formulas, curve_from_points, parse_formula
from orishell.design import Design
from orishell.errors import DesignError, InputError, OrishellError
from orishell.families.longitudinal_linear_repeating import design_longitudinal_linear_repeating
from orishell.families.orthodiagonal import design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeating, design_parallel_repeating
from orishell.metrics import measure_residuals
from orishell.motion import FoldedState, FoldingMotion, Mechanism, measure_fold_angles
from orishell.notebook import show
from orishell.report import Shell, design_shell
from orishell.writing import convert_fold, write_shell

__all__ = [
    "Curve",
    "Design",
    "DesignError",
    "FoldedState",
    "FoldingMotion",
    "InputError",
    "Mechanism",
    "OrishellError",
    "ParallelRepeating",
    "Shell",
    "convert_fold",
    "curve_from_formulas",
    "curve_from_points",
    "design_longitudinal_linear_repeating",
    "design_orthodiagonal",
    "design_parallel_repeating",
    "design_shell",
    "measure_fold_angles",
    "measure_residuals",
    "parse_formula",
    "show",
    "write_shell",
]
