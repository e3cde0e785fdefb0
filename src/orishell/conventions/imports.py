"""What is imported when: names of a package on demand, processes with all that they need.

A command that needs no NumPy does not wait for it. Processes are copies of one that has imported
what they need; where a system makes no copies, each imports anew.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from multiprocessing.context import ForkServerContext, SpawnContext

SAFE_PATH = "PYTHONSAFEPATH"


def import_on_demand(
    package: str, homes: Mapping[str, tuple[str, ...]]
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """The ``__getattr__`` and ``__dir__`` of a package, whose names are listed by their modules."""
    places = {name: home for home, names in homes.items() for name in names}

    def find(name: str) -> Any:
        if name not in places:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        return getattr(import_module(places[name]), name)

    return find, lambda: sorted(places)


def context_of(module: str) -> ForkServerContext | SpawnContext:
    """What starts processes that have imported a module."""
    import multiprocessing

    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload([module])
    return context


def prepare(context: ForkServerContext | SpawnContext) -> None:
    """Start the process that others are copies of, which takes it some seconds, not the caller."""
    if context.get_start_method() != "forkserver":
        return
    from multiprocessing import forkserver

    before = os.environ.get(SAFE_PATH)
    os.environ[SAFE_PATH] = "1"  # modules are not those of the directory one works in
    try:
        forkserver.ensure_running()
    finally:
        if before is None:
            del os.environ[SAFE_PATH]
        else:
            os.environ[SAFE_PATH] = before
