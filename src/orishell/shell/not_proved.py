"""What is said where the proof ends and no contact is seen."""

from __future__ import annotations

from orishell.conventions.quantities import size
from orishell.locking import Contact, Lock


def not_proved(
    lock: Lock, contact: Contact, angles: tuple[str, str], names: tuple[str, str], unit: str
) -> str:
    """Up to where a motion is proved, which panels are near there, and what that means.

    angles: Up to where it is proved, and the target, in words.
    names: The two panels, and what the target is called.
    """
    (upto, target), (panels, aim) = angles, names
    apart = size(contact.apart or 0.0, unit)
    short = f"short of the {aim} at {target}, which it may not reach"
    means = short if contact.drive < lock.target_drive else f"beyond the {aim}"
    return (
        f"not proved beyond {upto}: {panels} are {apart} apart there and may meet, {means}; "
        "nothing touches before"
    )
