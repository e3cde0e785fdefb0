"""Tests of a crease pattern and its folded states, as a FOLD file gives them."""

from orishell.verification.findings import Check, Contacts
from orishell.verification.residuals import AssignmentCheck, Residuals, measure_residuals
from orishell.verification.run import LENGTH_TOLERANCE, Inspection, inspect_fold, require_tolerance
from orishell.verification.strips import Strips

__all__ = [
    "LENGTH_TOLERANCE",
    "AssignmentCheck",
    "Check",
    "Contacts",
    "Inspection",
    "Residuals",
    "Strips",
    "inspect_fold",
    "measure_residuals",
    "require_tolerance",
]
