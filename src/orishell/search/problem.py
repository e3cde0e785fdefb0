"""What is searched: a design file, its variants, and the figures that they are compared by."""

from __future__ import annotations

import hashlib
import json
import os
from dataclasses import field
from pathlib import Path
from typing import Any

from orishell.conventions.arguments import path_of
from orishell.conventions.asked import Asked
from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.conventions.toml_file import read_toml
from orishell.design_file import DesignFile, check_design
from orishell.design_file.search import Limit, Range, Search
from orishell.design_file.tables import value_at, with_values
from orishell.search.figures import BEARS, Figure, figure
from orishell.search.space import Choices, Interval, Space, stepped

MOST_STEPS = 10_000
"""Values of a range with steps, at most."""
MOST_TRIED = 100
"""So many values of a range are tried in the design file; of more the ends."""
WITHOUT_MEANING = ("motion.frames", "shell.unit", "search")
"""Keys that change nothing of a design, or the units of its figures."""
PALETTE = "workshop.palette"
FILE_KEYS = (
    *(f"target.{curve}.{key}" for curve in ("f", "g", "inner") for key in ("svg", "dxf", "points")),
    "target.surface.mesh",
    "target.pattern.file",
    PALETTE,
)
"""Keys that may name a file beside the design file."""


@record
class Problem:
    """A design, and what is searched for among its variants."""

    path: Path  # the design file
    text: str  # what stands in it; empty where the tables come from elsewhere
    tables: dict[str, Any]  # its tables, without [search]
    unit: str  # its unit of length
    search: Search  # what is searched for
    space: Space  # the variants
    objectives: tuple[Figure, ...]  # what is to be as small as can be
    # what figures may be: those of the file, and of a structure that it bears its loads
    limits: tuple[tuple[Figure, Limit], ...]
    keys: Asked = field(default_factory=Asked, repr=False)  # which keys of the file are asked for

    @property
    def figures(self) -> dict[str, Figure]:
        """All figures that are asked for, by name."""
        return {each.name: each for each in (*self.objectives, *(each for each, _ in self.limits))}

    def files(self) -> list[Path]:
        """The files that the design and its variants name."""
        return [self.path.parent / name for name, _ in self._named()]

    def _named(self) -> list[tuple[str, str]]:
        chosen = [
            {key: value}
            for key, axis in self.space.axes.items()
            if isinstance(axis, Choices) and _is_in(FILE_KEYS, key)
            for value in axis.values
        ]
        names = {
            name
            for values in [{}, *chosen]
            for name in files_named(with_values(self.tables, values), self.path.parent).values()
        }
        return sorted(
            (name, hashlib.sha256((self.path.parent / name).read_bytes()).hexdigest())
            for name in names
        )

    def fingerprint(self) -> str:
        """What tells the designs and their figures from others: tables, and the files named."""
        content = json.dumps([self.tables, sorted(self.figures), self._named()], sort_keys=True)
        return hashlib.sha256(content.encode()).hexdigest()


def read_problem(path: str | Path) -> Problem:
    """Read a design file and its table [search].

    Parameters
    ----------
    path
        The file.

    Raises
    ------
    InputError
        As :func:`~orishell.design_file.read_design_file` does, and if there is no table [search],
        a variable is no key of the file or a value of it does not fit, or the report has no such
        figure.
    """
    path = path_of(path, "design file")
    tables = read_toml(path, "design file", "orishell new shelter writes one")
    return parse_problem(tables, path, text=path.read_text(encoding="utf-8-sig"))


def parse_problem(
    raw: dict[str, Any], path: Path, *, text: str = "", files: bool = True
) -> Problem:
    """Check the tables of a design file; raises InputError as :func:`read_problem` does."""
    design = check_design(raw, path, files=files)
    search = design.search
    if search is None:
        raise InputError(
            "there is nothing to search for",
            file=path,
            keys=("search",),
            remedy="add the table [search] with variables and minimise",
        )
    design = design.changed({"search": None})
    _require_apart(search, path)
    space = Space({key: _axis(design, key, each) for key, each in search.variables.items()})
    _require_grid(search, space, path)
    return Problem(
        path,
        text,
        design.tables,
        design.unit,
        search,
        space,
        tuple(_figure(name, path, "search.minimise") for name in search.minimise),
        tuple(
            (_figure(name, path, "search.subject_to"), limit)
            for name, limit in _limits(search, loaded=design.structure is not None).items()
        ),
        design.keys,
    )


