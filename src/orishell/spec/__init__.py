"""The design file."""

from orishell.spec.design_file import DesignFile, read_design_file
from orishell.spec.families import starter_file

__all__ = ["DesignFile", "read_design_file", "starter_file"]
