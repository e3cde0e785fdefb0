"""Pictures of a shell, drawn with matplotlib."""

from orishell.plot.deviation import plot_deviation
from orishell.plot.overview import DrawnContact, plot_overview
from orishell.plot.tradeoff import plot_tradeoff
from orishell.plot.weight import plot_weight

__all__ = ["DrawnContact", "plot_deviation", "plot_overview", "plot_tradeoff", "plot_weight"]
