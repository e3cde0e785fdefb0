"""Where the motion ends, what touches first, and flaps that lock without meeting anything else."""

from orishell.locking.describe import describe_lock, warn_of_lock
from orishell.locking.lock import CONTACT_TOLERANCE, Contact, Lock, find_lock, unexamined_lock
from orishell.locking.open_end import end_motion
from orishell.locking.settle import Request, settle

__all__ = [
    "CONTACT_TOLERANCE",
    "Contact",
    "Lock",
    "Request",
    "describe_lock",
    "end_motion",
    "find_lock",
    "settle",
    "unexamined_lock",
    "warn_of_lock",
]
