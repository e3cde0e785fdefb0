"""From a design file to a verified shell and its report."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from orishell.caveats import find_caveats
from orishell.choosing import Choice
from orishell.design import Design
from orishell.deviation import (
    Deviation,
    describe_deviation,
    measure_approach,
    measure_deviation,
)
from orishell.document import Document
from orishell.errors import DesignError, InputError, VerificationError, printable
from orishell.locking import (
    Lock,
    Request,
    describe_lock,
    end_of,
    unexamined_lock,
    warn_of_lock,
    with_remedies,
)
from orishell.metrics import AssignmentCheck, Residuals, extents, measure_residuals, sheet_area
from orishell.motion import FoldedState, FoldingMotion, find_assignment
from orishell.pattern import CreaseValues
from orishell.quantities import describe_quantities, measure_quantities
from orishell.quoting import tidy_degrees
from orishell.shell_document import document_of_motion
from orishell.spec import DesignFile, read_design_file
from orishell.standing import describe_feet, find_feet, stand
from orishell.tolerance import describe_choice, meet_tolerance, request_of

LENGTH_LIMIT, ANGLE_LIMIT = 1e-9, 1e-6
"""Residuals above these (relative lengths, radians) mean that the program, not the design, is
wrong: a panel may be as small as a hundred-millionth of the coordinates, and the rounding of
coordinates turns it by so much."""


class Watched(Protocol):
    """Passes states on and shows how far it has come: the command line's progress bar."""

    def __call__(self, motion: FoldingMotion, what: str) -> Iterable[FoldedState]:
        """Yield the states of the motion."""
        ...


def unwatched(motion: FoldingMotion, what: str) -> Iterable[FoldedState]:
    """Pass states on and show nothing.

    Parameters
    ----------
    motion
        The states.
    what
        What is being done, for whoever shows it.
    """
    return motion


@dataclass(frozen=True, slots=True)
class ClashTest:
    """How contact between panels is looked for.

    Parameters
    ----------
    skipped
        Do not look: for sheets of hundreds of thousands of panels.
    allowed
        Go on with a shell whose panels meet before it locks, and say so.
    advanced
        Called with the share of the path that is done.
    mended
        Called with the share that is done of the search for what works, if the design is refused;
        without contact being looked for, there is none.
    """

    skipped: bool = False
    allowed: bool = False
    advanced: Callable[[float], None] | None = None
    mended: Callable[[float], None] | None = None


CLASH_TEST = ClashTest()


@dataclass(frozen=True, slots=True, eq=False)
class Shell:
    """A designed and verified shell.

    Parameters
    ----------
    file
        The design file.
    design
        What the family made of it.
    lock
        How its motion ends.
    motion
        Its states.
    deviation
        How close the locked shell is to the surface asked for; None if that was not measured, or
        there is no target.
    choice
        What rows and columns were chosen from, if there was a tolerance.
    document
        What its files are written from.
    report
        The fields of ``report.json``.
    seconds
        Time spent by step; printed, but not part of any file.
    """

    file: DesignFile
    design: Design
    lock: Lock
    motion: FoldingMotion
    deviation: Deviation | None
    choice: Choice | None
    document: Document
    report: dict[str, Any]
    seconds: dict[str, float]

    def __repr__(self) -> str:
        file = self.file
        size = f"{file.pattern.rows} x {file.pattern.columns} inner vertices"
        return f"{type(self).__name__}({file.path.stem!r}, {file.family}, {size}; {self.lock!r})"


def design_shell(
    path: Path,
    watched: Watched = unwatched,
    clash_test: ClashTest = CLASH_TEST,
    searched: Callable[[float], None] | None = None,
) -> Shell:
    """Read a design file and make its shell: see :func:`make_shell`.

    Parameters
    ----------
    path
        The design file.
    watched
        Passes states on and may show how far it has come.
    clash_test
        Whether and how contact is looked for.
    searched
        Is told the share of the search for the fewest panels that is done.
    """
    return make_shell(read_design_file(path), watched, clash_test, searched)


