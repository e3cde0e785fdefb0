"""The document that files are written from: of a designed shell, or of any FOLD file."""

from orishell.document.document import FLAT, LARGEST, SHELL, Document, DocumentState, FirstContact

__all__ = ["FLAT", "LARGEST", "SHELL", "Document", "DocumentState", "FirstContact"]
