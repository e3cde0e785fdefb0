"""Names of designs, and of the files that are made of them."""

from __future__ import annotations

from orishell.studio.api import NAME

LONGEST_NAME = 200
"""Bytes of a name; files and their endings may have 255."""


def design_name(said: str) -> str:
    """What a design is called, in letters that every system has in names of files."""
    kept = "".join(each if each.isalnum() or each in "-_" else " " for each in said)
    short = " ".join(kept.split()).encode()[:LONGEST_NAME].decode("utf-8", "ignore")
    return short.strip() or NAME


def file_name(file: str, name: str) -> str:
    """A file of the command line's with the name of its design, as in pattern.dxf, panels.csv."""
    for stem in ("shell", "pattern"):
        if file.startswith(stem):
            return name + file.removeprefix(stem)
    return f"{name}-{file}"
