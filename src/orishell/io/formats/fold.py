"""FOLD: what is read and written in full (:mod:`orishell.io.fold`)."""

from orishell.io.fold import dump_fold
from orishell.io.format import Format

FORMAT = Format(
    "fold", "shell.fold", (".fold",), "pattern and motion (FOLD 1.2)", dump_fold, joined=True
)
