"""``orishell search``: the best of a design's variants, by what its table [search] asks for."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orishell.cli.files import FORCE_HELP, bar, directory, say, shortened, warn_of_unused
from orishell.conventions.progress import asked_to_stop

if TYPE_CHECKING:
    from orishell.search import Outcome, Problem, SearchResult, WorkerPool

SHOWN = 12
"""Members of a front that are printed; of more, the ends and those about the knee."""


def search(
    file: Annotated[Path, typer.Argument(help="The design file (TOML), with a table [search].")],
    out: Annotated[
        Path, typer.Option(parser=directory, help="Directory for the files; made if needed.")
    ],
    *,
    write: Annotated[
        str | None,
        typer.Option(help="html: also a page with sliders for the variables, variants.html."),
    ] = None,
    processes: Annotated[
        int | None, typer.Option(min=1, help="Processes of this machine; one a core without it.")
    ] = None,
    cluster: Annotated[
        str | None,
        typer.Option(help="Address of a Dask scheduler whose workers are to make the designs."),
    ] = None,
    force: Annotated[bool, typer.Option("--force", help=FORCE_HELP)] = False,
) -> None:
    """Search a design's variants for those that no other beats.

    It goes on where a search into the same directory ended.
    """
    from orishell.conventions.errors import InputError
    from orishell.search import dask_workers, local_processes

    if write not in {None, "html"}:
        raise InputError(
            "a search has no such format", where="--write", got=write or "", expected="html"
        )
    workers = local_processes(processes) if cluster is None else dask_workers(cluster)
    with workers as pool:  # at once: it imports what this process does meanwhile
        _search(file, out, pool, variants=write is not None, force=force)


def _search(file: Path, out: Path, pool: WorkerPool, *, variants: bool, force: bool) -> None:
    from orishell.search import open_journal, read_problem, search_designs
    from orishell.search.journal import NAME
    from orishell.search.write import require_apart, require_installed, write_found

    require_installed()
    problem = read_problem(file)
    require_apart(problem, out, force=force)
    with open_journal(out / NAME, problem) as journal:
        known = len(journal)
        if known:
            say(f"orishell: {known} designs were made before: {out / NAME}", err=True)
        with asked_to_stop("orishell: stopping, and writing what there is") as stopped:
            with bar() as shown:
                found = search_designs(problem, pool, journal, shown, stop=stopped)
            with bar() as shown:
                written = write_found(
                    problem, found, out, pool, shown, variants=variants, stop=stopped, force=force
                )
    warn_of_unused(problem.keys.unused(beside=problem.tables))
    say("\n".join(_summary(problem, found, written)))
    if stopped.is_set():
        raise typer.Exit(128 + stopped.number)


def _summary(problem: Problem, found: SearchResult, written: list[Path]) -> Iterator[str]:
    from orishell.search.evaluate import asked_of_loads, reasons, violation
    from orishell.search.front import costs

    made = found.outcomes
    feasible = sum(violation(problem, each) == 0.0 for each in made)
    whole = "" if found.whole else ", stopped before its end: the same command goes on"
    yield f"searched  {len(made)} designs, {feasible} of which fold and keep all limits{whole}"
    for reason, count in reasons(problem, made)[:3]:
        yield f"          {count}: {reason}"
    yield f"          {asked_of_loads(problem)}"
    members, knee = found.front.members, found.front.knee
    yield f"front     {len(members)} design{'s' * (len(members) > 1)} that no other beats"
    last = -1
    for number in _printed(len(members), knee):
        if number > last + 1:
            yield "          ..."
        mark = "  <- knee" if number == knee else ""
        yield f"          {found.front.name(number)}  {_figures(problem, members[number])}{mark}"
        last = number
    for number in (knee - 1, knee + 1):
        if 0 <= number < len(members):
            words = costs(problem, members[knee], members[number])
            yield f"          from the knee to {found.front.name(number)}: {words}"
    yield from (f"wrote     {text}" for text in shortened(written))


def _printed(count: int, knee: int) -> list[int]:
    if count <= SHOWN:
        return list(range(count))
    about = range(max(knee - 2, 0), min(knee + 3, count))
    return sorted({0, 1, *about, count - 2, count - 1})


def _figures(problem: Problem, outcome: Outcome) -> str:
    from orishell.conventions.formatting import rounded

    return ", ".join(
        f"{each.label(problem.unit)} {rounded(outcome.figures[each.name]):g}"
        for each in problem.objectives
    )
