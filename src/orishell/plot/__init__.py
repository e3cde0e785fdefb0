"""Pictures of a shell, drawn with matplotlib."""

from orishell.plot.deviation import plot_deviation
from orishell.plot.graphs import (
    DrawnPath,
    DrawnWeight,
    draw_load_paths,
    draw_weight,
    plot_tradeoff,
    plot_weight,
)
from orishell.plot.overview import DrawnContact, plot_overview
from orishell.plot.sections import (
    HingeSection,
    OffsetSection,
    Profile,
    find_hinge_section,
    find_offset_section,
)
from orishell.plot.structure import DrawnCase, plot_structure

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
