"""What of orishell is public, found by one rule; the tests of docs ask it.

Public is what a package lists in its ``__all__``. A module that stands in no such package, that is
directly in ``orishell`` or in a package without ``__all__``, gives every function and class that
it defines under a name without underscore. Commands are not functions to call: they are public as
what the command line takes, see ``orishell --help``.
"""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Callable, Iterator
from functools import cache
from types import ModuleType
from typing import Any

import orishell

ALSO = (
    "orishell.conventions.colours",
    "orishell.conventions.errors",
    "orishell.io.format",
    "orishell.io.formats",
    "orishell.motion.boards",
    "orishell.motion.grid",
    "orishell.motion.mesh",
    "orishell.motion.quads",
    "orishell.studio.notebook",
)
"""Modules whose names are imported from them, not from the package around them."""


@cache
def public_modules() -> tuple[ModuleType, ...]:
    """The packages and modules by which public names are imported."""
    names = ["orishell", *_modules_of(orishell)]
    for extra in ALSO:
        names += [extra, *_modules_of(importlib.import_module(extra))]
    return tuple(importlib.import_module(name) for name in names)


def _modules_of(package: ModuleType) -> Iterator[str]:
    for found in pkgutil.iter_modules(getattr(package, "__path__", ())):
        name = f"{package.__name__}.{found.name}"
        if found.name.startswith("_") or name == "orishell.cli":
            continue
        yield name
        inner = importlib.import_module(name)
        if found.ispkg and not hasattr(inner, "__all__"):
            yield from _modules_of(inner)


@cache
def public_objects() -> dict[str, Any]:
    """Functions and classes by the name under which they are imported, e.g. "orishell.design.f".

    What several packages list goes by the longest of its names: the top of the package lists
    what the others define.
    """
    found: dict[int, tuple[str, Any]] = {}
    for module in public_modules():
        for name in sorted(_names(module)):
            thing = getattr(module, name)
            if not (inspect.isclass(thing) or inspect.isfunction(thing)):
                continue
            path = f"{module.__name__}.{name}"
            if id(thing) not in found or len(path) > len(found[id(thing)][0]):
                found[id(thing)] = (path, thing)
    return dict(sorted(found.values()))


def _names(module: ModuleType) -> set[str]:
    if hasattr(module, "__all__"):
        return set(module.__all__)
    return {
        name
        for name, thing in vars(module).items()
        if not name.startswith("_") and getattr(thing, "__module__", None) == module.__name__
    }


def public_callables() -> dict[str, Callable[..., Any]]:
    """Public functions, and the public functions, methods and properties of public classes."""
    found: dict[str, Callable[..., Any]] = {}
    for path, thing in public_objects().items():
        if inspect.isfunction(thing):
            found[path] = thing
            continue
        for name, member in vars(thing).items():
            if name.startswith("_"):
                continue
            inner = member.fget if isinstance(member, property) else member
            inner = getattr(inner, "__func__", inner)
            if inspect.isfunction(inner):
                found[f"{path}.{name}"] = inner
    return found
