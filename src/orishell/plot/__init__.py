"""Pictures of a shell, drawn with matplotlib."""

from orishell.plot.deviation import plot_deviation
from orishell.plot.hinge_section import HingeSection, Profile, find_hinge_section
from orishell.plot.load_path import DrawnPath, draw_load_paths
from orishell.plot.offset_section import OffsetSection, find_offset_section
from orishell.plot.overview import DrawnContact, plot_overview
from orishell.plot.structure import DrawnCase, plot_structure
from orishell.plot.tradeoff import plot_tradeoff
from orishell.plot.weight import DrawnWeight, draw_weight, plot_weight

__all__ = [
    "DrawnCase",
    "DrawnContact",
    "DrawnPath",
    "DrawnWeight",
    "HingeSection",
    "OffsetSection",
    "Profile",
    "draw_load_paths",
    "draw_weight",
    "find_hinge_section",
    "find_offset_section",
    "plot_deviation",
    "plot_overview",
    "plot_structure",
    "plot_tradeoff",
    "plot_weight",
]
