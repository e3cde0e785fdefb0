"""Several files in one."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from pathlib import Path

ZIP_DATE = (1980, 1, 1, 0, 0, 0)


def zipped(files: Mapping[str, Path]) -> bytes:
    """A zip archive of files, the same bytes at any time.

    Parameters
    ----------
    files
        The files, by their names in the archive.
    """
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, path in files.items():
            packed.writestr(zipfile.ZipInfo(name, ZIP_DATE), path.read_bytes())
    return archive.getvalue()
