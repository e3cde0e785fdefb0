"""The design file of a variant: that of the design with other values, its comments kept."""

from __future__ import annotations

import json
import os
import re
import threading
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.design_file.inputs import input_files
from orishell.design_file.rewritten import rewritten
from orishell.design_file.tables import Values, with_values
from orishell.io.formats.tables import write_csv
from orishell.io.output import OutputDirectory
from orishell.plot.graphs import plot_front
from orishell.search.evaluate import Outcome
from orishell.search.front import Front, beaten, scores
from orishell.search.page import require_page, write_page
from orishell.search.problem import Problem, files_named
from orishell.search.run import SearchResult
from orishell.search.variants import NAME, write_variants
from orishell.search.worker_pool import WorkerPool


def variant_text(problem: Problem, values: Values, directory: Path) -> str:
    """The design file of a variant, without the table [search].

    In ``directory``, where it will be, it names the files of curves as seen from there.
    """
    values = {**values, **_moved(problem, values, directory)}
    return rewritten(problem.text, problem.tables, values, without=("search",))


def _moved(problem: Problem, values: Values, directory: Path) -> Values:
    """The files that a variant names, as seen from a directory."""
    tables = with_values(problem.tables, values)
    return {
        key: Path(os.path.relpath(problem.path.parent / name, directory)).as_posix()
        for key, name in files_named(tables, problem.path.parent).items()
        if not Path(name).is_absolute()
    }


_WRITTEN = re.compile(rf"front(-\d+\.toml|\.(csv|png|html))|{re.escape(NAME)}")
MANIFEST = ".orishell-search.json"
"""The list of the files of a search."""


def require_installed() -> None:
    """Refuse to begin what would end for want of a library or of the page."""
    missing = [name for name in ("pymoo", "tomlkit") if find_spec(name) is None]
    if missing:
        raise InputError(
            f"{' and '.join(missing)} must be installed to search",
            remedy="pip install orishell[search]",
        )
    require_page()


def require_apart(problem: Problem, directory: Path, *, force: bool = False) -> None:
    """Refuse to search where files cannot be written, or would take the place of others.

    Those that a front has are not known before it is, so that every name that one may have counts.
    """
    there = (path.name for path in directory.glob("*"))
    names = [name for name in there if _WRITTEN.fullmatch(name)]
    _output(problem, directory, force=force).require_usable(names, replacing=True)


def _output(problem: Problem, directory: Path, *, force: bool) -> OutputDirectory:
    inputs = (*input_files(problem.path, problem.tables), *problem.files())
    return OutputDirectory(directory, MANIFEST, inputs=inputs, force=force)


def write_found(
    problem: Problem,
    found: SearchResult,
    directory: Path,
    pool: WorkerPool,
    progress: Progress = no_progress,
    *,
    variants: bool = False,
    stop: threading.Event | None = None,
    force: bool = False,
) -> list[Path]:
    """Write ``front.csv``, the design files of its members, ``front.png`` and ``front.html``.

    And a page of variants, ``variants.html``, if it is asked for.

    Files of an earlier run that this one does not write are removed.
    """
    with _output(problem, directory, force=force).replacing() as draft:
        _write_table(draft / "front.csv", problem, found.front)
        for number, member in enumerate(found.front.members):
            text = variant_text(problem, member.values, directory.resolve())
            (draft / f"{found.front.name(number)}.toml").write_text(
                text, encoding="utf-8", newline="\n"
            )
        draw_front(draft / "front.png", problem, found)
        write_page(draft / "front.html", problem, found, pool, progress, stop=stop)
        if variants:
            write_variants(draft / NAME, problem, found, pool, progress, stop=stop)
        names = sorted(file.name for file in draft.iterdir())
    return [directory / name for name in names]


def _write_table(path: Path, problem: Problem, front: Front) -> None:
    keys, figures = list(problem.space.axes), list(problem.figures)
    rows = [
        [
            f"{front.name(number)}.toml",
            "knee" if number == front.knee else "",
            *(_cell(member.values[key]) for key in keys),
            *(member.figures[name] for name in figures),
        ]
        for number, member in enumerate(front.members)
    ]
    write_csv(path, ["file", "knee", *keys, *figures], rows)


def _cell(value: Any) -> Any:
    """A value as a design file has it, but texts without their quotes."""
    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)


def draw_front(path: Path, problem: Problem, found: SearchResult) -> None:
    """Write the picture of the front: each pair of objectives."""

    def points(outcomes: list[Outcome]) -> np.ndarray:
        rows = [scores(problem, each) for each in outcomes]
        return np.array(rows, np.float64).reshape(-1, len(problem.objectives))

    baseline = [found.baseline] if found.baseline.figures else []
    plot_front(
        path,
        points([*found.front.members]),
        points(beaten(problem, found.outcomes, found.front)),
        points(baseline),
        knee=found.front.knee,
        labels=[each.label(problem.unit) for each in problem.objectives],
    )
