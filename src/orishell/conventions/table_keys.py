"""Which keys and tables there are within a table, for messages about those that there are not."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel

from orishell.conventions.errors import as_toml
from orishell.conventions.record import record
from orishell.conventions.table import Table

Location = tuple[str | int, ...]
"""Keys and indices from the outermost table to the value."""
DEEPEST = 3
"""Tables within each other that are looked through for a key."""


@record
class TableKeys:
    """The keys of a table and of those within it."""

    root: type[BaseModel]  # the outermost table
    # tables by the keys of the root that they take the place of, as that of a family
    instead: Mapping[str, type[BaseModel]] = field(default_factory=dict)
    listed: tuple[str, ...] = ()  # keys of the root of which there may be several tables

    def beside(self, location: Location) -> tuple[str, ...]:
        """The keys that may stand beside the last one of a location."""
        return tuple(_fields(self._table(location)))

    def shown(self, location: Location, key: str) -> str:
        """How a message writes a key that stands where a location ends, a table in brackets."""
        if "." in key or (location[:1] == ("target",) and len(location) == 2):
            return f"[{key if '.' in key else f'target.{key}'}]"
        table = key in self.instead or next(_tables_in(self._annotation(key)), None)
        if len(location) != 1 or not table:
            return key
        return f"[[{key}]]" if key in self.listed else f"[{key}]"

    def elsewhere(self, key: str) -> tuple[str, ...]:
        """The first table of the design file in which such a key stands, in words; or none."""
        for name, table in self._all():
            if key in _fields(table):
                return (f"{key} in [{name}]",)
        return ()

    def choices(self, location: Location) -> tuple[str, ...]:
        """The texts that the value at a location may be, where it has to be one of some."""
        annotation = _fields(self._table(location)).get(str(location[-1]))
        listed = get_args(annotation) if get_origin(annotation) is Literal else ()
        return tuple(each for each in listed if isinstance(each, str))

    def example(self, location: Location, value: Any = None) -> str:
        """The table at a location as it may be written: within its line, or under its heading.

        value: What was written in its place, which the example takes where it may.
        """
        found = _fields(self._table(location)).get(str(location[-1]))
        table = next(_tables_in(found), None)
        if table is None or not issubclass(table, Table) or not table.SAMPLE:
            return ""
        sample = dict(table.SAMPLE)
        first = next(iter(sample))
        number = isinstance(sample[first], int | float)
        fits = isinstance(value, int | float) if number else isinstance(value, str)
        if fits and not isinstance(value, bool):
            sample[first] = value
        heading = ".".join(map(str, location))
        if len(location) == 1 or (location[0] == "target" and len(location) == 2):
            lines = [f"{key} = {as_toml(each)}" for key, each in sample.items()]
            return "\n".join(
                [f"[[{heading}]]" if heading in self.listed else f"[{heading}]", *lines]
            )
        text = as_toml(sample)
        return f"{location[-1]} = {f'[{text}]' if _is_list(found) else text}"

    def sample(self, location: Location) -> str:
        """A key as it may be written, where the table that has it shows one; else empty."""
        table = self._table(location)
        shown = table.SAMPLE if issubclass(table, Table) else {}
        key = str(location[-1])
        return f"{key} = {as_toml(shown[key])}" if key in shown else ""

    def _annotation(self, key: str) -> Any:
        return _fields(self.root).get(key)

    def _table(self, location: Location) -> type[BaseModel]:
        """The table that has the last key of a location."""
        table = self.root
        for key in location[:-1]:
            if table is self.root and key in self.instead:
                table = self.instead[str(key)]
            else:
                table = next(_tables_in(_fields(table).get(str(key))), table)
        return table

    def _all(self) -> Iterator[tuple[str, type[BaseModel]]]:
        """All tables by their dotted keys, outer ones first."""
        level: list[tuple[str, type[BaseModel]]] = [("", self.root)]
        for _ in range(DEEPEST):
            found: list[tuple[str, type[BaseModel]]] = []
            for name, table in level:
                for key, annotation in _fields(table).items():
                    inner = self.instead.get(key) if table is self.root else None
                    inner = inner or next(_tables_in(annotation), None)
                    if inner is not None:
                        found.append((f"{name}.{key}".lstrip("."), inner))
            yield from found
            level = found


def _fields(table: type[BaseModel]) -> dict[str, Any]:
    """What the keys of a table take, by their names in files."""
    return {each.alias or name: each.annotation for name, each in table.model_fields.items()}


def _tables_in(annotation: Any) -> Iterator[type[BaseModel]]:
    """The tables among the types that a value may have."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for each in get_args(annotation):
        yield from _tables_in(each)


def _is_list(annotation: Any) -> bool:
    """Whether a type is a list, or has one among its alternatives."""
    return get_origin(annotation) in (list, tuple) or any(map(_is_list, get_args(annotation)))
