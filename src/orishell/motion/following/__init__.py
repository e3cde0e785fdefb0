"""The motion of any crease pattern, followed numerically: no closed form, residuals instead.

Derived in docs/theory/following.md.
"""

from orishell.motion.following.followed import CLOSURE_TOLERANCE, Followed, follow

__all__ = ["CLOSURE_TOLERANCE", "Followed", "follow"]
