"""What works instead: changes of a design file, each tried through all that can refuse it.

What is offered has been made: refusals, warnings and rows of the verdict try what they offer here.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

from orishell.conventions.errors import DesignError, InputError, Remedy, VerificationError
from orishell.conventions.progress import Progress
from orishell.design_file import DesignFile
from orishell.shell.facts import Facts, find_facts
from orishell.shell.open_questions import find_candidate
from orishell.shell.steps import MEASURES, Step, Work

REFUSALS = (DesignError, InputError, VerificationError)
"""How the trial of a change ends that does not work."""
REST: tuple[Step, ...] = (*MEASURES, "stock", "structure", "verification")
"""All that does not tell whether a shell reaches its target."""


def shell_of(file: DesignFile, work: Work) -> Facts:
    """What is found of the shell of a file.

    Raises InputError, DesignError or VerificationError as :func:`orishell.shell.make_shell` does.
    """
    return find_facts(find_candidate(file, work), work)


def trying(progress: Progress, what: str, skip: tuple[Step, ...] = REST) -> Work:
    """The work of trials, told as what they are for."""
    return Work(lambda share, _what: progress(share, what), skip=skip)


def first_that_does(
    file: DesignFile,
    remedies: Iterable[Remedy],
    does: Callable[[Facts], bool],
    work: Work,
    *,
    panels: float = math.inf,
    may: Callable[[DesignFile], bool] = lambda _: True,
) -> Remedy | None:
    """The first of some changes whose shell is made and does what is asked; None if none does.

    panels: They are tried until the shells have so many panels together.
    may: Whether the shell of a file may do it, told without a proof: else it is not made.
    """
    made = 0
    for each in remedies:
        try:
            changed = file.tried(each.changes)
            made += changed.panel_count
            if made > panels:
                return None
            if may(changed) and does(shell_of(changed, work)):
                return each
        except REFUSALS:
            continue
    return None
