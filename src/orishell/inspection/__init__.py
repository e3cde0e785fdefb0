"""Whether a crease pattern and its folded states are what they say: the tests, one by one."""

from orishell.inspection.findings import Check, Contacts
from orishell.inspection.run import TOLERANCE, Inspection, inspect_fold

__all__ = ["TOLERANCE", "Check", "Contacts", "Inspection", "inspect_fold"]
