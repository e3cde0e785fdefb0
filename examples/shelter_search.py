"""Which shelter of plywood: light, small when packed, or stiff under snow.

Run it with ``python examples/shelter_search.py``; the design and what is searched for are in
``shelter_search.toml`` beside it. All designs of that search were made: they are in
``shelter_search/journal.jsonl``, from which the search finds them.
"""

from __future__ import annotations

import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

from orishell import Shell
from orishell.design_file import check_design
from orishell.design_file.tables import with_values
from orishell.search import (
    Outcome,
    Problem,
    SearchResult,
    WorkerPool,
    alone,
    open_journal,
    read_problem,
    search_designs,
)
from orishell.shell.make import make_shell
from orishell.shell.steps import STEPS

DESIGN = Path(__file__).with_suffix(".toml")
MADE = DESIGN.with_suffix("") / "journal.jsonl"


def find(problem: Problem, pool: WorkerPool) -> SearchResult:
    """What the search finds, from a copy of its journal: a search would add to it."""
    with TemporaryDirectory() as directory:
        path = Path(shutil.copy(MADE, directory))
        with open_journal(path, problem) as journal:
            return search_designs(problem, pool, journal)


def chosen(problem: Problem, found: SearchResult) -> dict[str, Outcome]:
    """The ends of the front and its knee, by what is said of them."""
    words = {"mass": "lightest", "packed_volume": "smallest pack", "deflection": "stiffest"}
    members = found.front.members
    ends = {
        words[each.name]: min(members, key=lambda member: member.figures[each.name])
        for each in problem.objectives
    }
    return {**ends, "knee": members[found.front.knee], "to begin with": found.baseline}


def design(problem: Problem, outcome: Outcome) -> Shell:
    """The shell of a design that was found, its sheet and motion only, to be drawn."""
    file = check_design(with_values(problem.tables, outcome.values), problem.path)
    return make_shell(file, clash="unexamined", skip=STEPS)


HEAD = f"{'':15}{'rows':>5}{'depth':>9}{'panels':>9}{'mass':>8}{'pack':>9}{'gives way':>11}"


def row(problem: Problem, name: str, outcome: Outcome) -> str:
    """A line of a table."""
    tables = with_values(problem.tables, outcome.values)
    pattern, thickness = tables["pattern"], 1000 * tables["panel"]["thickness"]
    mass, pack, given = (outcome.figures[each.name] for each in problem.objectives)
    return (
        f"{name:15}{pattern['rows']:5}{pattern['depth']:7.2f} m{thickness:6.1f} mm"
        f"{mass:5.0f} kg{pack:6.2f} m3{1000 * given:8.0f} mm"
    )


def main() -> None:
    """Print the ends of the front and its knee."""
    problem = read_problem(DESIGN)
    with alone() as pool:
        found = find(problem, pool)
    print(f"{len(found.outcomes)} designs, {len(found.front.members)} that no other beats")
    print(HEAD)
    for name, outcome in chosen(problem, found).items():
        print(row(problem, name, outcome))


if __name__ == "__main__":
    main()
