"""A studio on this machine for tests, in a process of its own."""

from __future__ import annotations

import contextlib
import os
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import httpx


@dataclass(frozen=True)
class Studio:
    """Where a studio answers, and the number of its process."""

    address: str
    process: int


@contextmanager
def running_studio(*arguments: str | Path) -> Iterator[Studio]:
    """A studio that runs as long as the context lasts."""
    port = _free_port()
    command = [sys.executable, "-m", "orishell", "studio", "--no-browse", "--port", str(port)]
    process = subprocess.Popen([*command, *map(str, arguments)], stderr=subprocess.PIPE, text=True)
    address = f"http://127.0.0.1:{port}"
    try:
        _await_answer(process, address)
        yield Studio(address, process.pid)
    finally:
        process.terminate()
        _, words = process.communicate(timeout=30)
        assert "Traceback" not in words, words


def _free_port() -> int:
    """A port that no client is given (those begin at 32768) nor a test of another process takes."""
    first = 10_000 + 41 * os.getpid() % 20_000
    for port in range(first, first + 41):
        with contextlib.suppress(OSError), socket.socket() as free:
            free.bind(("127.0.0.1", port))
            return port
    raise RuntimeError(f"no port from {first} on is free")


def _await_answer(process: subprocess.Popen[str], address: str) -> None:
    end = time.monotonic() + 60
    while time.monotonic() < end:
        if process.poll() is not None:
            assert process.stderr is not None
            raise RuntimeError(f"the studio ended: {process.stderr.read()}")
        try:
            httpx.get(f"{address}/api/info", timeout=10)
        except httpx.TransportError:
            time.sleep(0.1)
        else:
            return
    raise RuntimeError("the studio does not answer")
