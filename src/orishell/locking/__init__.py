"""Where the motion ends, the proof, and the widest flaps that meet nothing."""

from orishell.locking.lock import find_lock, lock_without_clash
from orishell.locking.motion_end import (
    end_motion,
    largest_quotable,
    reaches_target,
    require_pack,
    widest_flap,
)
from orishell.locking.result import Cause, Contact, Kind, Lock

__all__ = [
    "Cause",
    "Contact",
    "Kind",
    "Lock",
    "end_motion",
    "find_lock",
    "largest_quotable",
    "lock_without_clash",
    "reaches_target",
    "require_pack",
    "widest_flap",
]
