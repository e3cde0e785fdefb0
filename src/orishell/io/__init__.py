"""Reading FOLD files, and writing shells in every format."""

from typing import TYPE_CHECKING

from orishell.conventions.imports import import_on_demand

if TYPE_CHECKING:
    from orishell.io.fold import document_of_fold, write_fold
    from orishell.io.fold_content import FoldFrame
    from orishell.io.fold_reader import FoldFile, read_fold
    from orishell.io.format import DEFAULT_SETTINGS, Settings
    from orishell.io.output import OutputDirectory
    from orishell.io.patterns import PatternState, ReadPattern, read_pattern

__all__ = [
    "DEFAULT_SETTINGS",
    "FoldFile",
    "FoldFrame",
    "OutputDirectory",
    "PatternState",
    "ReadPattern",
    "Settings",
    "document_of_fold",
    "read_fold",
    "read_pattern",
    "write_fold",
]

# Imported when they are asked for: whoever only lists the formats does not wait for numpy.
__getattr__, __dir__ = import_on_demand(
    __name__,
    {
        "orishell.io.fold": ("document_of_fold", "write_fold"),
        "orishell.io.fold_content": ("FoldFrame",),
        "orishell.io.fold_reader": ("FoldFile", "read_fold"),
        "orishell.io.output": ("OutputDirectory",),
        "orishell.io.patterns": ("PatternState", "ReadPattern", "read_pattern"),
        "orishell.io.format": ("DEFAULT_SETTINGS", "Settings"),
    },
)
