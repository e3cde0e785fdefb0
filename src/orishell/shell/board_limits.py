"""Limits of boards in a tolerance: how little of a panel may be board, how steep chamfers may be.

Boards are set back for the whole motion, which other panels or boards may end earlier: then they
are larger and their chamfers less steep. Only where boards meet at their corners, or flaps are made
narrower, less of a panel is board; so a shell is looked at again once its motion is proved.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError, Remedy, Value
from orishell.conventions.formatting import rounded_down
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.document import Document
from orishell.document.from_design import document_of_design
from orishell.families.tolerance import Tolerance
from orishell.locking import Lock, lock_without_clash
from orishell.locking.report import least_share, steepest_chamfer
from orishell.solids import build_panels
from orishell.workshop.fitting import above
from orishell.workshop.layout import find_oversize, require_stock

BOARD_ROUNDING = 1e-9
"""Boards of the shell that is made may exceed those that were tried by such a share: states that
are the same in exact numbers are computed in other ways."""


@record
class BoardFit:
    """What matters of the boards of a design, as far as it is asked for."""

    oversize: float = 0.0  # how much larger than its stock a part is, as a factor
    least_share: float = 1.0  # the least share of a panel that a board covers
    steepest_chamfer: float = 0.0  # how far a chamfer leans from a square cut at most (degrees)

    @classmethod
    def of(cls, design: Design, lock: Lock, oversize: float = 0.0) -> BoardFit:
        """Of the boards of a design whose motion ends so."""
        built = lock.built
        if built is None:
            return cls(oversize)
        share = least_share(design.mechanism, built.boards)
        return cls(oversize, share, float(np.rad2deg(steepest_chamfer(built) or 0.0)))

    def bare(self, limits: Tolerance) -> float:
        """By which factor the share of a panel that is board is too small."""
        return limits.least_share / self.least_share

    def steep(self, limits: Tolerance) -> float:
        """By which factor a chamfer is too steep."""
        most = limits.steepest_chamfer_deg
        return 0.0 if most is None else self.steepest_chamfer / most

    def misses(self, limits: Tolerance) -> float:
        """By which factor boards are off; 1 or less where they are as asked."""
        return max(self.bare(limits), self.steep(limits))


NO_BOARDS = BoardFit()


def looks_at_boards(file: DesignFile) -> bool:
    """Whether anything is asked of what a sheet is cut into."""
    return file.panel is not None or on_stock(file)


def on_stock(file: DesignFile) -> bool:
    """Whether the sheet, or boards, are cut from something that is sold in one size."""
    return file.workshop.stock is not None or file.workshop.roll is not None


def fit_boards(file: DesignFile, design: Design, limits: Tolerance) -> BoardFit:
    """How much larger than its stock a part of a design is, and boards, if they are limited.

    These are set back for its whole motion.
    """
    large = find_oversize(as_cut(file, design), file.workshop) if on_stock(file) else 0.0
    if not limits.limits_boards:
        return BoardFit(large)
    return BoardFit.of(design, lock_without_clash(design), large)


def as_cut(file: DesignFile, design: Design) -> Document:
    """A design as it is cut: boards are set back for the target at least, and for the pack more."""
    if design.panel is None:
        return document_of_design(design, file.unit)
    built = build_panels(design, design.mechanism.target_drive)
    return document_of_design(design, file.unit, boards=built.boards, flaps=built.flaps)


def require_stock_for_panels(file: DesignFile, design: Design) -> None:
    """Refuse stock, or a roll, that panels of a design do not fit, before its motion is proved.

    The proof takes longer, and makes no panel smaller, but flaps of no given width: of these
    nothing is known. Boards, which it cuts back, are said beside panels only.

    Raises OversizeError as the layout on the stock does.
    """
    if on_stock(file) and file.pattern.flap != "auto":
        require_stock(as_cut(file, design), file.workshop, final=False)


def require_boards(limits: Tolerance, design: Design, lock: Lock) -> None:
    """Refuse a shell whose boards, once its motion is proved, are not as a tolerance asks.

    Raises DesignError with limits that they keep.
    """
    if not limits.limits_boards or lock.built is None:
        return
    found = BoardFit.of(design, lock)
    if found.misses(limits) > 1 + BOARD_ROUNDING:
        what = "a shell was chosen whose boards, once its motion was proved, do not"
        raise _refusal(what, "as corners are cut off and flaps narrowed", limits, found)


def refuse_boards(rows: int, columns: int, limits: Tolerance, found: BoardFit) -> DesignError:
    """The error where no shell was found whose boards are as asked, of the nearest that was."""
    near = (
        f"no shell of this family was found within {limits.surface:g} of the surface whose boards"
    )
    return _refusal(near, f"the nearest is {rows} x {columns}", limits, found)


def _refusal(whose: str, where: str, limits: Tolerance, found: BoardFit) -> DesignError:
    """The error for boards that are not as asked, with limits that they keep."""
    changes: dict[str, Value | None] = {}
    asked, got = [], []
    if found.bare(limits) > 1:
        share = rounded_down(found.least_share)
        changes["tolerance.least_share"] = share
        asked.append(f"cover at least {plain(limits.least_share)} of every panel")
        got.append(f"boards cover at least {plain(share)}")
    if limits.steepest_chamfer_deg is not None and found.steep(limits) > 1:
        steepest = above(found.steepest_chamfer)
        changes["tolerance.steepest_chamfer_deg"] = steepest
        asked.append(f"have chamfers of at most {plain(limits.steepest_chamfer_deg)} degrees")
        got.append(f"chamfers lean by up to {plain(steepest)} degrees")
    return DesignError(
        f"{whose} {' and '.join(asked)}",
        place=where,
        keys=tuple(changes),
        size=" and ".join(got),
        candidates=[Remedy(changes)],
        excess=found.misses(limits) - 1,
    )
