"""Deployable origami shells: from two curves to a crease pattern that folds and locks."""

from typing import TYPE_CHECKING

from orishell.conventions.imports import import_on_demand

if TYPE_CHECKING:
    from orishell.conventions.errors import DesignError, InputError, OrishellError
    from orishell.conventions.version import __version__
    from orishell.curves import Curve, curve_from_formulas, curve_from_points, parse_formula
    from orishell.design import Design
    from orishell.design_file import DesignFile, check_design, read_design_file
    from orishell.families.flat_foldable import FlatFoldablePattern, design_flat_foldable
    from orishell.families.longitudinal_linear_repeating import (
        LongitudinalPattern,
        design_longitudinal_linear_repeating,
    )
    from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
    from orishell.families.parallel_repeating import (
        ParallelRepeating,
        ParallelRepeatingPattern,
        design_parallel_repeating,
    )
    from orishell.families.t_hedral import THedralPattern, design_t_hedral
    from orishell.motion import FoldedState, FoldingMotion, Mechanism, measure_fold_angles
    from orishell.shell.analyse import analyse_structure
    from orishell.shell.export import convert_fold, write_shell
    from orishell.shell.make import Shell, design_shell, make_shell
    from orishell.studio.notebook import show
    from orishell.verification.residuals import measure_residuals

__all__ = [
    "Curve",
    "Design",
    "DesignError",
    "DesignFile",
    "FlatFoldablePattern",
    "FoldedState",
    "FoldingMotion",
    "InputError",
    "LongitudinalPattern",
    "Mechanism",
    "OrishellError",
    "OrthodiagonalPattern",
    "ParallelRepeating",
    "ParallelRepeatingPattern",
    "Shell",
    "THedralPattern",
    "__version__",
    "analyse_structure",
    "check_design",
    "convert_fold",
    "curve_from_formulas",
    "curve_from_points",
    "design_flat_foldable",
    "design_longitudinal_linear_repeating",
    "design_orthodiagonal",
    "design_parallel_repeating",
    "design_shell",
    "design_t_hedral",
    "make_shell",
    "measure_fold_angles",
    "measure_residuals",
    "parse_formula",
    "read_design_file",
    "show",
    "write_shell",
]

# Imported when they are asked for: a command that needs no numpy does not wait for it.
_HOMES = {
    "orishell.conventions.version": ("__version__",),
    "orishell.curves": ("Curve", "curve_from_formulas", "curve_from_points", "parse_formula"),
    "orishell.design": ("Design",),
    "orishell.conventions.errors": ("DesignError", "InputError", "OrishellError"),
    "orishell.design_file": ("DesignFile", "check_design", "read_design_file"),
    "orishell.families.flat_foldable": ("FlatFoldablePattern", "design_flat_foldable"),
    "orishell.families.longitudinal_linear_repeating": (
        "LongitudinalPattern",
        "design_longitudinal_linear_repeating",
    ),
    "orishell.families.orthodiagonal": ("OrthodiagonalPattern", "design_orthodiagonal"),
    "orishell.families.parallel_repeating": (
        "ParallelRepeating",
        "ParallelRepeatingPattern",
        "design_parallel_repeating",
    ),
    "orishell.families.t_hedral": ("THedralPattern", "design_t_hedral"),
    "orishell.verification.residuals": ("measure_residuals",),
    "orishell.motion": ("FoldedState", "FoldingMotion", "Mechanism", "measure_fold_angles"),
    "orishell.studio.notebook": ("show",),
    "orishell.shell.make": ("Shell", "design_shell", "make_shell"),
    "orishell.shell.analyse": ("analyse_structure",),
    "orishell.shell.export": ("convert_fold", "write_shell"),
}

__getattr__, __dir__ = import_on_demand(__name__, _HOMES)
