"""``orishell studio``: the design tool in the browser."""

from __future__ import annotations

import contextlib
import errno
import os
import socket
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orishell.cli.files import say
from orishell.conventions.errors import InputError

if TYPE_CHECKING:
    from orishell.studio.info import NamedDesign


def studio(
    file: Annotated[Path | None, typer.Argument(help="A design file to begin with.")] = None,
    *,
    port: Annotated[int, typer.Option(min=1024, max=65535, help="Port on this machine.")] = 8765,
    host: Annotated[
        str,
        typer.Option(help="Address to listen on; 0.0.0.0 lets other machines in."),
    ] = "127.0.0.1",
    browse: Annotated[bool, typer.Option(help="Open the page in the browser.")] = True,
) -> None:
    """Open the design tool in the browser, on this machine."""
    missing = [name for name in ("fastapi", "uvicorn", "tomli_w") if find_spec(name) is None]
    if missing:
        raise InputError(
            "the studio needs " + ", ".join(missing),
            remedy='pip install "orishell[studio]"',
        )
    import uvicorn

    from orishell.io.html_pages import BUILD_PAGES
    from orishell.studio.app import PAGES, make_app
    from orishell.studio.guard import Key, open_page
    from orishell.studio.protocol import protocol_for

    if not (PAGES / "index.html").exists():
        raise InputError("the studio has no pages: they have not been built", remedy=BUILD_PAGES)
    start = None if file is None else _start(file)
    key = Key(port)
    app = make_app(key, hosts=hosts_of(host, port), start=start)
    address = f"http://{place_of(host)}:{port}/?{key.query}"
    with listening(host, port) as place, contextlib.ExitStack() as life:
        say(f"studio at {address} (Ctrl-C ends it)", err=True)
        if browse:
            life.enter_context(open_page(address))
        settings = uvicorn.Config(
            app,
            http=protocol_for(key),
            ws="none",
            log_level="warning",
            server_header=False,
        )
        with contextlib.suppress(KeyboardInterrupt):
            uvicorn.Server(settings).run(sockets=[place])


def place_of(host: str) -> str:
    """What stands for a host in an address."""
    if host == "0.0.0.0":
        return "127.0.0.1"
    return f"[{host}]" if ":" in host else host


def hosts_of(host: str, port: int) -> set[str] | None:
    """Host headers that are taken by who listens on a host's port; None takes all."""
    if host == "0.0.0.0":
        return None
    return {f"{name}:{port}" for name in ("127.0.0.1", "localhost", "[::1]", place_of(host))}


def listening(host: str, port: int) -> socket.socket:
    """A socket that accepts connections already, before the browser is sent to it."""
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM
        )[0]
        # Named, it has asyncio send at once: else short answers wait 40 ms for the last to arrive.
        place = socket.socket(family, kind, protocol)
    except (OSError, ValueError) as error:
        raise _no_such_place(host, error) from None
    try:
        if os.name == "posix":  # elsewhere it lets two listen at one port
            place.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        place.bind(address)
        place.listen()
    except OSError as error:
        place.close()
        if error.errno == errno.EADDRINUSE:
            raise InputError(
                "another program listens on this port already",
                where="--port",
                got=str(port),
                remedy="end that program, or choose another port",
            ) from None
        raise _no_such_place(host, error) from None
    return place


def _no_such_place(host: str, error: Exception) -> InputError:
    return InputError(
        "the studio cannot listen on this address",
        where="--host",
        got=f"{host!r} ({getattr(error, 'strerror', None) or error})",
        expected="an address of this machine",
    )


def _start(path: Path) -> NamedDesign:
    """Name and tables of a design file, with what files of its target draw in place of them."""
    from orishell.design_file.embedded import embedded

    return {"name": path.stem, "design": embedded(path)}
