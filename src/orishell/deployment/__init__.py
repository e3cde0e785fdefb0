"""Travel and own weight: the pack, ties and what carries the shell."""

from orishell.deployment.ties import ColumnDistances, Tie, feet_ties, find_ties

__all__ = ["ColumnDistances", "Tie", "feet_ties", "find_ties"]
