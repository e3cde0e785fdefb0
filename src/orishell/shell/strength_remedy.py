"""Kinds of hinges and fixings, tried and offered where nobody knows what a shell has bears."""

from __future__ import annotations

from collections.abc import Mapping

from orishell.conventions.errors import Remedy
from orishell.conventions.progress import Progress
from orishell.design_file import DesignFile
from orishell.shell.carry_change import Change, Step, together
from orishell.shell.carry_steps import fixed_edges, named_lines
from orishell.shell.carry_strengths import free_hinges
from orishell.shell.load_trials import LoadTrials, Refused
from orishell.structure.results import Analysis
from orishell.structure.utilisation import Limiting

KINDS: Mapping[Limiting, Step] = {
    "lines": named_lines,
    "plate_edges": fixed_edges,
    "creases": free_hinges,
}
"""What has a kind of which all is known, by what bears nobody knows what."""


def find_known(file: DesignFile, analysis: Analysis, progress: Progress) -> Remedy | None:
    """Kinds with which it is known what bears the loads, tried with few cells; None without any."""
    unknown = _unknown(analysis)
    changes: dict[Limiting, Change] = {}
    for part, step in KINDS.items():
        if part in unknown and (change := next(step(file, analysis), None)) is not None:
            changes[part] = change
    if not changes:
        return None
    change = together(changes.values())
    made = LoadTrials(file, analysis, progress).made(change.values, change.words, quick=True)
    if isinstance(made, Refused) or made.analysis is None or _unknown(made.analysis) & {*changes}:
        return None
    return Remedy(
        change.values, f"with {change.words} it is known what these bear (tried with few cells)"
    )


def _unknown(analysis: Analysis) -> set[Limiting]:
    """What is loaded in some case, and what it bears is not given."""
    held = (case.equilibrium for case in analysis.cases)
    return {part for found in held if found is not None for part in found.unknown}