def _limits(search: Search, *, loaded: bool) -> dict[str, Limit]:
    """Those of the file; of figures that it says nothing of, those that hold of a structure."""
    loaded = loaded or any(key.partition(".")[0] == "structure" for key in search.variables)
    return {**(BEARS if loaded else {}), **search.subject_to}


def _figure(name: str, path: Path, key: str) -> Figure:
    try:
        return figure(name)
    except InputError as error:
        raise error.at_key(key).in_file(path) from None


def _axis(design: DesignFile, key: str, allowed: Range | tuple[Any, ...]) -> Interval | Choices:
    """What a variable may be; raises InputError if a value does not fit the design file."""
    if not isinstance(allowed, Range):
        for value in allowed:
            _require(design, key, value)
        return Choices(allowed)
    steps = (allowed.high - allowed.low) / (allowed.step or 1.0)
    whole = _is_whole(design, key, allowed)
    if (whole or allowed.step) and steps > MOST_STEPS:
        raise InputError(
            "this range has too many steps",
            **_variable(design.path, key),
            got=f"{steps:.0f}",
            expected=f"at most {MOST_STEPS}",
            remedy="give a larger step",
        )
    axis = stepped(allowed, whole=whole)
    ends = (axis.low, axis.high) if isinstance(axis, Interval) else axis.values
    for value in ends if len(ends) <= MOST_TRIED else (ends[0], ends[-1]):
        _require(design, key, value)
    return axis


def _is_whole(design: DesignFile, key: str, allowed: Range) -> bool:
    numbers = (allowed.low, allowed.high, allowed.step or 1)
    if not all(float(each).is_integer() for each in numbers):
        return False
    try:
        design.changed({key: float(allowed.low)})
    except InputError as error:
        return error.whole
    return False


def _require(design: DesignFile, key: str, value: Any) -> None:
    try:
        design.changed({key: value})
    except LookupError:
        raise InputError(
            "the design file has no such key",
            **_variable(design.path, key),
            expected='a key with its tables in front of it, as "pattern.rows"',
        ) from None
    except InputError as error:
        raise error.at_key("search.variables", f'[search] variables "{key}":') from None


def _variable(path: Path, key: str) -> dict[str, Any]:
    """Where the values of a variable stand, as :class:`InputError` takes it."""
    where = f'[search] variables "{key}"'
    return {"file": path, "where": where, "keys": ("search.variables",)}


def _require_apart(search: Search, path: Path) -> None:
    """Refuse variables that change each other, or no figure."""
    keys = list(search.variables)
    for key in keys:
        inside = [each for each in keys if each.startswith(f"{key}.")]
        if inside:
            raise InputError(
                "a variable changes another one",
                **_variable(path, key),
                got=f'"{inside[0]}" beside it',
                remedy="keep one of them",
            )
        if _is_in(WITHOUT_MEANING, key) or any(_is_in((key,), each) for each in WITHOUT_MEANING):
            raise InputError(
                "designs cannot be compared by this key",
                **_variable(path, key),
                expected="a key that changes the shell, in the unit that it has",
                remedy="remove it; of a table of which other keys do, name those",
            )


def _require_grid(search: Search, space: Space, path: Path) -> None:
    if search.method != "grid":
        return
    if space.continuous:
        raise InputError(
            "a grid needs steps",
            **_variable(path, space.continuous[0]),
            remedy="add step to the range, or give a list of values",
        )
    if space.count > search.evaluations:
        raise InputError(
            "the grid has more designs than may be made",
            file=path,
            keys=("search.evaluations",),
            got=f"{search.evaluations}, for {space.count:.0f} designs",
            remedy=f"evaluations = {space.count:.0f}, larger steps, or another method",
        )


def files_named(tables: Any, directory: Path) -> dict[str, str]:
    """The files that tables name, by key; only those that there are."""
    names = {key: value_at(tables, key) for key in FILE_KEYS}
    return {
        key: name
        for key, name in names.items()
        if isinstance(name, str)
        and (key != PALETTE or name.endswith(".toml"))
        and os.path.isfile(directory / name)
    }


def _is_in(keys: tuple[str, ...], table: str) -> bool:
    """Whether one of these keys is this one, or stands in this table."""
    return any(f"{key}.".startswith(f"{table}.") for key in keys)
