"""The document that files are written from: of a designed shell, or of any FOLD file."""

from orishell.document.document import LARGEST, Document, DocumentState, FirstContact

__all__ = ["LARGEST", "Document", "DocumentState", "FirstContact"]
