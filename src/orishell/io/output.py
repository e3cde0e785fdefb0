"""Files are written beside their place and moved there when all of them are whole."""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from orishell.errors import InputError


@dataclass(frozen=True, slots=True)
class OutputDirectory:
    """A directory to write several files into, all or none.

    Parameters
    ----------
    path
        The directory; made if it does not exist, otherwise its other files stay.
    """

    path: Path

    def require_usable(self) -> None:
        """Refuse a path that cannot become a directory with files in it, before any work is done.

        Raises
        ------
        InputError
            If the path, or a parent of it, is a file or cannot be written to.
        """
        existing = self.path
        while not existing.exists() and existing != existing.parent:
            existing = existing.parent
        if not existing.is_dir():
            raise InputError(
                "the output directory cannot be made",
                where=str(self.path),
                got=f"{existing} is a file",
                remedy="choose another directory with --out",
            )
        if not os.access(existing, os.W_OK | os.X_OK):
            raise InputError("the output directory cannot be written to", where=str(self.path))

    @contextlib.contextmanager
    def writing(self) -> Iterator[Path]:
        """A temporary directory whose files are moved to the path if nothing is raised."""
        made = [path for path in (self.path, *self.path.parents) if not path.exists()]
        done = False
        try:
            self.path.mkdir(parents=True, exist_ok=True)
            draft = Path(tempfile.mkdtemp(prefix=".orishell-", dir=self.path))
            try:
                yield draft
                self._move(sorted(draft.iterdir()))
                done = True
            finally:
                shutil.rmtree(draft, ignore_errors=True)
        except OSError as error:
            raise _unwritable(self.path, error) from None
        finally:
            if not done:
                for path in made:
                    with contextlib.suppress(OSError):
                        path.rmdir()

    def _move(self, files: list[Path]) -> None:
        for file in files:
            if (self.path / file.name).is_dir():
                raise InputError(
                    "a directory is in the way of a file", where=str(self.path / file.name)
                )
        for file in files:
            file.replace(self.path / file.name)


def _unwritable(path: Path, error: OSError) -> InputError:
    return InputError(
        "the files cannot be written", where=str(path), got=error.strerror or str(error)
    )
