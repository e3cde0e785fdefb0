"""A shell with some changes, and how near it is to carrying its loads."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design_file import DesignFile
from orishell.shell.carry_change import Change, together
from orishell.shell.carry_found import parts_on_site
from orishell.shell.facts import Facts
from orishell.structure.results import Analysis

GAIN = 0.95
"""A change stays that brings a shell to this share of what it uses, or nearer."""


@record
class State:
    """A shell with some changes, as analysed with few cells."""

    name: str  # the number of its trial
    changes: tuple[Change, ...]  # one after the other
    file: DesignFile
    facts: Facts
    analysis: Analysis

    @property
    def change(self) -> Change:
        """All that is changed."""
        return together(self.changes)

    @property
    def carries(self) -> bool:
        """Whether it carries all cases."""
        return self.analysis.carries is True

    @property
    def lacks(self) -> tuple[int, bool, float]:
        """How far it is from carrying, what counts most first.

        The cases under which it moves; whether something is not known; what its worst case uses.
        """
        used = [case.used for case in self.analysis.cases]
        known = [each for each in used if np.isfinite(each)]
        doubts = any(
            each.kind == "unknown" and each.excess is None
            for case in self.analysis.cases
            for each in case.findings
        )
        return len(used) - len(known), doubts, max(known, default=0.0)

    def is_nearer(self, other: State) -> bool:
        """Whether it is nearer to carrying than another one, by more than is worth a change."""
        *worse, used = self.lacks
        *before, most = other.lacks
        return worse < before or (worse == before and used <= GAIN * most)

    @property
    def weight(self) -> tuple[float, int]:
        """By which designs that carry are ranked: mass, then parts on the site."""
        return round(self.analysis.model.mass or 0.0, 3), parts_on_site(self.facts)
