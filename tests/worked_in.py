"""The tests of what one works in, for ``make quick``: python tests/worked_in.py [ROOM ...].

A room is a folder of ``tests``, which has the name of its package. Without one: all that changed
since the branch began, what is not committed included.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).parents[1]
OTHERS = {"examples": "tests/test_examples.py", "docs": "tests/docs", "frontend": "tests/studio"}
"""Tests of what is no package."""
NOTHING = "nothing has changed since main: make quick ROOM=locking runs the tests of a room"


def tests_of(changed: Iterable[str], root: Path) -> list[str]:
    """Folders and files of tests, none of them in another, of files that changed."""
    found = {each for path in changed for each in _tests_of(PurePosixPath(path), root)}
    return sorted(each for each in found if found.isdisjoint(map(str, PurePosixPath(each).parents)))


def _tests_of(path: PurePosixPath, root: Path) -> list[str]:
    match path.parts:
        case ("src", "orishell", *folders, _) if folders:
            return _nearest(root, folders)
        case ("tests", *_, name) if re.fullmatch(r"test_\w+\.py", name):
            return [str(path)] if (root / path).exists() else []
        case ("tests", name) if name.endswith(".py"):
            return _that_import(path.stem, root)
        case ("tests", *folders, _):
            return _nearest(root, folders)
        case (place, *_) if place in OTHERS:
            return [OTHERS[place]]
    return []


def _nearest(root: Path, folders: list[str]) -> list[str]:
    """The folder of tests with that name, or the one around it."""
    while folders and not (root / "tests").joinpath(*folders).is_dir():
        folders = folders[:-1]
    return ["/".join(("tests", *folders))] if folders else []


def _that_import(module: str, root: Path) -> list[str]:
    line = re.compile(rf"^(from {module}|import {module})\b", re.MULTILINE)
    files = sorted((root / "tests").rglob("test_*.py"))
    return [
        file.relative_to(root).as_posix() for file in files if line.search(file.read_text("utf-8"))
    ]


def changed_files() -> list[str]:
    """All that differs from where the branch left ``main``."""
    begun = _git("merge-base", "main", "HEAD")
    new = _git("ls-files", "--others", "--exclude-standard")
    return [*_git("diff", "--name-only", *begun), *new]


def _git(*words: str) -> list[str]:
    ran = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True)
    return ran.stdout.splitlines()


def main(rooms: list[str]) -> int:
    """Print them, or say that there are none."""
    tests = [f"tests/{room}" for room in rooms] if rooms else tests_of(changed_files(), ROOT)
    if not tests:
        sys.stderr.write(f"{NOTHING}\n")
        return 2
    sys.stdout.write(" ".join(tests) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
