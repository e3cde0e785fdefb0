"""What is common to all that a sheet is asked to carry: box girders, or a second skin."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

from orishell.conventions.progress import Progress
from orishell.design import Design
from orishell.design.stiffeners import Stiffeners
from orishell.locking.box_rows import box_columns
from orishell.locking.carried import CarriedPath
from orishell.locking.result import Lock
from orishell.motion.convex import require_convex
from orishell.motion.lattice import InnerStaircase


class Carrier(ABC):
    """A sheet, and the strips that it is asked to carry."""

    what: ClassVar[str]  # what it is asked for, in words
    strips: ClassVar[str]  # what all its strips are, in words
    key: ClassVar[str]  # what asks how large they are

    def __init__(
        self,
        design: Design,
        lock: Lock,
        asked: Stiffeners,
        tolerance: float,
        *,
        examined: bool = True,
        inner: InnerStaircase | None = None,
    ) -> None:
        self.design, self.lock, self.asked, self.inner = design, lock, asked, inner
        self.columns = box_columns(design, self.what)
        require_convex(design.mechanism, self.what)
        self.path = CarriedPath(
            design,
            lock,
            tolerance,
            examined=examined,
            what=self.strips,
            key=self.key,
        )

    @abstractmethod
    def carried(self, progress: Progress) -> tuple[Design, Lock]:
        """The design with what it carries, and how its motion ends then.

        Raises InputError if it cannot be asked for, DesignError if there is no room for it.
        """
