"""What pydantic finds wrong with tables and arguments, in our words."""

from __future__ import annotations

from collections.abc import Callable
from itertools import islice
from pathlib import Path
from typing import Any, TypedDict

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from orishell.conventions.errors import InputError
from orishell.conventions.meant import (
    meant,
    number_meant,
    plainly_meant,
    question,
    spelt_nearly,
    texts_in,
)
from orishell.conventions.table_keys import Location, TableKeys

UNKNOWN = "unknown key"
MOST_FAULTS = 20
"""So many faults are said, the others counted."""
NUMBERS = ("int_type", "float_type")
TABLES = ("model_type", "model_attributes_type", "dict_type")
LISTS = ("list_type", "tuple_type")
WHOLE = frozenset({"int_type", "int_from_float"})
_Found = tuple[Location, ErrorDetails]
"""What was found, and where within the value that has the fault."""


class Place(TypedDict, total=False):
    """Where a fault is, as :class:`~orishell.conventions.errors.InputError` takes it."""

    where: str
    keys: tuple[str, ...]
    file: Path


def first_fault(
    raw: dict[str, Any],
    error: ValidationError,
    place: Callable[[Location], Place],
    keys: TableKeys,
    inside: tuple[str, ...] = (),
    *,
    called: bool = False,
) -> InputError:
    """One message for the first fault; the others follow, a line each.

    ``keys`` are those of the outermost table, ``inside`` the keys of the one that pydantic looked
    at. What is ``called`` from Python expects classes by their names.
    """
    found = [
        (_key_path(raw, (*inside, *details["loc"]), details["type"]), details)
        for details in error.errors()
        if details["type"] != "default_factory_not_called"  # what it lacks is a fault itself
    ]
    places = {location for location, _ in found}
    faults: dict[Location, list[_Found]] = {}
    lacking: dict[Location, list[str]] = {}
    for location, details in found:
        # A value that fits none of several types has a fault, and others within it: they are one.
        whole = next(location[:k] for k in range(len(location) + 1) if location[:k] in places)
        if details["type"] == "missing":
            if "key" in (named := details.get("ctx", {})):
                whole = (*whole, str(named["key"]))
            lacking.setdefault(whole[:-1], []).append(str(whole[-1]))
            continue
        faults.setdefault(whole, []).append((location[len(whole) :], details))
    said = _Words(raw, place, keys, CALLED if called else {})
    errors = [
        said.unknown(location, lacking.get(location[:-1], []))
        if group[0][1]["type"] == "extra_forbidden"
        else said.misfit(location, group, lacking.get(location[:-1], []))
        for location, group in islice(faults.items(), MOST_FAULTS)
    ]
    # What a table lacks is one fault, and comes after what may stand in its place.
    errors += [said.missing(table, names) for table, names in lacking.items() if names]
    listed: set[str] = set()
    for each in errors:
        # The keys of a table are listed once.
        if each.what == UNKNOWN and each.expected in listed:
            each.expected = ""
        listed.add(each.expected)
    first, *others = errors
    more = len(faults) - MOST_FAULTS
    lines = [first.detail, *map(str, others), f"and {more} more" if more > 0 else ""]
    first.detail = "\n".join(filter(None, lines))
    return first


def _key_path(raw: dict[str, Any], location: Location, kind: str) -> Location:
    """The part of a location that is in the file, and what is missing there.

    What else a location has names alternatives of a type.
    """
    value: Any = raw
    found: list[str | int] = []
    for key in location:
        try:
            value = value[key]
        except (KeyError, IndexError, TypeError):
            continue
        found.append(key)
    there = tuple(found) == location  # what lacks something, of which the details say what
    return (*found, location[-1]) if kind == "missing" and not there else tuple(found)


