"""Run all tests on a FOLD file, and say what could not be tested."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, Protocol

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, followed, no_progress
from orishell.conventions.record import record
from orishell.io import FoldFile, FoldFrame
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.dofs import Freedom, find_freedom, least_count
from orishell.motion.following.followed import FREEDOM_AT
from orishell.motion.following.system import Closure
from orishell.motion.mesh import measure_mesh_folds
from orishell.motion.quads import area_vectors, units
from orishell.numerics.arrays import Array
from orishell.verification.findings import Check, Names
from orishell.verification.folds import AssignmentTest, FoldAngleTest
from orishell.verification.rigidity import (
    ClashTest,
    ConvexTest,
    DevelopableTest,
    FlatTest,
    RigidTest,
)
from orishell.verification.sheet import Sheet, State
from orishell.verification.strips import Strips, find_strips


def freedom_of_frames(
    file: FoldFile,
    sheet: Sheet,
    strips: Strips | None,
    folded: Iterable[tuple[float, FoldFrame]],
) -> tuple[Freedom, ...]:
    """Degrees of freedom in some frames; none where there is no flat sheet that lies in a plane.

    strips: What it is made in, if that is no flat sheet.
    folded: The largest fold angle of every folded frame (radians), and the frame.
    """
    listed = sorted(folded, key=lambda each: each[0])
    angles = np.array([angle for angle, _ in listed])
    # Those in the middle of the motion: at its ends creases may be folded flat.
    middle = {int(np.abs(angles - share * angles[-1]).argmin()) for share in FREEDOM_AT if listed}
    some = [listed[each][1].positions for each in sorted(middle)]
    if strips is not None:
        return tuple(strips.freedom_at(each) for each in some)
    flat = _in_plane(sheet)
    if flat is None or not listed:
        return ()
    mesh = sheet.mesh
    letters = np.array(file.assignment or ["U"] * len(mesh.edges))
    pattern = CreasePattern(flat, mesh.edges, letters, mesh.loops, mesh.edge_faces)
    closure = Closure.of(pattern)
    return tuple(
        find_freedom(closure, measure_mesh_folds(mesh, each)[closure.edges]) for each in some
    )


def _in_plane(sheet: Sheet) -> Array | None:
    """The flat sheet (V, 2) as seen from where its panels go counter-clockwise; None if bent."""
    if not sheet.flat:
        return None
    points = sheet.frame.positions
    areas = area_vectors(points[sheet.mesh.faces])
    normal = units(areas.sum(axis=0))
    if (areas @ normal <= 0).any():  # pieces that are turned over
        return None
    first = points[sheet.mesh.faces[0]]
    along = units(first[1] - first[0])
    across = np.cross(normal, along)
    flat = (points - first[0]) @ np.stack([along, across, normal], axis=1)
    used = np.unique(sheet.mesh.faces)
    return None if np.abs(flat[used, 2]).max() > sheet.tolerance else flat[:, :2]


LENGTH_TOLERANCE = 1e-6
"""Allowed error of lengths relative to the diagonal of the flat sheet's bounding box."""

DIGITS = 1e-12
"""Coordinates whose last digit is less than this share of the sheet's diagonal say enough."""


class FrameTest(Protocol):
    """A test that looks at one frame after the other."""

    def see(self, state: State) -> None:
        """Measure one frame."""
        ...


@record
class Inspection:
    """The outcome of all tests, and what could not be tested."""

    file: FoldFile
    sheet: Sheet  # the reference frame
    tolerance: float  # allowed error of lengths relative to the sheet's diagonal
    checks: tuple[Check, ...]  # the outcome of every test that could be made
    not_checked: tuple[str, ...]  # what could not be tested
    folded: bool  # whether there is a folded state among the frames
    freedom: tuple[Freedom, ...]  # degrees of freedom in some of its folded states
    strips: Strips | None = None  # what it is made in, if it is no flat sheet but one of ours

    @property
    def degrees_of_freedom(self) -> int | None:
        """The least of these; None if no gap tells it, or there are no such states."""
        return least_count(self.freedom)

    @property
    def passed(self) -> bool:
        """Whether every test passed."""
        return all(check.passed for check in self.checks)

    @property
    def inner_vertices(self) -> int:
        """Number of vertices that panels surround."""
        return len(self.sheet.inner)

    @property
    def creases(self) -> int:
        """Number of edges that join two panels."""
        return int(self.file.mesh.crease.sum())

    @property
    def turned_panels(self) -> int:
        """Number of panels that are listed the other way round."""
        return int((self.file.mesh.reversed_faces ^ (self.sheet.up < 0)).sum())

    @property
    def flat_frame(self) -> int | None:
        """Number of the frame of the flat sheet; None if no frame is flat."""
        return self.sheet.frame.number if self.sheet.flat else None

    def as_dict(self) -> dict[str, Any]:
        """The report that ``orishell check --json`` prints."""
        mesh = self.file.mesh
        return {
            "file": str(self.file.path),
            "unit": self.file.unit,
            "passed": self.passed,
            "panels": len(mesh.faces),
            "vertices": mesh.vertex_count,
            "creases": self.creases,
            "inner_vertices": self.inner_vertices,
            "pieces": int(mesh.pieces.max()) + 1,
            "turned_panels": self.turned_panels,
            "frames": [frame.number for frame in self.file.frames],
            "reference_frame": self.sheet.frame.number,
            "flat_frame": self.flat_frame,
            "diagonal": self.sheet.diagonal,
            "tolerance": self.tolerance,
            "strips": None if self.strips is None else self.strips.known.strips,
            "degrees_of_freedom": self.degrees_of_freedom,
            "checks": {check.name: check.as_dict() for check in self.checks},
            "not_checked": list(self.not_checked),
        }


