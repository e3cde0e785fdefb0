"""The document that files are written from: of a designed shell, or of any FOLD file."""

from orishell.document.document import FLAT, LARGEST, SHELL, Document, DocumentState, FirstContact
from orishell.document.loaded import LoadedCase, LoadedShell

__all__ = [
    "FLAT",
    "LARGEST",
    "SHELL",
    "Document",
    "DocumentState",
    "FirstContact",
    "LoadedCase",
    "LoadedShell",
]
