"""The design file."""

from orishell.spec.design_file import DesignFile, check_design, read_design_file, require_memory
from orishell.spec.families import FAMILIES, Pattern, starter_file
from orishell.spec.workshop import read_workshop

__all__ = [
    "FAMILIES",
    "DesignFile",
    "Pattern",
    "check_design",
    "read_design_file",
    "read_workshop",
    "require_memory",
    "starter_file",
]
