"""A change of a design file that may have its shell carry, and the steps that propose changes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import reduce
from operator import or_
from typing import Any

from orishell.conventions.errors import Remedy
from orishell.conventions.record import record
from orishell.design_file import DesignFile
from orishell.structure.results import Analysis


@record
class Change:
    """Other values at keys of a design file, and what that is in words."""

    values: Mapping[str, Any]
    # what is done, by the kind of change; nothing where another change did away with it
    said: Mapping[str, str]
    refused: str = ""  # why nobody need try it

    @property
    def words(self) -> str:
        """What is done, one change after the other."""
        return ", ".join(filter(None, self.said.values()))

    def __or__(self, other: Change) -> Change:
        """Both; what the other one changes again is said once, as it is then."""
        return Change({**self.values, **other.values}, {**self.said, **other.said})

    def fitted(self, offered: Remedy, unsaid: str = "") -> Change | None:
        """The change with what its refusal offers; None if that is of other tables.

        offered: Values that fit, by key.
        unsaid: A key whose value is not said beside what the change is in words.
        """
        tables = {key.rpartition(".")[0] for key in self.values}
        if any(key.rpartition(".")[0] not in tables for key in offered.changes):
            return None
        ((kind, words), *others) = self.said.items()
        if self.values.keys() <= offered.changes.keys():
            words = str(offered)
        elif unsaid in offered.changes:
            rest = {key: value for key, value in offered.changes.items() if key != unsaid}
            words = f"{words}, {Remedy(rest)}" if rest else words
        else:
            words = f"{words}, {offered}"
        return Change({**self.values, **offered.changes}, {kind: words, **dict(others)})


NOTHING = Change({}, {})


def together(changes: Iterable[Change]) -> Change:
    """Changes, one after the other."""
    return reduce(or_, changes, NOTHING)


Step = Callable[[DesignFile, Analysis], Iterator[Change]]
"""A kind of change, as it may be made to a file of which something was found."""
