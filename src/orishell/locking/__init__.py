"""Where the motion ends, the proof, and the widest flaps that meet nothing."""

from orishell.locking.flap_widths import reaches_target
from orishell.locking.lock import CONTACT_TOLERANCE, find_lock, lock_without_clash
from orishell.locking.motion_end import end_motion, require_pack
from orishell.locking.remedies import with_remedies
from orishell.locking.request import Request
from orishell.locking.result import Cause, Contact, Kind, Lock

__all__ = [
    "CONTACT_TOLERANCE",
    "Cause",
    "Contact",
    "Kind",
    "Lock",
    "Request",
    "end_motion",
    "find_lock",
    "lock_without_clash",
    "reaches_target",
    "require_pack",
    "with_remedies",
]
