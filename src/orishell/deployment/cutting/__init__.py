"""Shells cut with errors: what hinges need, where feet land, when flaps shut."""

from orishell.deployment.cutting.measure import can_measure, measure_cutting
from orishell.deployment.cutting.report import CuttingReport, FlapStop, Scatter

__all__ = ["CuttingReport", "FlapStop", "Scatter", "can_measure", "measure_cutting"]
