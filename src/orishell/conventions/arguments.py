"""Arguments of public functions, checked by type."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache, wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, cast, get_type_hints

import numpy as np
from pydantic import BaseModel, ConfigDict, ValidationError, create_model

from orishell.conventions.errors import InputError
from orishell.conventions.faults import Place, first_fault
from orishell.conventions.table_keys import Location, TableKeys

if TYPE_CHECKING:  # pydantic gives it no public name
    from pydantic._internal._model_construction import ModelMetaclass as Metaclass
else:
    Metaclass = type(BaseModel)

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
                raise _of_call(function.__name__, raw, error, model()) from None
            return function(**{name: getattr(found, name) for name in given})

        return cast("F", call)

    return decorate


def _of_call(
    name: str, raw: dict[str, Any], error: ValidationError, taken: type[BaseModel]
) -> InputError:
    """The first fault of what a function or a class was called with, and what it has ``taken``."""

    def place(location: Location) -> Place:
        key, *index = location or ("",)
        return {"where": f"{name}: {key}" + "".join(f"[{each}]" for each in index)}

    return first_fault(raw, error, place, TableKeys(taken), called=True)


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
            taken = cast("type[BaseModel]", self)
            raise _of_call(self.__name__, raw, error, taken) from None


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
