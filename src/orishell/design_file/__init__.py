"""The design file: TOML tables, checked, and the curves that they name."""

from orishell.design_file.file import DesignFile, check_design, read_design_file
from orishell.design_file.memory import require_memory
from orishell.design_file.starter import starter_file
from orishell.design_file.tables import read_workshop

__all__ = [
    "DesignFile",
    "check_design",
    "read_design_file",
    "read_workshop",
    "require_memory",
    "starter_file",
]
