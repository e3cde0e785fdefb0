"""Travel and own weight: the pack, ties and what carries the shell."""

from orishell.deployment.box import Box, smallest_box
from orishell.deployment.cutting import (
    CuttingReport,
    FlapStop,
    Scatter,
    measure_cutting,
)
from orishell.deployment.growth import ColumnDistances
from orishell.deployment.pack import Pack, count_layers, find_pack
from orishell.deployment.settings import FROM_FLAT, Attachment, Deployment, Start
from orishell.deployment.site import Site, find_site
from orishell.deployment.ties import Tie, feet_ties, find_ties
from orishell.deployment.weight import OwnWeight, measure_weight

__all__ = [
    "FROM_FLAT",
    "Attachment",
    "Box",
    "ColumnDistances",
    "CuttingReport",
    "Deployment",
    "FlapStop",
    "OwnWeight",
    "Pack",
    "Scatter",
    "Site",
    "Start",
    "Tie",
    "count_layers",
    "feet_ties",
    "find_pack",
    "find_site",
    "find_ties",
    "measure_cutting",
    "measure_weight",
    "smallest_box",
]
