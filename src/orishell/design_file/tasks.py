"""Design files to begin with, by what is to be built: each is made as it is, and stands."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import rounded
from orishell.conventions.meant import no_such

FILES = Path(__file__).with_name("starters")


EVEN = 4
"""Edge ratio of a canopy over a mesh. With 8, panels at the border of vaults that bend both ways
were up to 4 times as large as their mean, with 4 and 15 x 15 vertices 2.6 times."""
PANEL = 0.4
"""Area of a panel of such a canopy (square metres): of a roof of 12 x 8 m all fit boards on the
market."""
LONG = 1.5
"""Where a mesh is longer than this, by its width, there are more panels along it than across."""
FEWEST, MOST, USUAL = 11, 21, 15
"""Rows, and columns, of such a canopy; the usual ones where its mesh cannot be read."""


@dataclass(frozen=True, slots=True)
class Task:
    """What is built, and what the command may be told of it in place of what the file says."""

    what: str
    option: str = ""  # "", or the one that it takes, with an example


TASKS: Final[Mapping[str, Task]] = {
    "shelter": Task("3 x 6 m, opens from its pack and carries snow and wind"),
    "arch": Task("for a garden or a stage"),
    "dome": Task("on four feet", "--diameter 5"),
    "canopy": Task("over a surface of your own", "--mesh roof.obj"),
    "screen": Task("one folded sheet", "--size 6x3"),
    "card": Task("a model of card, cut on one sheet of A3"),
}
FLAP = 0.024
"""Width of the flaps of a dome, by its diameter."""
LARGEST = 5.5
"""Diameter (metres) up to which the panels of a dome are cut of a board on the market."""


def task_file(
    task: str,
    *,
    mesh: str | None = None,
    diameter: float | None = None,
    size: tuple[float, float] | None = None,
    beside: Path = Path("canopy.toml"),
) -> str:
    """Text of a design file for what is to be built.

    Parameters
    ----------
    task
        One of ``TASKS``.
    mesh
        File of the surface that a canopy follows, beside the design file or with its path.
    diameter
        Of the circle through the feet of a dome's surface (metres).
    size
        Width and depth of a screen (metres).
    beside
        Where the design file will be: a mesh is looked for there, for rows and columns of its size.

    Raises
    ------
    InputError
        If there is no such task, or if it has no such size.
    """
    if task not in TASKS:
        raise no_such("there is no such task", task, TASKS, where="TASK")
    given = {"--mesh": mesh, "--diameter": diameter, "--size": size}
    own = TASKS[task].option
    for option, value in given.items():
        if value is not None and not own.startswith(option):
            raise InputError(
                f"a file for this task is not changed by {option}",
                where=option,
                got=task,
                expected=f"{own} or nothing" if own else "nothing",
                remedy="leave it out",
            )
    text = (FILES / f"{task}.toml").read_text(encoding="utf-8")
    if mesh is not None:  # whose corners may have other heights
        text = re.sub("(?m)^(ground|ties) = ", r"# \1 = ", text)
        text = re.sub(r"(?m)^\[target\.surface\].*\nformula = .*\nx = .*\ny = .*\n", MESH, text)
        text = with_value(text, "mesh", mesh)
        text = with_value(text, "edge_ratio", EVEN)
        for key, count in zip(("rows", "columns"), _counts_over(text, beside), strict=True):
            text = with_value(text, key, count)
    if diameter is not None:
        text = with_value(text, "scale", _positive(diameter, "--diameter") / 2)
        text = with_value(text, "flap", FLAP * diameter)
        if diameter > LARGEST:
            text = re.sub("(?m)^stock = ", "# with more rows: stock = ", text)
    if size is not None:
        for key, value in zip(("width", "depth"), size, strict=True):
            text = with_value(text, key, _positive(value, "--size"))
    return text


MESH: Final = """\
[target.surface]
mesh = ""                   # OBJ, STL, PLY or glTF
# unit = "mm"               # of the file, if it does not say so itself
"""


def _counts_over(text: str, path: Path) -> tuple[int, int]:
    """Rows and columns for the mesh of a design file; usual ones where it cannot be read yet."""
    from orishell.conventions.quantities import conversion
    from orishell.conventions.toml_file import parse_toml
    from orishell.design_file.doubts import likely_unit
    from orishell.design_file.file import check_design

    try:
        file = check_design(parse_toml(text), path)
    except InputError:  # orishell design says what is wrong with it, and where that is mended
        return USUAL, USUAL
    assert file.surface is not None
    drawn = likely_unit(file.surface, file.unit) or file.unit
    across, along = (conversion(drawn, file.unit) * each for each in file.surface.piece.extents)
    panels, long = across * along / PANEL, max(1.0, across / along / LONG, along / across / LONG)
    wide, high = (long, 1 / long) if across > along else (1 / long, long)
    rows, columns = (2 * round(0.5 * math.sqrt(panels * each)) - 1 for each in (high, wide))
    return min(max(rows, FEWEST), MOST), min(max(columns, FEWEST), MOST)


def with_value(text: str, key: str, value: Any) -> str:
    """The text of a design file in which the first line of a key has another value."""
    written = json.dumps(
        value if isinstance(value, str | int) else rounded(value), ensure_ascii=False
    )

    def line(found: re.Match[str]) -> str:
        comment = found[1] or ""
        return f"{f'{key} = {written}':27} {comment}" if comment else f"{key} = {written}"

    return re.sub(rf"(?m)^{key} = [^#\n]*(#.*)?$", line, text, count=1)


def _positive(value: float, option: str) -> float:
    if not 0 < value < 1e6:
        raise InputError(
            "a length in metres is asked for",
            where=option,
            got=f"{value:g}",
            expected="more than 0, as 5",
        )
    return value
