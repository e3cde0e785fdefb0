"""Files in and out: one file per format, one registry."""

from orishell.io.fold import write_fold
from orishell.io.fold_reader import FoldFile, FoldFrame, read_fold
from orishell.io.output import OutputDirectory

__all__ = ["FoldFile", "FoldFrame", "OutputDirectory", "read_fold", "write_fold"]
