"""Records: what functions return and take, unchangeable; how a prompt and files show them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import FrozenInstanceError, dataclass, field, fields, is_dataclass
from functools import cached_property
from inspect import Signature, signature
from operator import attrgetter
from pathlib import Path
from typing import (
    Annotated,
    Any,
    NamedTuple,
    NoReturn,
    TypeVar,
    cast,
    dataclass_transform,
    get_args,
    get_type_hints,
)

import numpy as np

from orishell.conventions.formatting import tidy_degrees

SHOWN = 60
"""Characters that a part may take in the line of the whole; else its type is shown."""

T = TypeVar("T")


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
def record(cls: type[T]) -> type[T]:
    """Make a frozen dataclass of a class, with slots unless it has a ``cached_property``.

    Records may hold arrays, so two of them are equal if they are the same one. A ``__repr__`` that
    the class has stays. Its ``__init__`` is written when the first of its kind is made: there are
    hundreds of kinds, and a command makes records of few.
    """
    slots = not any(isinstance(each, cached_property) for each in vars(cls).values())
    made: Any = dataclass(init=False, slots=slots, eq=False, repr=False)(cls)
    if cls.__repr__ is object.__repr__:
        made.__repr__ = _in_one_line
    made.__setattr__, made.__delattr__ = _keep, _keep
    made.__getstate__, made.__setstate__ = _state, _set_state

    def begin(self: object, *values: object, **named: object) -> None:
        made.__init__ = _initialiser(made)
        made.__init__(self, *values, **named)

    made.__init__ = begin
    made.__signature__ = _SIGNATURE
    return cast("type[T]", made)


def _keep(self: object, name: str, *_: object) -> NoReturn:
    """Refuse to set, or to delete, a field."""
    raise FrozenInstanceError(f"cannot change field {name!r}")


def _state(self: object) -> dict[str, Any]:
    """What a copy of a record, and another process, are given."""
    known = {each.name: getattr(self, each.name) for each in fields(cast("Any", self))}
    return {**known, **getattr(self, "__dict__", {})}


def _set_state(self: object, state: Mapping[str, Any]) -> None:
    for name, value in state.items():
        object.__setattr__(self, name, value)


def _initialiser(made: Any) -> Any:
    """The ``__init__`` of a frozen dataclass with the fields of a record."""
    known = {each.name: each for each in fields(made)}
    body: dict[str, Any] = {"__module__": made.__module__, "__qualname__": made.__qualname__}
    if hasattr(made, "__post_init__"):
        body["__post_init__"] = made.__post_init__
    twin: Any = type(made.__name__, (), {**body, **known})
    twin.__annotations__ = {name: each.type for name, each in known.items()}
    return dataclass(frozen=True, eq=False, repr=False)(twin).__init__


class _SignatureOfKind:
    """What a kind of record is made of, asked of its class."""

    def __get__(self, thing: object, kind: Any) -> Signature:
        made = signature(_initialiser(kind))
        return made.replace(parameters=list(made.parameters.values())[1:])


_SIGNATURE = _SignatureOfKind()


def _in_one_line(thing: object) -> str:
    """Numbers to six digits, arrays by their shape; no None, no functions, nothing private."""
    assert is_dataclass(thing)
    parts = {each.name: getattr(thing, each.name) for each in fields(thing) if each.repr}
    shown = (
        f"{name}={_short(part)}"
        for name, part in parts.items()
        if not name.startswith("_") and part is not None and not callable(part)
    )
    return f"{type(thing).__name__}({', '.join(shown)})"


def _short(part: object) -> str:
    match part:
        case np.ndarray():
            text = f"array{part.shape}"
        case str():
            text = repr(part if len(part) < SHOWN - 1 else part[: SHOWN - 5] + "...")
        case float():
            text = f"{part:.6g}"
        case Path():
            text = repr(str(part))
        case tuple():
            text = f"({', '.join(map(_short, part))})"
        case _:
            text = repr(part)
    if len(text) <= SHOWN:
        return text
    size = len(part) if isinstance(part, Collection) and not isinstance(part, str) else "..."
    return f"{type(part).__name__}({size})"


Angle = Annotated[float, "degrees in files"]
"""An angle of a record: in radians here, in degrees and with ``_deg`` behind its name in files."""


class Written(NamedTuple):
    """What files have of a record: a field, a property, or "part.name" for one of a part of it."""

    name: str
    kind: Any
    angle: bool


_KNOWN: dict[Any, dict[str, Written]] = {}


def written_fields(kind: Any) -> dict[str, Written]:
    """What files say of a record, by their keys.

    All its public fields, or those fields and properties that its ``REPORTED`` names: "part.name"
    for one of a part, under the key "name".
    """
    if kind not in _KNOWN:
        names = getattr(kind, "REPORTED", None) or [each.name for each in fields(kind)]
        found = (_written(kind, name) for name in names if not name.startswith("_"))
        _KNOWN[kind] = {each.name.rpartition(".")[2] + "_deg" * each.angle: each for each in found}
    return _KNOWN[kind]


def _written(kind: type, name: str) -> Written:
    part, _, rest = name.partition(".")
    if rest:
        return _written(get_type_hints(kind)[part], rest)._replace(name=name)
    if hasattr(kind, "model_fields"):  # a table of the design file
        return Written(name, get_type_hints(kind)[name], angle=False)
    found = getattr(kind, name, None)
    got = found.fget if isinstance(found, property) else getattr(found, "func", None)
    hints = [
        get_type_hints(got or kind, include_extras=extras)["return" if got else name]
        for extras in (True, False)
    ]
    angle = _is_angle(hints[0])
    return Written(name, hints[0] if angle else hints[1], angle)


def _is_angle(kind: Any) -> bool:
    return kind == Angle or any(map(_is_angle, get_args(kind)))


def as_table(thing: Any) -> Any:
    """A record as files have it: nested tables, lists and plain values."""
    match thing:
        case np.ndarray() | np.generic():
            return as_table(thing.tolist())
        case tuple() | list():
            return [as_table(each) for each in thing]
        case Mapping():
            return {key: as_table(each) for key, each in thing.items()}
        case _ if is_dataclass(thing) or hasattr(thing, "REPORTED"):
            return {key: as_table(read_key(thing, key)) for key in written_fields(type(thing))}
    return thing


def read_key(thing: Any, key: str) -> Any:
    """The value that files have under a key of a record."""
    name, _, angle = written_fields(type(thing))[key]
    value = attrgetter(name)(thing)
    return _tidy(value) if angle else value


def _tidy(angles: Any) -> Any:
    if isinstance(angles, tuple | list | np.ndarray):
        return [_tidy(each) for each in angles]
    return None if angles is None else tidy_degrees(angles)
