"""Poppler and qpdf: where they are, and what they say of a PDF.

On Debian ``apt-get install poppler-utils qpdf`` has them. Without one of them a test is skipped, or
fails if the environment has ``ORISHELL_REQUIRE_PDF=1``.
"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from node_tools import lacking

REQUIRED = "ORISHELL_REQUIRE_PDF"


def require_sound(file: Path) -> None:
    """Have qpdf check a file, and poppler draw its pages, without a word of complaint."""
    for program, arguments in (
        ("qpdf", ["--check", str(file)]),
        ("pdftoppm", ["-r", "20", "-png", str(file), str(file.with_suffix(""))]),
    ):
        if shutil.which(program) is None:
            lacking(f"{program} is not installed: apt-get install poppler-utils qpdf", REQUIRED)
        ran = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
        assert (ran.returncode, ran.stderr) == (0, ""), f"{program}: {ran.stderr}"
