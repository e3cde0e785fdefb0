"""The command line as tests call it: within this process, or as a process of its own.

A process pays for its imports; it is right where its status, its bytes in another run or its limits
are what is tested.
"""

from __future__ import annotations

import contextlib
import io
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from unittest.mock import patch

from orishell.cli.main import run


@dataclass(frozen=True)
class Ran:
    """What a call printed, and the status it ended with."""

    returncode: int | str
    stdout: str
    stderr: str


def orishell(*arguments: str | Path, cwd: Path | str = ".") -> Ran:
    """Call ``orishell`` in a directory, in this process."""
    status: int | str | None = None
    with (
        contextlib.chdir(cwd),
        patch.object(sys, "argv", ["orishell", *map(str, arguments)]),
        contextlib.redirect_stdout(io.StringIO()) as out,
        contextlib.redirect_stderr(io.StringIO()) as err,
    ):
        try:
            run()
        except SystemExit as ended:
            status = ended.code
    return Ran(status or 0, out.getvalue(), err.getvalue())


def orishell_process(
    *arguments: str | Path, cwd: Path | str = ".", before: Callable[[], None] | None = None
) -> Ran:
    """Call ``orishell`` in a directory, as a process of its own, which begins with ``before``."""
    done = subprocess.run(
        [sys.executable, "-m", "orishell", *map(str, arguments)],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
        preexec_fn=before,
    )
    return Ran(done.returncode, done.stdout, done.stderr)
