"""``orishell new``: a design file to begin with."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import say
from orishell.conventions.errors import InputError

SIZE = re.compile(r"\s*([\d.]+)\s*[x×*]\s*([\d.]+)\s*")


def new(
    task: Annotated[
        str | None, typer.Argument(help="What is to be built; without one, tasks are listed.")
    ] = None,
    file: Annotated[Path | None, typer.Argument(help="The file to write [TASK.toml].")] = None,
    *,
    mesh: Annotated[
        str | None, typer.Option(help="The surface of a canopy: OBJ, STL, PLY or glTF.")
    ] = None,
    diameter: Annotated[float | None, typer.Option(help="Of a dome, in metres.")] = None,
    size: Annotated[str | None, typer.Option(help="Of a screen, in metres: 6x3.")] = None,
    family: Annotated[
        str | None, typer.Option(help="In place of a task: a family, with all of its keys.")
    ] = None,
) -> None:
    """Write a design file to begin with."""
    from orishell.design_file import starter_file
    from orishell.design_file.tasks import task_file

    if family is not None:
        if file is not None or mesh is not None or diameter is not None or size is not None:
            raise InputError(
                "a family's file has no sizes, and one name",
                where="--family",
                remedy=f"orishell new --family {family} shell.toml",
            )
        text, path = starter_file(family), Path(task or f"{family}.toml")
    elif task is None:
        raise InputError(
            "nothing is named that is to be built",
            remedy="orishell new TASK, with one of these; or --family with one of those below",
            detail=_listed(),
        )
    else:
        _require_task(task)
        text = task_file(task, mesh=mesh, diameter=diameter, size=_sides(size))
        path = file if file is not None else Path(f"{task}.toml")
    try:
        with path.open("x", encoding="utf-8") as stream:
            stream.write(text)
    except FileExistsError:
        raise InputError(
            "the file exists already", where=str(path), remedy="choose another name"
        ) from None
    except OSError as error:
        raise InputError(
            "the file cannot be written", where=str(path), got=error.strerror or str(error)
        ) from None
    say(f"wrote {path}")
    say(f"next: orishell design {path} --out {path.stem}")


def _listed() -> str:
    from orishell.design_file.tasks import TASKS
    from orishell.families.registry import FAMILIES

    tasks = [f"    {f'{name} {each.option}'.strip():31}{each.what}" for name, each in TASKS.items()]
    return "\n".join(tasks + [f"    {name:31}{each.what}" for name, each in FAMILIES.items()])


def _require_task(name: str) -> None:
    """Refuse what is no task but something else that could be meant."""
    from orishell.families.registry import FAMILIES

    if name in FAMILIES:
        raise InputError(
            "this is a family, not what is to be built",
            where="TASK",
            got=name,
            remedy=f"orishell new --family {name}",
        )


def _sides(size: str | None) -> tuple[float, float] | None:
    """Width and depth as people type them: 6x3."""
    if size is None:
        return None
    found = SIZE.fullmatch(size)
    try:
        if found is not None:
            return float(found[1]), float(found[2])
    except ValueError:
        found = None
    raise InputError(
        "width and depth are asked for", where="--size", got=repr(size[:40]), expected="as 6x3"
    )
