"""Planar curves: from formulas, from points, from drawings."""

from orishell.curves.curve import Curve, curve_from_formulas
from orishell.curves.dxf import read_dxf
from orishell.curves.formula import (
    Formula,
    FormulaOfTwo,
    parse_formula,
    parse_formula_of_two,
)
from orishell.curves.interpolation import curve_from_points
from orishell.curves.joining import Chain, run_along_axis
from orishell.curves.memo import remembered
from orishell.curves.points import read_points
from orishell.curves.svg import curve_data, parse_curve, read_svg
from orishell.curves.trace import Trace
from orishell.curves.trace import trace_curve as _trace_curve

trace_curve = remembered(_trace_curve)

__all__ = [
    "Chain",
    "Curve",
    "Formula",
    "FormulaOfTwo",
    "Trace",
    "curve_data",
    "curve_from_formulas",
    "curve_from_points",
    "parse_curve",
    "parse_formula",
    "parse_formula_of_two",
    "read_dxf",
    "read_points",
    "read_svg",
    "remembered",
    "run_along_axis",
    "trace_curve",
]
