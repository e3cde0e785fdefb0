"""``orishell hops``: components for Grasshopper, by Rhino's Hops."""

from __future__ import annotations

import contextlib
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from orishell.cli.files import say
from orishell.cli.studio import hosts_of, listening, place_of
from orishell.conventions.errors import InputError


def hops(
    *,
    port: Annotated[int, typer.Option(min=1024, max=65535, help="Port on this machine.")] = 8766,
    host: Annotated[
        str,
        typer.Option(help="Address to listen on; 0.0.0.0 lets other machines in."),
    ] = "127.0.0.1",
    new_key: Annotated[
        bool, typer.Option("--new-key", help="Make another key: known addresses do not work then.")
    ] = False,
) -> None:
    """Serve components for Grasshopper, on this machine."""
    missing = [name for name in ("starlette", "uvicorn", "tomli_w") if find_spec(name) is None]
    if missing:
        what = "Grasshopper's components need " + ", ".join(missing)
        raise InputError(what, remedy='pip install "orishell[studio]"')
    import uvicorn

    from orishell.studio.hops.key import NAME, PathKey, kept_word
    from orishell.studio.hops.protocol import GIVEN
    from orishell.studio.hops.server import make_hops
    from orishell.studio.protocol import protocol_for

    key = PathKey(port, kept_word(Path.home() / NAME, new=new_key))
    app = make_hops(key, hosts_of(host, port))
    settings = uvicorn.Config(
        app, http=protocol_for(key), ws="none", log_level="warning", server_header=False
    )
    with listening(host, port) as place:
        address = f"http://{place_of(host)}:{port}/{key.word}"
        say(f"components of Hops at {address} (Ctrl-C ends it):", err=True)
        for path, component in GIVEN.items():
            say(f"  {component['name']:<20} {address}/{path}", err=True)
        with contextlib.suppress(KeyboardInterrupt):
            uvicorn.Server(settings).run(sockets=[place])