class _Words:
    """Words for faults; ``own`` are those for what is expected, before those of files."""

    def __init__(
        self,
        raw: dict[str, Any],
        place: Callable[[Location], Place],
        keys: TableKeys,
        own: dict[str, str],
    ) -> None:
        self.place, self.keys, self.own = place, keys, own
        shell = raw.get("shell")
        unit = shell.get("unit") if isinstance(shell, dict) else None
        self.unit = unit if isinstance(unit, str) else ""

    def unknown(self, location: Location, lacking: list[str]) -> InputError:
        """A key that there is not; one of those that are ``lacking`` there, if it is meant."""
        word, beside = str(location[-1]), self.keys.beside(location)
        found = (
            plainly_meant(word, lacking)
            or plainly_meant(word, beside)
            or self.keys.elsewhere(word)
            or spelt_nearly(word, lacking)
            or spelt_nearly(word, beside)
        )
        if len(found) == 1 and found[0] in lacking:
            lacking.remove(found[0])
        asked = question([self.keys.shown(location, each) for each in found])
        return InputError(
            UNKNOWN,
            **self.place(location),
            expected="one of " + ", ".join(beside) if beside else "",
            remedy=asked or "remove it",
        )

    def missing(self, table: Location, names: list[str]) -> InputError:
        """The keys that one table lacks."""
        location = (*table, names[0])
        found = self.place((*table, ", ".join(names)))
        if "keys" in found:
            named = (self.place((*table, name))["keys"] for name in names)
            found["keys"] = tuple(key for keys in named for key in keys)
        one = len(names) == 1
        choices = self.keys.choices(location) if one else ()
        examples = [self.keys.example((*table, name)) for name in names]
        shown = "\n".join(examples) if all(examples) else ""
        return InputError(
            "this key is missing" if one else "these keys are missing",
            **found,
            expected=" or ".join(filter(None, [", ".join(choices[:-1]), *choices[-1:]])),
            remedy=f"add {self.keys.sample(location) or names[0]}" if one and not shown else "",
            detail=_indented(f"for instance\n{shown}") if shown else "",
        )

    def misfit(self, location: Location, group: list[_Found], lacking: list[str]) -> InputError:
        """A value that is not what it should be; or is meant for a key that is ``lacking``."""
        _, details = group[0]
        context = details.get("ctx", {})
        if "key" in context:
            location = (*location, str(context["key"]))
        place, kind = self.place(location), details["type"]
        if kind == "source":
            return InputError(details["msg"], got=str(context.get("found", "")), **place)
        got = context.get("got", details["input"])
        expected = [_expected(each, self.own, within) for within, each in group]
        kinds = [each["type"] for within, each in group if not within]
        remedy = self._remedy(location, kinds, got)
        other = plainly_meant(str(location[-1]), lacking) if location else ()
        if len(other) == 1:
            lacking.remove(other[0])
            remedy = question(other)
        shown = (
            "" if remedy or not {*kinds} & {*TABLES, *LISTS} else self.keys.example(location, got)
        )
        if shown and "\n" not in shown:
            remedy, shown = f"write {shown}", ""
        if not remedy and isinstance(got, str):
            choices = [*context.get("choices", ()), *texts_in(expected)]
            remedy = question([f'"{each}"' for each in meant(got, choices)])
        return InputError(
            "this value does not fit",
            got=_shown(got),
            expected=" or ".join(dict.fromkeys(expected)),
            remedy=remedy,
            whole=not WHOLE.isdisjoint(kinds),
            detail=_indented(f"for instance\n{shown}") if shown else "",
            **place,
        )

    def _remedy(self, location: Location, kinds: list[str], got: Any) -> str:
        """What to write, where a number is a text or has a comma, or a list is one table."""
        if isinstance(got, dict) and not {*LISTS}.isdisjoint(kinds):
            return "write the table's name in double brackets, [[...]]: there may be several of it"
        if isinstance(got, list) and kinds[:1] == ["model_type"] and len(location) == 1:
            return f"write [{location[0]}] in single brackets: there is one of it"
        if isinstance(got, str) and not {*NUMBERS}.isdisjoint(kinds):
            return number_meant(got, str(location[-1]) if location else "", self.unit)
        if isinstance(got, str) and kinds == ["bool_type"]:
            meaning = {"true": "true", "yes": "true", "false": "false", "no": "false"}
            return f"write {meaning.get(got.casefold(), 'true or false')}, without quotes"
        if "too_long" in kinds and isinstance(got, list) and all(type(each) is int for each in got):
            return "numbers have a decimal point, as in 0.5: a comma separates entries"
        return ""


def _indented(text: str) -> str:
    return "\n".join(f"    {line}" for line in text.split("\n"))


_EXPECTED = {
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "float_type": "a number",
    "finite_number": "a finite number",
    "string_type": "a text",
    "bool_type": "true or false",
    "list_type": "a list, in brackets",
    "tuple_type": "a list, in brackets",
    "dict_type": "a table",
    "model_type": "a table",
    "model_attributes_type": "a table",
    "greater_than": "a value greater than {gt:g}",
    "greater_than_equal": "a value of at least {ge:g}",
    "less_than": "a value less than {lt:g}",
    "less_than_equal": "a value of at most {le:g}",
    "too_short": "{min_length} entries",
    "too_long": "{max_length} entries",
    "literal_error": "{expected}",
    "dataclass_exact_type": "a {class_name}",
    "is_instance_of": "a {class}",
    "sequence_str": "a list, in brackets",
    "callable_type": "a function",
    "path_type": "a path",
}
CALLED = {"model_type": "an instance of {class_name}, or a dictionary of its keys"}
"""What is expected of arguments in other words than of keys in files."""


def _expected(details: ErrorDetails, own: dict[str, str], within: Location) -> str:
    """What is expected; of an entry of a list that has other words in its place, of which list."""
    text = (_EXPECTED | own).get(details["type"])
    said = text.format(**details.get("ctx", {})) if text else details["msg"]
    return f"a list, each entry {said}" if within and isinstance(within[0], int) else said


def _shown(value: Any) -> str:
    text = repr(list(value) if isinstance(value, tuple) else value)
    return text if len(text) <= 60 else text[:57] + "..."
