"""Arguments of public functions, checked by type; what pydantic finds wrong, in our words."""

from __future__ import annotations

import difflib
import inspect
import re
from collections.abc import Callable
from functools import cache, wraps
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, TypeVar, cast, get_type_hints

import numpy as np
from pydantic import BaseModel, ConfigDict, ValidationError, create_model
from pydantic_core import ErrorDetails

from orishell.conventions.errors import InputError

if TYPE_CHECKING:  # pydantic gives it no public name
    from pydantic._internal._model_construction import ModelMetaclass as Metaclass
else:
    Metaclass = type(BaseModel)

UNKNOWN = "unknown key"
MOST_FAULTS = 20
"""So many faults are said, the others counted."""
NUMBER = re.compile(r"[+-]?\d{1,20}(?:[.,]\d{0,20})?")
NUMBERS = ("int_type", "float_type")
WHOLE = frozenset({"int_type", "int_from_float"})
Location = tuple[str | int, ...]
"""Keys and indices from the outermost table to the value."""
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
    keys: Callable[[Location], list[str]],
    inside: tuple[str, ...] = (),
    *,
    called: bool = False,
) -> InputError:
    """One message for the first fault; the others follow, a line each.

    ``keys`` are those that may stand beside the last one of a location, ``inside`` those of the
    table that pydantic looked at. What is ``called`` from Python expects classes by their names.
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
            table = whole[:-1]
            lacking.setdefault(table, []).append(str(whole[-1]))
            if len(lacking[table]) > 1:
                continue  # the keys that one table lacks are one fault
        faults.setdefault(whole, []).append((location[len(whole) :], details))
    first, *others = [
        _missing(location, lacking[location[:-1]], place)
        if group[0][1]["type"] == "missing"
        else _fault(location, group, place, keys, CALLED if called else {})
        for location, group in islice(faults.items(), MOST_FAULTS)
    ]
    listed: set[str] = set()
    for each in (first, *others):
        # The keys of a table are listed once.
        if each.what == UNKNOWN and each.expected in listed:
            each.expected = ""
        listed.add(each.expected)
    more = len(faults) - MOST_FAULTS
    lines = [*map(str, others), *([f"and {more} more"] if more > 0 else [])]
    first.detail = "\n".join(lines)
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


def _missing(
    location: Location, names: list[str], place: Callable[[Location], Place]
) -> InputError:
    """The message about keys that one table lacks, the first of them at a location."""
    table = location[:-1]
    found = place((*table, ", ".join(names)))
    if "keys" in found:
        found["keys"] = tuple(key for name in names for key in place((*table, name))["keys"])
    what = "this key is missing" if len(names) == 1 else "these keys are missing"
    return InputError(what, **found)


def _fault(
    location: Location,
    group: list[_Found],
    place: Callable[[Location], Place],
    keys: Callable[[Location], list[str]],
    own: dict[str, str],
) -> InputError:
    """The message of a fault; ``own`` are words for what is expected, before those of files."""
    _, details = group[0]
    context = details.get("ctx", {})
    if "key" in context:
        location = (*location, str(context["key"]))
    found = place(location)
    kind = details["type"]
    if kind == "extra_forbidden":
        close = difflib.get_close_matches(str(location[-1]), keys(location), n=1)
        return InputError(
            UNKNOWN,
            **found,
            expected="one of " + ", ".join(keys(location)),
            remedy=f"write {close[0]}, if that is what was meant" if close else "remove it",
        )
    if kind == "source":
        return InputError(details["msg"], got=str(context.get("found", "")), **found)
    got = context.get("got", details["input"])
    expected = " or ".join(dict.fromkeys(_expected(each, own, within) for within, each in group))
    return InputError(
        "this value does not fit",
        got=_shown(got),
        expected=expected,
        remedy=_remedy(kind, got),
        whole=not WHOLE.isdisjoint(each["type"] for within, each in group if not within),
        **found,
    )


def _remedy(kind: str, got: Any) -> str:
    """What to write, where a number is a text or has a decimal comma, or a list is one table."""
    if kind in ("list_type", "tuple_type") and isinstance(got, dict):
        return "write the table's name in double brackets, [[...]]: there may be several of it"
    if isinstance(got, str) and kind in NUMBERS and NUMBER.fullmatch(got):
        return f"write {got.replace(',', '.')} without quotes"
    if kind == "too_long" and isinstance(got, list) and all(type(each) is int for each in got):
        return "numbers have a decimal point, as in 0.5: a comma separates entries"
    return ""


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


F = TypeVar("F", bound=Callable[..., Any])


def checked() -> Callable[[F], F]:
    """Have a function's arguments checked against the types in its signature before it runs.

    Numbers and arrays of numpy's are taken as numbers and lists. A fault is an
    :class:`~orishell.conventions.errors.InputError` that names the function and the argument.
    """

    def decorate(function: F) -> F:
        signature = inspect.signature(function)
        model = cache(lambda: _model(function, signature))

        @wraps(function)
        def call(*args: Any, **kwargs: Any) -> Any:
            try:
                given = signature.bind(*args, **kwargs).arguments
            except TypeError as error:
                raise TypeError(f"{function.__name__}() {error}") from None
            raw = {name: _plain(value) for name, value in given.items()}
            try:
                found = model().model_validate(raw)
            except ValidationError as error:
                raise _of_call(function.__name__, raw, error) from None
            return function(**{name: getattr(found, name) for name in given})

        return cast("F", call)

    return decorate


def _of_call(name: str, raw: dict[str, Any], error: ValidationError, *keys: str) -> InputError:
    """The first fault of what a function or a class was called with; ``keys`` that it takes."""

    def place(location: Location) -> Place:
        key, *index = location or ("",)
        return {"where": f"{name}: {key}" + "".join(f"[{each}]" for each in index)}

    return first_fault(raw, error, place, lambda _: list(keys), called=True)


class Called(Metaclass):
    """Makes tables that are called like functions: what is wrong is said as of arguments.

    Numbers and arrays of numpy's are taken as numbers and lists, and tuples as lists.
    """

    def __call__(self, *args: Any, **values: Any) -> Any:
        """A table of these values.

        Raises
        ------
        InputError
            Naming the class and the key.
        """
        raw = {name: _as_in_file(value) for name, value in values.items()}
        try:
            return super().__call__(*args, **raw)
        except ValidationError as error:
            keys = cast("type[BaseModel]", self).model_fields
            raise _of_call(self.__name__, raw, error, *keys) from None


def path_of(value: str | Path, name: str) -> Path:
    """A path that may be given as a text; ``name`` says whose argument it is in the message."""
    if not isinstance(value, str | Path) or "\0" in str(value):
        raise InputError(
            "this value does not fit",
            where=name,
            got=repr(value)[:60],
            expected="a path, or a text",
        )
    return Path(value)


def _model(function: Callable[..., Any], signature: inspect.Signature) -> type[BaseModel]:
    """What a function takes, as a table with its parameters as keys."""
    hints = get_type_hints(function, include_extras=True)
    fields: dict[str, Any] = {
        name: (hints[name], ... if each.default is each.empty else each.default)
        for name, each in signature.parameters.items()
    }
    return create_model(
        function.__name__,
        __config__=ConfigDict(strict=True, arbitrary_types_allowed=True),
        **fields,
    )


def _plain(value: Any) -> Any:
    """A value with numpy's types turned into Python's."""
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return type(value)(map(_plain, value))
    return value


def _as_in_file(value: Any) -> Any:
    """A value as a design file has it: lists of Python's numbers."""
    value = _plain(value)
    return [_as_in_file(each) for each in value] if isinstance(value, list | tuple) else value
