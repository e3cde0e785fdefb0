"""T-hedral shells: vertices on f, along any g (Sauer and Graf's T-nets)."""

from orishell.families.t_hedral.mechanism import THedral
from orishell.families.t_hedral.pattern import THedralPattern, design_t_hedral
from orishell.families.t_hedral.recognised import KnownTHedron, recognise_t_hedron

__all__ = [
    "KnownTHedron",
    "THedral",
    "THedralPattern",
    "design_t_hedral",
    "recognise_t_hedron",
]
