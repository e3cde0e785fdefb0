"""The shells that a process keeps, by the texts of their design files.

Components hand on a design as the text of its design file: whoever has lost its shell makes it
again, after a restart too.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Final

from orishell.conventions.errors import DesignError
from orishell.conventions.progress import Progress
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import DesignFile, check_design
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import STEPS
from orishell.studio.api import NAME
from orishell.studio.processes import MAX_VERTICES, require_small

PLACE: Final = Path(f"{NAME}.toml")
"""Where messages say that a design stands: nowhere."""
MOST: Final = 16
"""Shells that a process keeps, at most; the latest is kept in any case."""
MOST_VERTICES: Final = 2 * MAX_VERTICES
"""Vertices of all of them, at most."""
KEPT: Final[dict[tuple[bytes, bool], Shell]] = {}
"""Those of this process by their texts, and whether they are proved, the latest last."""


def digest_of(text: str) -> bytes:
    """What a design is known by, from the ``text`` of its design file."""
    return hashlib.blake2b(text.encode("utf-8", "replace"), digest_size=16).digest()


def file_of(text: str) -> DesignFile:
    """The design file of a ``text``, which names no files; raises InputError."""
    return check_design(parse_toml(text), PLACE, files=False)


def made(file: DesignFile, progress: Progress) -> Shell:
    """The shell of a ``file``, its contact unexamined; refusals have remedies that were tried."""
    if file.tolerance is None:
        require_small(file)
    try:
        return make_shell(file, progress, clash="unexamined", skip=STEPS)
    except DesignError:
        return make_shell(file, progress)


def shell_of(text: str, progress: Progress, *, proved: bool = False) -> Shell:
    """The shell of a design file's ``text``, kept or made again.

    proved: Whether contact is to be examined, and all that a verdict says.
    """
    key = digest_of(text)
    shell = (None if proved else KEPT.get((key, False))) or KEPT.get((key, True))
    if shell is None:
        file = file_of(text)
        shell = make_shell(file, progress, clash="allowed") if proved else made(file, progress)
    keep(text, shell, proved=proved)
    return shell


def keep(text: str, shell: Shell, *, proved: bool = False) -> None:
    """Keep the ``shell`` of a ``text`` as the latest; the oldest make room for it."""
    key = digest_of(text), proved
    KEPT.pop(key, None)
    KEPT[key] = shell
    vertices = sum(each.document.mesh.vertex_count for each in KEPT.values())
    while len(KEPT) > 1 and (len(KEPT) > MOST or vertices > MOST_VERTICES):
        vertices -= KEPT.pop(next(iter(KEPT))).document.mesh.vertex_count
