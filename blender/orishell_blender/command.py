"""The orishell command: where it is, and a run of it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

from .design import Refusal

SETTING = "Edit > Preferences > Add-ons > orishell"


def find_command(named: str) -> list[str]:
    """How orishell is called.

    By what the preferences name, else with Blender's own Python if the library is installed there,
    else by the command on the PATH. Raises Refusal if there is none.
    """
    if named:
        if (found := shutil.which(os.path.expanduser(named))) is None:
            raise Refusal(f"{named}: no such program. Name the orishell command in {SETTING}")
        return [found]
    if find_spec("orishell") is not None:
        return [sys.executable, "-m", "orishell"]
    if (found := shutil.which("orishell")) is not None:
        return [found]
    raise Refusal(
        "orishell was not found, neither in Blender's own Python nor as a command on the PATH. "
        f"Install it, or name its command in {SETTING}"
    )


class Run:
    """A run of orishell, with a folder for what it writes."""

    def __init__(self, named: str) -> None:
        self.command = find_command(named)
        self.folder = tempfile.TemporaryDirectory(prefix="orishell-")
        self.out = Path(self.folder.name)
        self.process: subprocess.Popen[bytes] | None = None

    def start(self, *arguments: str | Path) -> None:
        """Begin; Blender's own Python finds there what it finds here."""
        path = os.pathsep.join(filter(None, sys.path))
        environment = {**os.environ, **({"PYTHONPATH": path} if len(self.command) > 1 else {})}
        with (self.out / "said").open("wb") as said:
            self.process = subprocess.Popen(
                [*self.command, *map(str, arguments)], env=environment, stdout=said, stderr=said
            )

    def require_success(self) -> None:
        """Wait for its end; raises Refusal with orishell's own words where it refuses."""
        if self.process is not None and self.process.wait():
            words = (self.out / "said").read_text(encoding="utf-8", errors="replace")
            told = [each for each in words.split("orishell: ") if not each.startswith("warning")]
            raise Refusal((told or [f"it ended with status {self.process.returncode}"])[-1].strip())

    def runs(self) -> bool:
        """Whether it has begun and not ended."""
        return self.process is not None and self.process.poll() is None

    def close(self) -> None:
        """End it where it stands, and remove its folder."""
        if self.process is not None and self.runs():
            self.process.terminate()
            self.process.wait()
        self.folder.cleanup()
