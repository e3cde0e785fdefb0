"""A target that is scaled until the built shell has the sizes of ``[target.fit]``."""
