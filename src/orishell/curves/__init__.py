"""Planar curves: from formulas, from points, from files."""

from orishell.curves.curve import Curve, curve_from_formulas, curve_from_points
from orishell.curves.direction import run_along_axis
from orishell.curves.files import read_points
from orishell.curves.formula import Formula, parse_formula
from orishell.curves.trace import Trace, trace_curve

__all__ = [
    "Curve",
    "Formula",
    "Trace",
    "curve_from_formulas",
    "curve_from_points",
    "parse_formula",
    "read_points",
    "run_along_axis",
    "trace_curve",
]
