"""The design file."""

from orishell.spec.design_file import DesignFile, read_design_file, require_memory
from orishell.spec.families import Pattern, starter_file

__all__ = ["DesignFile", "Pattern", "read_design_file", "require_memory", "starter_file"]
