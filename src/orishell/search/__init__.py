"""Search among the variants of a design: chosen, made by many processes, and the best of them."""

from typing import TYPE_CHECKING

from orishell.conventions.imports import import_on_demand

if TYPE_CHECKING:
    from orishell.search.cluster import dask_workers
    from orishell.search.evaluate import Outcome
    from orishell.search.front import Front
    from orishell.search.journal import Journal, journal_in_memory, open_journal
    from orishell.search.problem import Problem, read_problem
    from orishell.search.run import SearchResult, search_designs
    from orishell.search.worker_pool import WorkerPool, alone, local_processes

__all__ = [
    "Front",
    "Journal",
    "Outcome",
    "Problem",
    "SearchResult",
    "WorkerPool",
    "alone",
    "dask_workers",
    "journal_in_memory",
    "local_processes",
    "open_journal",
    "read_problem",
    "search_designs",
]

__getattr__, __dir__ = import_on_demand(
    __name__,
    {
        "orishell.search.cluster": ("dask_workers",),
        "orishell.search.worker_pool": ("WorkerPool", "alone", "local_processes"),
        "orishell.search.evaluate": ("Outcome",),
        "orishell.search.front": ("Front",),
        "orishell.search.journal": ("Journal", "journal_in_memory", "open_journal"),
        "orishell.search.problem": ("Problem", "read_problem"),
        "orishell.search.run": ("SearchResult", "search_designs"),
    },
)
