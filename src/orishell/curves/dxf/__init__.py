"""Curves drawn in DXF files."""

from orishell.curves.dxf.read import read_dxf

__all__ = ["read_dxf"]
