"""Builds the pages of the studio, the viewer and searches into wheels and source distributions.

Installs that point to the sources (editable ones) do without: ``make pages`` builds there.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

STUDIO = Path("src", "orishell", "studio", "static")
PROGRAMS = Path("src", "orishell", "io", "pages")
BUILT = (STUDIO / "index.html", PROGRAMS / "viewer.js", PROGRAMS / "front.js")
WITHOUT = "ORISHELL_WITHOUT_PAGES"


class PagesHook(BuildHookInterface):
    """Packs the pages; builds them first if they are missing or older than their sources."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build what is needed before files are gathered."""
        if version == "editable" or os.environ.get(WITHOUT) == "1":
            return
        root = Path(self.root)
        if not _is_current(root):
            self._build(root / "frontend")
        build_data["artifacts"] += [f"/{place.as_posix()}/**" for place in (STUDIO, PROGRAMS)]

    def _build(self, frontend: Path) -> None:
        npm = shutil.which("npm")
        if npm is None:
            self.app.abort(
                "orishell: its studio and viewer are built with Node.js 18 or newer and npm, "
                "which is not there (on Debian: apt-get install nodejs npm). "
                f"{WITHOUT}=1 builds orishell without them."
            )
        self.app.display_info("building the pages of the studio and the viewer ...")
        done = subprocess.run(
            [npm, "run", "--silent", "pages"],
            cwd=frontend,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )
        if done.returncode:
            self.app.abort(
                f"{done.stdout}\norishell: npm could not build the studio and the viewer, see "
                f"above. {WITHOUT}=1 builds orishell without them."
            )


def _is_current(root: Path) -> bool:
    """Whether pages are there, and not older than their sources.

    In a source distribution they are what its sources were when it was made; its files' times
    are those of unpacking.
    """
    pages = [root / page for page in BUILT]
    if not all(page.is_file() for page in pages):
        return False
    if (root / "PKG-INFO").is_file():
        return True
    sources = (
        path
        for path in (root / "frontend").rglob("*")
        if path.is_file() and "node_modules" not in path.parts
    )
    newest = max(path.stat().st_mtime for path in sources)
    return min(page.stat().st_mtime for page in pages) >= newest
