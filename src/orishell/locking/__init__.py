"""Where the motion ends, what touches first, and flaps that lock without meeting anything else."""

from orishell.locking.describe import describe_lock, warn_of_lock
from orishell.locking.end import end_of
from orishell.locking.flaps import fit_flaps, locks
from orishell.locking.lock import CONTACT_TOLERANCE, Contact, Lock, find_lock, unexamined_lock
from orishell.locking.open_end import end_motion
from orishell.locking.remedies import with_remedies
from orishell.locking.request import FamilyParameters, Request

__all__ = [
    "CONTACT_TOLERANCE",
    "Contact",
    "FamilyParameters",
    "Lock",
    "Request",
    "describe_lock",
    "end_motion",
    "end_of",
    "find_lock",
    "fit_flaps",
    "locks",
    "unexamined_lock",
    "warn_of_lock",
    "with_remedies",
]
