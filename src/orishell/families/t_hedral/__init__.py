"""T-hedral shells: vertices on f, along any g (Sauer and Graf's T-nets)."""

from orishell.families.t_hedral.mechanism import THedral
from orishell.families.t_hedral.pattern import THedralPattern, design_t_hedral

__all__ = ["THedral", "THedralPattern", "design_t_hedral"]