def inspect_fold(
    file: FoldFile, tolerance: float = LENGTH_TOLERANCE, progress: Progress = no_progress
) -> Inspection:
    """Test a crease pattern and its folded states.

    Parameters
    ----------
    tolerance
        Allowed error of lengths relative to the diagonal of the flat sheet's bounding box.
        Angles may be wrong by as much as such an error turns the smallest panel there, see
        :class:`~orishell.verification.sheet.Sheet`.

    Raises
    ------
    InputError
        If the tolerance is not usable, or a panel has no area.
    """
    require_tolerance(tolerance)
    sheet, names = Sheet.of(file, tolerance), Names(file)
    letters = None if file.assignment is None else np.array(file.assignment)
    convex = ConvexTest(sheet, names)
    developable, rigid = DevelopableTest(sheet, names), RigidTest(sheet, names)
    angles = FoldAngleTest(sheet, names, letters)
    assignment, clash = AssignmentTest(sheet, names, letters), ClashTest(sheet, names)
    tests: list[FrameTest] = [developable, rigid, angles, assignment]
    if convex.passed:
        tests.append(clash)
    largest_folds: list[tuple[float, FoldFrame]] = []
    for frame in followed(file.frames, len(file.frames), progress, "checking"):
        state = sheet.state(frame)
        if state.folded:
            largest_folds.append((float(np.abs(state.folds).max()), frame))
        for test in tests:
            test.see(state)

    folded = bool(largest_folds)
    of_sheet, strips = developable.checks(), None
    maekawa, vertices_untested = assignment.maekawa()
    if not (sheet.flat or all(check.passed for check in of_sheet)):
        strips = _strips(file, tolerance)
    if strips is not None:  # what is true of flat sheets is asked of these alone
        said = f"{strips.sheet} ({strips.family})"
        of_sheet = [Check("strips", True, said, {"strips": strips.known.strips})]
        maekawa, vertices_untested = [], 0
    freedom = freedom_of_frames(file, sheet, strips, largest_folds)
    rigid_checks = rigid.checks()
    checks = (
        convex.check,
        *(FlatTest(sheet, names).checks() if sheet.flat else []),
        *of_sheet,
        *rigid_checks,
        *angles.checks(),
        *assignment.checks(folded=folded),
        *maekawa,
        *(clash.checks() if convex.passed else []),
    )
    bent = any(check.name == "planarity" and not check.passed for check in rigid_checks)
    largest = max(float(np.abs(frame.positions).max()) for frame in file.frames)
    digit = float(np.spacing(largest)) / sheet.diagonal
    dangling = int((file.mesh.edge_faces < 0).all(axis=1).sum())
    without = [] if sheet.flat and not folded else angles.frames_without
    untested = [
        (not folded, "folded states (the file has none): rigid panels, fold angles, contact"),
        (folded and not freedom, "degrees of freedom of its states (no flat sheet in one plane)"),
        (not sheet.flat, f"the flat sheet (the file has none): lengths are those of frame "
        f"{sheet.frame.number}, overlaps of what is cut are not seen"),
        (digit > DIGITS, f"lengths to better than {digit:.1e} of the diagonal (coordinates of "
        f"{largest:.3g} have no more digits)"),
        (not len(sheet.inner), "developability (no inner vertices)"),
        (bool(without), f"fold angles of {_frames(without)} (no edges_foldAngle of their own)"),
        (angles.pattern_untested, "edges_foldAngle of the flat sheet (no frame folds like that)"),
        (letters is None, "mountains and valleys (no edges_assignment)"),
        (letters is not None and assignment.unassigned > 0,
        f"{assignment.unassigned} creases of unknown assignment"),
        (folded and assignment.never_folded > 0,
        f"the sign of {assignment.never_folded} mountains and valleys (unfolded or folded flat in "
        "every frame)"),
        (vertices_untested > 0, f"Maekawa's condition at {vertices_untested} vertices (not four "
        "creases of known assignment)"),
        (dangling > 0, f"{dangling} edges that belong to no panel"),
        (not convex.passed, "contact (some panels are not convex)"),
        (convex.passed and bent, "contact exactly (some panels are not plane)"),
        (clash.touching_at_end, "the order of panels that lie flat on each other at the end of the "
        "motion"),
        (True, "contact between frames: only the states in the file are tested"),
    ]  # fmt: skip
    return Inspection(
        file,
        sheet,
        tolerance,
        checks,
        tuple(text for applies, text in untested if applies),
        folded,
        freedom,
        strips,
    )


def _strips(file: FoldFile, tolerance: float) -> Strips | None:
    """The strips that a file's panels are made in, if they are some that are known."""
    mesh, states = file.mesh, [frame.positions for frame in file.frames]
    return find_strips(states, mesh.loops, mesh.edges, mesh.edge_faces, tolerance)


def require_tolerance(tolerance: float) -> None:
    """Refuse a tolerance that is not usable.

    Parameters
    ----------
    tolerance
        Allowed error of lengths relative to the sheet's diagonal.

    Raises
    ------
    InputError
        If it is not finite or not above 0.
    """
    if not (math.isfinite(tolerance) and tolerance > 0):
        raise InputError(
            "the tolerance is not usable",
            where="tolerance",
            keys=("tolerance",),
            got=str(tolerance),
            expected="a finite number greater than 0",
        )


def _frames(numbers: list[int]) -> str:
    if len(numbers) == 1:
        return f"frame {numbers[0]}"
    listed = ", ".join(map(str, numbers[:10])) + (", ..." if len(numbers) > 10 else "")
    return f"frames {listed}"
