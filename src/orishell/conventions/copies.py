"""Processes as copies of one that has imported what they need.

Where a system makes no copies, each imports anew.
"""

from __future__ import annotations

import multiprocessing
import os
from multiprocessing import forkserver
from multiprocessing.context import ForkServerContext, SpawnContext

SAFE_PATH = "PYTHONSAFEPATH"


def context_of(module: str) -> ForkServerContext | SpawnContext:
    """What starts processes that have imported a module.

    Parameters
    ----------
    module
        Its name, with those of its packages.
    """
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload([module])
    return context


def prepare(context: ForkServerContext | SpawnContext) -> None:
    """Start the process that others are copies of, which takes it some seconds, not the caller.

    Parameters
    ----------
    context
        What starts them.
    """
    if not isinstance(context, ForkServerContext):
        return
    before = os.environ.get(SAFE_PATH)
    os.environ[SAFE_PATH] = "1"  # modules are not those of the directory one works in
    try:
        forkserver.ensure_running()
    finally:
        if before is None:
            del os.environ[SAFE_PATH]
        else:
            os.environ[SAFE_PATH] = before
