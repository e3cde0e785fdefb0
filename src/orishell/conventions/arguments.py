"""Arguments of public functions: checked by their types, as the values of a design file are."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache, wraps
from pathlib import Path
from typing import Any, TypeVar, cast, get_type_hints

import numpy as np
from pydantic import BaseModel, ConfigDict, ValidationError, create_model, model_validator

from orishell.conventions.errors import InputError
from orishell.conventions.faults import Location, first_fault

F = TypeVar("F", bound=Callable[..., Any])


def checked(*rules: Callable[[Any], None]) -> Callable[[F], F]:
    """Have a function's arguments checked against the types in its signature before it runs.

    Numbers and arrays of numpy's are taken as numbers and lists. A fault is an
    :class:`~orishell.conventions.errors.InputError` that names the function and the argument. Rules
    are what arguments must fulfil together: each is called with an object that has all of them, and
    raises a ``PydanticCustomError``.
    """

    def decorate(function: F) -> F:
        signature = inspect.signature(function)
        model = cache(lambda: _model(function, signature, rules))

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
                raise first_fault(raw, error, spell, lambda _: []) from None
            return function(**{name: getattr(found, name) for name in given})

        def spell(location: Location) -> str:
            name, *index = location
            return f"{function.__name__}: {name}" + "".join(f"[{each}]" for each in index)

        return cast("F", call)

    return decorate


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


def _model(
    function: Callable[..., Any],
    signature: inspect.Signature,
    rules: tuple[Callable[[Any], None], ...],
) -> type[BaseModel]:
    """What a function takes, as a table with its parameters as keys."""
    hints = get_type_hints(function, include_extras=True)

    def check(values: Any) -> Any:
        for rule in rules:
            rule(values)
        return values

    fields: dict[str, Any] = {
        name: (hints[name], ... if each.default is each.empty else each.default)
        for name, each in signature.parameters.items()
    }
    validators: dict[str, Any] = {"rules": model_validator(mode="after")(check)}
    return create_model(
        function.__name__,
        __config__=ConfigDict(strict=True, arbitrary_types_allowed=True),
        __validators__=validators,
        **fields,
    )


def _plain(value: Any) -> Any:
    """A value with numpy's types turned into Python's."""
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return type(value)(map(_plain, value))
    return value
