"""The design file of a variant: that of the design with other values, its comments kept."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path
from typing import Any

from orishell.design_file.values import Values, with_values
from orishell.search.problem import Problem, files_named


def variant_text(problem: Problem, values: Values, directory: Path) -> str:
    """The design file of a variant, without the table [search].

    Parameters
    ----------
    problem
        The design.
    values
        What keys of the variant have.
    directory
        Where the file will be: from there it names the files of curves.
    """
    import tomlkit

    values = {**values, **_moved(problem, values, directory)}
    tables = with_values(problem.tables, values)
    try:
        document = tomlkit.parse(problem.text)
        document.pop("search", None)
        for key, value in values.items():
            _set(document, key.split("."), value)
        text = tomlkit.dumps(document)
    except tomlkit.exceptions.TOMLKitError:  # its comments cannot be kept
        text = ""
    return text if text and tomllib.loads(text) == tables else tomlkit.dumps(tables)


def _set(document: Any, keys: list[str], value: Any) -> None:
    *outer, last = keys
    for key in outer:
        document = (
            document[int(key)] if isinstance(document, list) else document.setdefault(key, {})
        )
    document[int(last) if isinstance(document, list) else last] = value


def _moved(problem: Problem, values: Values, directory: Path) -> Values:
    """The files that a variant names, as seen from a directory."""
    tables = with_values(problem.tables, values)
    return {
        key: Path(os.path.relpath(problem.path.parent / name, directory)).as_posix()
        for key, name in files_named(tables, problem.path.parent).items()
        if not Path(name).is_absolute()
    }
