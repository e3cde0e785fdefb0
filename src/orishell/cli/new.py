"""``orishell new``: a design file to begin with."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import say
from orishell.conventions.errors import InputError

_METRES = r"\s*(\d+\.?\d*|\.\d+)\s*m?\s*"
NUMBER = re.compile(_METRES)
SIZE = re.compile(rf"{_METRES}[x×*]{_METRES}")
MESHES = (".obj", ".stl", ".ply", ".glb", ".gltf")


def new(
    context: typer.Context,
    task: Annotated[
        str | None, typer.Argument(help="What is to be built; without one, tasks are listed.")
    ] = None,
    file: Annotated[Path | None, typer.Argument(help="The file to write [TASK.toml].")] = None,
    *,
    mesh: Annotated[
        str | None, typer.Option(help="The surface of a canopy: OBJ, STL, PLY or glTF.")
    ] = None,
    diameter: Annotated[str | None, typer.Option(help="Of a dome, in metres.")] = None,
    size: Annotated[str | None, typer.Option(help="Of a screen, in metres: 6x3.")] = None,
    family: Annotated[
        str | None, typer.Option(help="In place of a task: a family, with all of its keys.")
    ] = None,
) -> None:
    """Write a design file to begin with."""
    from orishell.design_file import starter_file
    from orishell.design_file.tasks import task_file

    if family is not None:
        given = (file, mesh, diameter, size)
        if context.args or any(each is not None for each in given):
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
        words = [str(each) for each in (file, *context.args) if each is not None]
        _require_name([size, *words] if size is not None and context.args else words, task)
        path = file if file is not None else Path(f"{task}.toml")
        text = task_file(
            task, mesh=mesh, diameter=_metres(diameter), size=_sides(size), beside=path
        )
        if mesh is not None:
            _require_mesh(mesh, path.parent)
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
    from orishell.design_file.tasks import TASKS
    from orishell.families.registry import FAMILIES

    if name in FAMILIES:
        raise InputError(
            "this is a family, not what is to be built",
            where="TASK",
            got=name,
            remedy=f"orishell new --family {name}",
        )
    if name.endswith(".toml"):
        task = next((each for each in TASKS if each in name), "TASK")
        raise InputError(
            "what is to be built comes before the file",
            where="TASK",
            got=name,
            expected="one of " + ", ".join(TASKS),
            remedy=f"orishell new {task} {name}",
        )


def _require_name(words: list[str], task: str) -> None:
    """Refuse what stands behind a task and is no name of a file: a size, or the mesh."""
    from orishell.design_file.tasks import TASKS

    said, option = "".join(words), TASKS[task].option.partition(" ")[0] if task in TASKS else ""
    mesh, sized = said.lower().endswith(MESHES), NUMBER.fullmatch(said) or SIZE.fullmatch(said)
    if not mesh and not sized and len(words) < 2:
        return
    fits = option and (mesh if option == "--mesh" else sized)
    raise InputError(
        "this is no name of a design file",
        where="FILE",
        got=" ".join(words),
        expected=f"a name as {task}.toml, or none",
        remedy=f"did you mean {option} {said}?" if fits else "",
    )


def _require_mesh(mesh: str, directory: Path) -> None:
    """Refuse a mesh that a design file in a directory could not read: there is none, for one."""
    from orishell.design.mesh_files import require_mesh_file

    path = directory / mesh
    try:
        require_mesh_file(path)
    except InputError as error:
        if not path.exists() and Path(mesh).is_file():
            there = Path(os.path.relpath(mesh, directory)).as_posix()
            error.remedy = f"a mesh is named from where the design file is: --mesh {there}"
        raise error.located(f"--mesh: {path}:") from None


def _metres(text: str | None) -> float | None:
    """A length in metres as people type it: 5, 5.5, 5 m."""
    if text is None:
        return None
    found = NUMBER.fullmatch(text)
    if found is None:
        raise InputError(
            "a length in metres is asked for",
            where="--diameter",
            got=repr(text),
            expected="more than 0, as 5",
        )
    return float(found[1])


def _sides(size: str | None) -> tuple[float, float] | None:
    """Width and depth as people type them: 6x3, 6 x 3 m."""
    if size is None:
        return None
    found = SIZE.fullmatch(size)
    if found is None:
        raise InputError(
            "width and depth are asked for",
            where="--size",
            got=repr(size[:40]),
            expected="as 6x3, in metres with decimal points",
        )
    return float(found[1]), float(found[2])
