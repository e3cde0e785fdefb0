"""Reading FOLD files, and writing shells in every format."""

from typing import TYPE_CHECKING

from orishell.conventions.imports import import_on_demand

if TYPE_CHECKING:
    from orishell.io.fold import write_fold
    from orishell.io.fold_document import document_of_fold
    from orishell.io.fold_reader import FoldFile, FoldFrame, read_fold
    from orishell.io.output import OutputDirectory
    from orishell.io.settings import DEFAULT_SETTINGS, Settings

__all__ = [
    "DEFAULT_SETTINGS",
    "FoldFile",
    "FoldFrame",
    "OutputDirectory",
    "Settings",
    "document_of_fold",
    "read_fold",
    "write_fold",
]

# Imported when they are asked for: whoever only lists the formats does not wait for numpy.
__getattr__, __dir__ = import_on_demand(
    __name__,
    {
        "orishell.io.fold": ("write_fold",),
        "orishell.io.fold_document": ("document_of_fold",),
        "orishell.io.fold_reader": ("FoldFile", "FoldFrame", "read_fold"),
        "orishell.io.output": ("OutputDirectory",),
        "orishell.io.settings": ("DEFAULT_SETTINGS", "Settings"),
    },
)
