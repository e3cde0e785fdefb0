"""Which family makes a shell, where the design file leaves that open: all are tried."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.progress import Progress, stretch
from orishell.design_file import DesignFile
from orishell.families.registry import FAMILIES, TRIED
from orishell.motion import Mechanism, area_of
from orishell.motion.layout import Layout
from orishell.shell.candidate import Candidate
from orishell.shell.family_choice import FamilyChoice, FamilyTrial

FLAT = 1e-3
"""A crease whose fold angle is this near to none or to half a turn lies flat (radians)."""
REACHED = 1e-4
"""A motion that stops this share short of its end reaches it."""
RULE = (
    "the nearest of those that lock at the target; where none does, the nearest; "
    "one that is made in strips only where no other makes a shell"
)


def choose_family(
    file: DesignFile,
    progress: Progress,
    make: Callable[[DesignFile, Progress], Candidate],
    tell: Callable[[FamilyTrial], None] | None = None,
) -> Candidate:
    """The shell of the best family, whose answers say what each family makes of the target.

    All have the rows and columns, or the tolerance, of the file.

    Parameters
    ----------
    make
        Makes the shell of a file with a family, and measures how near it is.
    tell
        Is told what each family makes of it as soon as that is known.

    Raises
    ------
    DesignError
        If no family makes a shell: with the reasons of all.
    """
    best: tuple[FamilyTrial, Candidate] | None = None
    tried: list[FamilyTrial] = []
    for number, name in enumerate(TRIED):
        part = stretch(progress, number / len(TRIED), (number + 1) / len(TRIED))
        try:
            found = make(in_family(file, name), part)
        except DesignError as error:
            trial = FamilyTrial(name, why_not=_refusal(error))
        except InputError as error:
            trial = FamilyTrial(name, why_not=_fault(error))
        else:
            trial = _measured(found)
            if best is None or _rank(trial) < _rank(best[0]):
                best = trial, found
        tried.append(trial)
        if tell is not None:
            tell(trial)
    if best is None:
        raise DesignError(
            "no family makes a shell of this target",
            keys=("shell.family",),
            size="; ".join(f"{each.family}: {each.why_not}" for each in tried),
        )
    trial, found = best
    families = FamilyChoice(trial.family, RULE, tuple(tried))
    return replace(found, answers=replace(found.answers, families=families))


def _rank(trial: FamilyTrial) -> tuple[bool, bool, float]:
    """What is smallest in the best family: see RULE."""
    assert trial.distance is not None
    return trial.in_strips, not trial.locks, trial.distance


def in_family(file: DesignFile, name: str) -> DesignFile:
    """The file in a family, with what that family must be told left to it."""
    unasked = FAMILIES[name].pattern.unasked
    values = {f"pattern.{key}": value for key, value in unasked.items()}
    return file.changed({"shell.family": name, **values})


def _measured(found: Candidate) -> FamilyTrial:
    lock, mechanism = found.lock, found.design.mechanism
    assert found.deviation is not None
    assert found.deviation.surface is not None
    return FamilyTrial(
        family=found.file.family,
        distance=found.deviation.surface.max,
        panels=len(Layout.of(mechanism).faces),
        sheet_area=area_of(mechanism),
        packs_flat=packs_flat(mechanism, lock.closes_to),
        locks=found.deployment.closing is not None and found.freedom.one_motion,
        degrees_of_freedom=found.freedom.count,
        in_strips=FAMILIES[found.file.family].in_strips,
    )


def packs_flat(mechanism: Mechanism, end: float) -> bool:
    """Whether all creases are folded flat, or not at all, where a motion ends (radians)."""
    if end < mechanism.end_drive * (1 - REACHED):
        return False
    found = mechanism.fold_angles(mechanism.end_drive)
    angles = np.abs(np.concatenate([found.row.ravel(), found.column.ravel()]))
    return bool((np.minimum(angles, np.pi - angles) < FLAT).all())


def _refusal(error: DesignError) -> str:
    where = f", {error.place}" if error.place else ""
    return f"{error.condition}{where}" + (f": {error.size}" if error.size else "")


def _fault(error: InputError) -> str:
    facts = [("got", error.got), ("expected", error.expected)]
    said = ", ".join(f"{name} {text}" for name, text in facts if text)
    place = f"{error.where}: " if error.where else ""
    return f"{place}{error.what}" + (f"; {said}" if said else "")