def make_shell(
    file: DesignFile,
    watched: Watched = unwatched,
    clash_test: ClashTest = CLASH_TEST,
    searched: Callable[[float], None] | None = None,
    *,
    measured: bool = True,
) -> Shell:
    """Design a shell, verify its states and prove how its motion ends.

    Parameters
    ----------
    file
        The design file.
    watched
        Shows progress over the states.
    clash_test
        How contact between panels is looked for.
    searched
        Called with the share that is done of the search for a pattern that meets a tolerance.
    measured
        Whether the distance from the surface is measured.

    Raises
    ------
    InputError
        If a curve is not usable, or a setting does not fit the sheet.
    DesignError
        If the family cannot reach the target, or panels meet before the shell locks.
    VerificationError
        If the result is not rigid: a fault of the program.
    """
    clock = Clock()
    choice: Choice | None = None
    asked = request_of(file)
    try:
        if file.tolerance is not None:
            pattern, choice = meet_tolerance(file, file.tolerance, searched)
            file = replace(file, pattern=pattern)
            clock.lap("choose")
        request = Request(file.pattern, file.target, file.contact_tolerance)
        design = request.designed()
        clock.lap("design")
        if clash_test.skipped:
            lock = unexamined_lock(design)
        else:
            design, lock = end_of(
                request, design, allow_clash=clash_test.allowed, advanced=clash_test.advanced
            )
            clock.lap("clash")
    except DesignError as error:
        if clash_test.skipped:
            raise
        raise with_remedies(asked, error, clash_test.mended) from None
    except InputError as error:
        raise error.located(f"{file.path}:") from None

    feet = find_feet(design)
    if file.ground == "z0":
        design = stand(design, feet)
    motion = FoldingMotion(design.mechanism, file.frames)
    boxes: list[tuple[float, tuple[float, float, float]]] = []

    def recorded(states: Iterable[FoldedState]) -> Iterable[FoldedState]:
        for state in states:
            boxes.append((state.drive, extents(state.positions)))
            yield state

    flat = motion.flat
    residuals, assignment = measure_residuals(recorded(watched(motion, "verifying")), flat)
    _require_verified(residuals, assignment)
    clock.lap("fold")

    compared = design.swept is not None
    deviation = measure_deviation(design) if measured and compared else None
    approach = measure_approach(design) if measured and compared else None
    clock.lap("deviation")

    document = _document(file, design, motion)
    try:
        quantities = measure_quantities(document, file.workshop)
    except InputError as error:
        raise error.located(f"{file.path}:") from None
    signs = find_assignment(design.mechanism)
    drive, packed = min(boxes, key=lambda entry: math.hypot(*entry[1]))
    width, height, _ = extents(flat.positions)
    report = {
        "family": file.family,
        "unit": file.unit,
        "rows": file.pattern.rows,
        "columns": file.pattern.columns,
        "parameters": dict(design.parameters),
        **_chosen(file, choice),
        "feasible": None if clash_test.skipped else not lock.early,
        "warnings": [
            *design.warnings,
            *warn_of_lock(lock),
            *find_caveats(design, lock, feet, file.unit, file.workshop),
        ],
        "residuals": asdict(residuals),
        "assignment": {**_count(signs), **asdict(assignment)},
        "lock": describe_lock(lock),
        "not_checked": [
            *(["contact between panels before lock"] if clash_test.skipped else []),
            *([] if measured or not compared else ["distance from the surface"]),
        ],
        "stands": describe_feet(design, feet),
        "deviation": describe_deviation(design, deviation, approach) if compared else None,
        "sheet": {"width": width, "height": height, "area": sheet_area(flat.positions)},
        "deployed": _box(boxes[-1][1]),
        "packed": {"drive_deg": tidy_degrees(drive), **_box(packed)},
        "quantities": describe_quantities(quantities),
    }
    return Shell(file, design, lock, motion, deviation, choice, document, report, clock.seconds)


def _document(file: DesignFile, design: Design, motion: FoldingMotion) -> Document:
    size = f"{file.pattern.rows} x {file.pattern.columns}"
    return document_of_motion(
        motion,
        file.unit,
        title=f"{printable(file.path.stem)}: {file.family}, {size} inner vertices",
        curves=design.targets,
        origin=design.origin,
    )


def _require_verified(residuals: Residuals, assignment: AssignmentCheck) -> None:
    lengths = max(residuals.panel_length, residuals.planarity)
    angles = max(residuals.sector_sum_rad, residuals.fold_angle_rad)
    if lengths <= LENGTH_LIMIT and angles <= ANGLE_LIMIT:
        if assignment.constant and assignment.three_to_one:
            return
        raise VerificationError(
            "mountains and valleys do not fit the motion: this is a fault of the program"
        )
    raise VerificationError(
        f"the states are not those of rigid panels: lengths change by {lengths:.3g} of the sheet's "
        f"diagonal (limit {LENGTH_LIMIT:g}), angles are wrong by {angles:.3g} rad (limit "
        f"{ANGLE_LIMIT:g}); this is a fault of the program"
    )


def _chosen(file: DesignFile, choice: Choice | None) -> dict[str, Any]:
    if choice is None or file.tolerance is None:
        return {}
    return {"chosen": describe_choice(choice, file.tolerance)}


def _box(size: tuple[float, float, float]) -> dict[str, float]:
    return dict(zip(("width", "depth", "height"), size, strict=True))


def _count(signs: CreaseValues) -> dict[str, int]:
    creases = np.concatenate([signs.row.ravel(), signs.column.ravel()])
    return {
        "mountain": int((creases < 0).sum()),
        "valley": int((creases > 0).sum()),
        "unfolded": int((creases == 0).sum()),
    }


class Clock:
    """Seconds by step."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._last = time.perf_counter()

    def lap(self, step: str) -> None:
        """Note the time since the last step was done."""
        now = time.perf_counter()
        self.seconds[step] = now - self._last
        self._last = now
