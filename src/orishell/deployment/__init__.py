"""Travel and own weight: the pack, ties and what carries the shell."""

from orishell.deployment.settings import FROM_FLAT, Attachment, Deployment, Start, VertexPair

__all__ = ["FROM_FLAT", "Attachment", "Deployment", "Start", "VertexPair"]
