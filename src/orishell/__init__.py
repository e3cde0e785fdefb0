"""Deployable origami shells: from two curves to a crease pattern that folds and locks."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from orishell._version import __version__

if TYPE_CHECKING:
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
    "__version__",
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

# Imported when they are asked for: a command that needs no numpy does not wait for it.
_HOMES = {
    "orishell.curves": ("Curve", "curve_from_formulas", "curve_from_points", "parse_formula"),
    "orishell.design": ("Design",),
    "orishell.errors": ("DesignError", "InputError", "OrishellError"),
    "orishell.families.longitudinal_linear_repeating": ("design_longitudinal_linear_repeating",),
    "orishell.families.orthodiagonal": ("design_orthodiagonal",),
    "orishell.families.parallel_repeating": ("ParallelRepeating", "design_parallel_repeating"),
    "orishell.metrics": ("measure_residuals",),
    "orishell.motion": ("FoldedState", "FoldingMotion", "Mechanism", "measure_fold_angles"),
    "orishell.notebook": ("show",),
    "orishell.report": ("Shell", "design_shell"),
    "orishell.writing": ("convert_fold", "write_shell"),
}


def __getattr__(name: str) -> Any:
    for home, names in _HOMES.items():
        if name in names:
            thing = globals()[name] = getattr(import_module(home), name)
            return thing
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
