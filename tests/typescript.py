"""Types of messages in Python, written as TypeScript, and whether a message is of its type."""

from __future__ import annotations

import dataclasses
import inspect
import json
import types
from collections.abc import Iterator, Mapping, Sequence
from typing import (
    Annotated,
    Any,
    Literal,
    NotRequired,
    Union,
    get_args,
    get_origin,
    get_type_hints,
    is_typeddict,
)

from field_notes import field_notes

from orishell.conventions.record import written_fields

PLAIN = {
    str: "string",
    int: "number",
    float: "number",
    bool: "boolean",
    type(None): "null",
    Any: "unknown",
    object: "unknown",
}
SHAPES = {
    Union: "union",
    types.UnionType: "union",
    Literal: "literal",
    tuple: "tuple",
    list: "list",
    Sequence: "list",
    dict: "dict",
    Mapping: "dict",
}


def declarations(*messages: type) -> str:
    """Interfaces of messages and of all that they hold, by name."""
    found = {each.__name__: each for message in messages for each in _records(message)}
    return "\n".join(_interface(found[name]) for name in sorted(found))


def fits(value: Any, kind: Any) -> bool:
    """Whether what JSON held is of a type, with no field that the type does not name."""
    match _shape(kind):
        case "record", _:
            fields, needed = _fields(kind)
            found = isinstance(value, dict) and needed <= set(value) <= set(fields)
            return found and all(fits(value[name], fields[name]) for name in value)
        case "union", inner:
            return any(fits(value, each) for each in inner)
        case "literal", inner:
            return value in inner
        case "tuple", inner:
            same = isinstance(value, list) and len(value) == len(inner)
            return same and all(map(fits, value, inner))
        case "list" | "dict" as shape, inner:
            items = value.values() if isinstance(value, dict) else value
            item = inner[1] if shape == "dict" else inner[0]
            return type(value).__name__ == shape and all(fits(each, item) for each in items)
    kind = get_args(kind)[0] if get_origin(kind) is Annotated else kind
    number = kind is float and type(value) in {int, float}
    return number or kind in {Any, object} or type(value) is kind


def _shape(kind: Any) -> tuple[str, tuple[Any, ...]]:
    """How a type is made of others, and of which."""
    if _is_record(kind):
        return "record", ()
    origin, inner = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return _shape(inner[0])
    if origin is tuple and inner[-1:] == (...,):
        return "list", inner
    return SHAPES.get(origin, "plain"), inner


def _is_record(kind: Any) -> bool:
    return is_typeddict(kind) or _has_written_fields(kind)


def _has_written_fields(kind: Any) -> bool:
    return dataclasses.is_dataclass(kind) or hasattr(kind, "REPORTED")


def _fields(record: type) -> tuple[dict[str, Any], set[str]]:
    """Types of fields by name, and the names of those that are always there."""
    if _has_written_fields(record):
        fields = {key: each.kind for key, each in written_fields(record).items()}
        return fields, set(fields)
    fields = get_type_hints(record)
    # Not __required_keys__, which does not see NotRequired in annotations that are text.
    marked = get_type_hints(record, include_extras=True)
    return fields, {name for name in fields if get_origin(marked[name]) is not NotRequired}


def _records(kind: Any) -> Iterator[type]:
    shape, inner = _shape(kind)
    if shape == "record":
        yield kind
        inner = tuple(_fields(kind)[0].values())
    for each in inner if shape != "literal" else ():
        yield from _records(each)


def _interface(record: type) -> str:
    fields, needed = _fields(record)
    text = inspect.getdoc(record) or ""
    notes = field_notes(record)
    if _has_written_fields(record):
        names = {key: each.name for key, each in written_fields(record).items()}
        notes = {key: notes[name] for key, name in names.items() if name in notes}
    lines = [f"/** {text.splitlines()[0]} */", f"export interface {record.__name__} {{"]
    for name, kind in fields.items():
        if name in notes:
            lines.append(f"  /** {notes[name]} */")
        lines.append(f"  {name}{'' if name in needed else '?'}: {_written(kind)};")
    return "\n".join([*lines, "}", ""])


def _written(kind: Any) -> str:
    match _shape(kind):
        case "record", _:
            text = str(kind.__name__)
        case "union", inner:
            text = " | ".join(dict.fromkeys(map(_written, inner)))
        case "literal", inner:
            text = " | ".join(map(json.dumps, inner))
        case "tuple", inner:
            text = f"[{', '.join(map(_written, inner))}]"
        case "list", inner:
            item = _written(inner[0])
            text = f"({item})[]" if "|" in item else f"{item}[]"
        case "dict", inner:
            text = f"Record<string, {_written(inner[1])}>"
        case _:
            text = PLAIN[get_args(kind)[0] if get_origin(kind) is Annotated else kind]
    return text
