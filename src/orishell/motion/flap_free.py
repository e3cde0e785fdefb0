"""What a mechanism without flaps says of them."""

from __future__ import annotations

from typing import Self

from orishell.motion.grid import Grid


class FlapFree:
    """A sheet without flaps: all its columns are inner ones, and nothing stops it."""

    @property
    def grid(self) -> Grid:
        """The grid of vertices."""
        raise NotImplementedError

    @property
    def inner_columns(self) -> slice:
        """All columns: there are no flaps."""
        return slice(0, self.grid.columns)

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """None."""
        return ()

    def without_flaps(self) -> Self:
        """The sheet itself."""
        return self

    def with_stop(self, stop: float) -> Self:
        """The sheet itself."""
        return self
