"""A target that is scaled until the built shell has the sizes of ``[target.fit]``.

Factors are found with shells that nobody has proved, which takes little time; then the shell is
made as always, and measured. Where the proof has changed it (narrower flaps, boards that are cut
back), they are found anew. Sizes that are not asked for keep the target's own: factor 1.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.errors import ClashError
from orishell.conventions.progress import Progress
from orishell.design_file import DesignFile
from orishell.shell.candidate import Candidate
from orishell.shell.fit.report import FittedSize
from orishell.shell.fit.search import SizeFit
from orishell.shell.size_trials import Choice

ROUNDS = 4
"""Shells that are proved, one after the other, at most."""


def fit_size(
    file: DesignFile, prove: Callable[[DesignFile], Candidate], progress: Progress
) -> tuple[Candidate, Choice | None, FittedSize]:
    """The shell of a file with the sizes that it asks for, and how these were reached.

    With how rows and columns were chosen, if they were. ``prove`` makes the shell of a file whose
    target, rows and columns are known.

    Raises DesignError if there is none; says what sizes it can have. Otherwise as ``prove`` does.
    """
    assert file.fit is not None
    search = SizeFit(file, file.fit, progress)
    factors, choice = search.begin()
    # Of flaps that the proof has made narrower the width is kept, or their size would jump about.
    kept, aims = False, search.asked
    for left in reversed(range(ROUNDS)):
        try:
            made = prove(search.scaled(factors))
        except ClashError:
            if not kept or not left:
                raise
            search.begin_again({"pattern.flap": "auto"})
            kept = False
            continue
        found = search.sizes(made.design, made.lock)
        off = found - search.asked
        if np.abs(off).max() <= search.exact * (0.5 if left else 1.0):
            return made, choice, search.described(found, factors)
        if not left:
            break
        if search.base.pattern.flap == "auto" and made.design.flap:
            search.begin_again({"pattern.flap": made.design.flap})
            kept = True
        else:
            aims = aims - off
        factors = search.solved(factors, aims)
    raise search.refused(found)
