"""From the flat sheet over the shell to the pack: how small it packs, and what raising it takes."""

from orishell.deployment.box import Box, smallest_box
from orishell.deployment.pack import Pack, count_layers, find_pack
from orishell.deployment.weight import OwnWeight, measure_weight

__all__ = [
    "Box",
    "OwnWeight",
    "Pack",
    "count_layers",
    "find_pack",
    "measure_weight",
    "smallest_box",
]
