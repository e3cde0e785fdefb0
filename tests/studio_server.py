"""A studio on this machine for tests, in a process of its own."""

from __future__ import annotations

import contextlib
import os
import re
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import httpx

from orishell.io.formats.html import viewer_is_built

WITHOUT_PAGES = """
import tempfile
from pathlib import Path
from orishell.__main__ import main
from orishell.studio import app
with tempfile.TemporaryDirectory() as place:
    app.PAGES = Path(place)
    (app.PAGES / "index.html").touch()
    main()
"""
"""A studio whose pages have not been built does not start; what it answers can be tested all the
same, with an empty page."""


HURRIED = """
from dataclasses import replace
from functools import partial
from orishell.__main__ import main
from orishell.studio import app
app.make_app = partial(app.make_app, limits=replace(app.LIMITS, slow=6))
main()
"""
"""A studio that waits for proofs for a few seconds only."""


@dataclass(frozen=True)
class Studio:
    """Where a studio answers whom, and the number of its process.

    Parameters
    ----------
    address
        Without the key.
    entrance
        The address that it prints, which gives a browser its cookie.
    """

    address: str
    entrance: str
    process: int

    @property
    def cookies(self) -> dict[str, str]:
        """What a client keeps that came by the entrance."""
        return {f"orishell-{self.address.rpartition(':')[2]}": self.entrance.partition("key=")[2]}


@contextmanager
def running_studio(
    *arguments: str | Path,
    python: str | Path = sys.executable,
    environment: Mapping[str, str] | None = None,
    port: int | None = None,
    program: str = "",
) -> Iterator[Studio]:
    """A studio that runs as long as the context lasts, of the orishell that a Python has.

    program: What is run in place of it, in Python.
    """
    port = port or free_port()
    built = python != sys.executable or viewer_is_built()
    code = program or ("" if built else WITHOUT_PAGES)
    begin = ["-c", code] if code else ["-m", "orishell"]
    command = [str(python), *begin, "studio", "--no-browse", "--port", str(port)]
    with tempfile.TemporaryDirectory() as place, Path(place, "words").open("wb") as heard:
        words = Path(heard.name)
        process = subprocess.Popen([*command, *map(str, arguments)], env=environment, stderr=heard)
        try:
            entrance = _await_answer(process, words)
            yield Studio(entrance.partition("/?")[0], entrance, process.pid)
        finally:
            process.terminate()
            process.wait(timeout=30)
            said = words.read_text()
            assert "Traceback" not in said, said


def descendants(process: int) -> set[str]:
    """Processes that a process and its descendants have started and that have not ended."""
    parents: dict[str, str] = {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, parent = path.read_text().rsplit(")", 1)[1].split()[:2]
        except (FileNotFoundError, ProcessLookupError):
            continue  # it ended meanwhile
        if state != "Z":
            parents[path.parent.name] = parent
    found: set[str] = set()
    level = {str(process)}
    while level := {each for each, parent in parents.items() if parent in level}:
        found |= level
    return found


def free_port() -> int:
    """A port that no client is given (those begin at 32768) nor a test of another process takes."""
    first = 10_000 + 41 * os.getpid() % 20_000
    for port in range(first, first + 41):
        with contextlib.suppress(OSError), socket.socket() as free:
            free.bind(("127.0.0.1", port))
            return port
    raise RuntimeError(f"no port from {first} on is free")


def _await_answer(process: subprocess.Popen[bytes], words: Path) -> str:
    """The address that a studio prints, once it answers."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        said = words.read_text()
        if process.poll() is not None:
            raise RuntimeError(f"the studio ended: {said}")
        if printed := re.search(r"studio at (\S+)", said):
            with contextlib.suppress(httpx.TransportError):
                httpx.get(printed[1], timeout=10)
                return printed[1]
        time.sleep(0.1)
    raise RuntimeError("the studio does not answer")
