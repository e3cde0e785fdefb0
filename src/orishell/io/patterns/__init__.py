"""Crease patterns in files of other programs: FOLD, SVG and DXF."""
