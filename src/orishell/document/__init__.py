"""The document that files are written from: of a designed shell, or of any FOLD file."""

from orishell.design.part import FLAT, OPEN, SHELL, DocumentState, Part
from orishell.document.document import (
    LARGEST_COORDINATE,
    Document,
    DocumentTie,
    FirstContact,
)
from orishell.document.loaded import (
    LoadedCase,
    LoadedCreases,
    LoadedParts,
    LoadedShell,
)

__all__ = [
    "FLAT",
    "LARGEST_COORDINATE",
    "OPEN",
    "SHELL",
    "Document",
    "DocumentState",
    "DocumentTie",
    "FirstContact",
    "LoadedCase",
    "LoadedCreases",
    "LoadedParts",
    "LoadedShell",
    "Part",
]
