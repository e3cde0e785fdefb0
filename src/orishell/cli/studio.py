"""``orishell studio``: the design tool in the browser."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Any

import typer

from orishell.cli.printing import say
from orishell.errors import InputError

CONNECTIONS = 150
"""Connections at a time, at most: all of them together must not take the machine's memory."""


def studio(
    file: Annotated[Path | None, typer.Argument(help="A design file to begin with.")] = None,
    *,
    port: Annotated[int, typer.Option(min=1024, max=65535, help="Port on this machine.")] = 8765,
    host: Annotated[
        str, typer.Option(help="Address to listen on; other machines can come in if it is theirs.")
    ] = "127.0.0.1",
    browse: Annotated[bool, typer.Option(help="Open the page in the browser.")] = True,
) -> None:
    """Open the design tool in the browser, on this machine."""
    missing = [name for name in ("fastapi", "uvicorn", "tomli_w") if find_spec(name) is None]
    if missing:
        raise InputError(
            "the studio needs " + ", ".join(missing),
            remedy='pip install "orishell[studio]", or make studio',
        )
    import uvicorn

    from orishell.studio.app import PAGES, make_app
    from orishell.studio.protocol import ImpatientProtocol

    start = None if file is None else _start(file)
    local = host in {"127.0.0.1", "localhost", "::1"}
    names = {f"{name}:{port}" for name in ("127.0.0.1", "localhost", "[::1]", host)}
    app = make_app(hosts=names if local or host != "0.0.0.0" else None, start=start)
    address = f"http://{'127.0.0.1' if host == '0.0.0.0' else host}:{port}/"
    if not (PAGES / "index.html").exists():
        say(
            "orishell: warning: the studio's pages are not built; with Node.js 18 or newer, "
            "make studio builds and starts them",
            err=True,
        )
    say(f"studio at {address} (Ctrl-C ends it)", err=True)
    if browse:
        typer.launch(address)
    uvicorn.run(
        app,
        host=host,
        port=port,
        http=ImpatientProtocol,
        log_level="warning",
        server_header=False,
        limit_concurrency=CONNECTIONS,
    )


def _start(path: Path) -> dict[str, Any]:
    """Name and tables of a design file that can be shown, files of curves as their points."""
    from orishell.spec import read_design_file
    from orishell.studio.dropped import points_along
    from orishell.toml_file import read_toml

    file = read_design_file(path)
    tables = read_toml(path)
    for name, curve in (("f", file.f), ("g", file.g)):
        table = tables["target"][name]
        if "formula" not in table and not isinstance(table.get("points"), list):
            points, smooth = points_along(curve)
            tables["target"][name] = {"points": points.tolist(), "smooth": smooth}
    return {"name": path.stem, "design": tables}
