"""Which keys of a design file were asked for: what nothing asked for had no effect.

A table of a file notes by itself which of its keys are read (:class:`~orishell.conventions.table`),
so no list of keys has to be kept.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

PLACE = "_place"
"""Where a table has its place, beside the values of its keys."""


class Place:
    """Where the keys of a table stand in a file, and the keys that were asked for.

    Parameters
    ----------
    keys
        The dotted keys of the file by the table's own names; of those that the file gives.
    asked
        The dotted keys that were asked for; those that are asked for are added.
    """

    __slots__ = ("asked", "keys")

    def __init__(self, keys: Mapping[str, str], asked: set[str]) -> None:
        self.keys, self.asked = keys, asked

    def __eq__(self, other: object) -> bool:
        """Tables are equal if their values are, wherever they stand."""
        return isinstance(other, Place)

    def __hash__(self) -> int:
        """The same for all, as all are equal."""
        return hash(Place)

    def note(self, name: str) -> None:
        """Note that a value of the table is read."""
        key = self.keys.get(name)
        if key is not None:
            self.asked.add(key)

    def without(self, names: Collection[str]) -> Place:
        """The place of a table some of whose values are no longer those of the file."""
        kept = {name: key for name, key in self.keys.items() if name not in names}
        return Place(kept, self.asked)


class Asked:
    """The keys that a file gives, and those of them that were asked for."""

    __slots__ = ("asked", "given")

    def __init__(self) -> None:
        self.given: tuple[str, ...] = ()  # dotted keys, in the order of their tables
        self.asked: set[str] = set()

    def forgetting(self, table: str) -> Asked:
        """The keys, as if nothing had been asked for in a table.

        Parameters
        ----------
        table
            Its name.
        """
        other = Asked()
        other.given = self.given
        other.asked = {key for key in self.asked if key.partition(".")[0] != table}
        return other

    def unused(self, beside: Collection[str] = ()) -> tuple[str, ...]:
        """The keys that nothing has asked for, but those of some tables.

        Parameters
        ----------
        beside
            The tables, by their names.
        """
        return tuple(
            key
            for key in self.given
            if key not in self.asked and key.partition(".")[0] not in beside
        )
