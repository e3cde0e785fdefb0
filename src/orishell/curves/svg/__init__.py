"""Curves drawn in SVG files."""

from orishell.curves.svg.read import read_svg

__all__ = ["read_svg"]
