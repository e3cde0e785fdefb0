"""Curves drawn in SVG files."""

from orishell.curves.svg.path_data import parse_curve
from orishell.curves.svg.read import read_svg
from orishell.curves.svg.write import curve_data

__all__ = ["curve_data", "parse_curve", "read_svg"]
