"""Files in and out: one file per format, one registry."""

from orishell.io.fold import write_fold
from orishell.io.fold_document import document_of_fold
from orishell.io.fold_reader import FoldFile, FoldFrame, read_fold
from orishell.io.output import OutputDirectory
from orishell.io.settings import DEFAULT_SETTINGS, LAST, Settings

__all__ = [
    "DEFAULT_SETTINGS",
    "LAST",
    "FoldFile",
    "FoldFrame",
    "OutputDirectory",
    "Settings",
    "document_of_fold",
    "read_fold",
    "write_fold",
]
