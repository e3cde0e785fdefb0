"""Files out: one file per format, one registry."""

from orishell.io.fold import write_fold
from orishell.io.output import OutputDirectory

__all__ = ["OutputDirectory", "write_fold"]
