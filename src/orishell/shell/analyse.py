"""A designed shell, analysed as a structure on request."""

from __future__ import annotations

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.design_file import DesignFile
from orishell.shell.make import Shell
from orishell.structure.analyse import analyse
from orishell.structure.results import Analysis
from orishell.structure.settings import Structure


def analyse_structure(
    shell: Shell, structure: Structure | None = None, progress: Progress = no_progress
) -> Analysis:
    """Analyse a designed shell as a structure at its target.

    Parameters
    ----------
    shell
        The shell.
    structure
        What holds and loads it; None for the tables of its design file.

    Raises
    ------
    InputError
        If this is no shell, there is no structure to analyse, supports or loads do not fit the
        sheet, or own weight is asked for and not known.
    """
    if not isinstance(shell, Shell):
        raise InputError(
            "only a shell is analysed as a structure",
            got=type(shell).__name__,
            expected="a Shell, which design_shell makes from a design file",
        )
    if not isinstance(structure, Structure | None):
        raise InputError(
            "this value does not fit",
            where="analyse_structure: structure",
            got=repr(structure)[:60],
            expected="a Structure",
        )
    structure = structure or shell.file.structure
    if structure is None:
        raise InputError(
            "there is no structure to analyse",
            file=shell.file.path,
            keys=("structure",),
            remedy="add the table [structure], or pass a Structure",
        )
    try:
        return analyse(shell.design, structure, shell.site, progress, built=shell.lock.built)
    except InputError as error:
        raise error.in_file(shell.file.path) from None


def require_structure(file: DesignFile) -> None:
    """Refuse a file that asks for no analysis.

    Raises InputError if it has no table [structure].
    """
    if file.structure is None:
        raise InputError(
            "there is no structure to analyse",
            file=file.path,
            keys=("structure",),
            remedy="add the table [structure]; orishell new writes a file that shows its keys",
        )
