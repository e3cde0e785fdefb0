"""A crease pattern folded: the motion of any pattern, and files with its states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from orishell.clash.sampled import SampledContact, look_for_contact
from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.formatting import in_degrees
from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.conventions.quantities import MILLIMETRES, Unit, plain, quantity
from orishell.conventions.record import Angle, record
from orishell.conventions.row import ORDER, Row
from orishell.document import Document, DocumentState, FirstContact
from orishell.document.from_pattern import document_of_pattern, for_pictures
from orishell.io import OutputDirectory, ReadPattern, read_pattern
from orishell.io.format import DEFAULT_SETTINGS, Format
from orishell.io.formats.fold import FORMAT as FOLD
from orishell.io.formats.gltf import FORMAT as GLTF
from orishell.io.formats.html import FORMAT as HTML
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following import CLOSURE_TOLERANCE, follow
from orishell.motion.following.placing import Placing
from orishell.numerics.arrays import Array
from orishell.verification.pattern.motion import ENDS, Asked, FoldingMotion, Still
from orishell.verification.pattern.verdict import Findings, judge_sheet

FORMATS: tuple[Format, ...] = (FOLD, GLTF, HTML)
LOOSEST = 0.01
"""Vertices that may miss closing by more fold whatever their sectors are (radians)."""
CLOSED_EXACTLY = 1e-9
"""Vertices that miss closing by more do not close exactly (radians)."""
TORN = 100.0
"""Panels do not make one sheet if they part by more than this times what vertices miss, or by as
much of the sheet's diagonal where these close but for rounding."""


@record
class States:
    """States of a motion that are written."""

    letters: NDArray[np.str_]  # letter (E,) of every edge, as it folds
    drives: Array  # the driving fold angle (S,) of each, 0 at the first (radians)
    folds: Array  # fold angles (S, E) of all edges, valley positive (radians)
    residual: float  # by how much vertices miss closing, at most (radians)
    reached: Angle  # the largest fold angle at the last one
    ends: str  # why it is the last
    # what was seen of contact in them; None where the motion closes, of which more is known
    contact: SampledContact | None = None


@record
class Folded:
    """A crease pattern and its motion."""

    source: ReadPattern
    pattern: CreasePattern  # its flat sheet
    motion: FoldingMotion  # as ``orishell check`` finds it
    found: tuple[Row, ...]  # what it says of it
    states: States
    document: Document  # all states, panels with all their corners
    play: float  # how far panels part at creases at most, in any state (length)

    def rows(self) -> list[Row]:
        """What was found, worst first: of the motion what ``orishell check`` says."""
        states, seen = self.states, self.states.contact
        exact = self.motion.exact
        said = f"{len(states.drives)} up to {in_degrees(states.reached)} degrees: "
        if not exact:
            said += f"followed to a tolerance, vertices close to {states.residual:.1g} rad, "
        said += f"panels part by {quantity(self.play, self.source.unit, 2)} at creases"
        contact = self.document.contact
        if contact is not None and contact.drive_deg < np.rad2deg(states.drives[-1]):
            at = plain(contact.drive_deg)
            said += f"; beyond {at} degrees panels may pass through each other in them"
        rows = [
            *(replace(row, sign="warns") if row.sign == "fails" else row for row in self.found),
            Row("says" if exact else "warns", "states", said),
            *(() if seen is None else (_contact(seen),)),
            *(Row("says", "read", note) for note in self.source.notes),
        ]
        return sorted(rows, key=lambda row: ORDER.index(row.sign))


def _contact(seen: SampledContact) -> Row:
    """What was seen in states that close to a tolerance only."""
    looked = f"looked at every {in_degrees(seen.apart)} degrees"
    if seen.met is None or seen.panels is None:
        upto = f"none seen up to {in_degrees(seen.clear)} degrees"
        return Row("says", "contact", f"{upto}, {looked}; between that is not proved")
    first, second = seen.panels
    finding = (
        f"panels {first} and {second} meet at {in_degrees(seen.met)} degrees; {looked}, so that "
        "others may touch before; states beyond are written, but not looked at"
    )
    return Row("warns", "contact", finding)


@checked()
def fold_pattern(
    source: str | Path,
    *,
    angle: float | None = None,
    frames: int = 25,
    unit: Unit | None = None,
    weld: float | None = None,
    tolerance: float = CLOSURE_TOLERANCE,
    choice: int = 1,
    progress: Progress = no_progress,
) -> Folded:
    """Fold a crease pattern from a FOLD, SVG, DXF, CP or OBJ file as its mountains and valleys ask.

    Parameters
    ----------
    source
        The file.
    angle
        The largest fold angle at which to stop, in (0, pi] (radians). None to go on until a crease
        is folded flat, or as far as the motion is found.
    frames
        How many states there are, the flat one included, at least 2.
    unit
        Unit of length, where the source names a wrong one, or none: then mm is taken, and said.
    weld
        Points nearer to each other than this are one (length); None as
        :func:`~orishell.io.read_pattern` takes it.
    tolerance
        By how much vertices may miss closing, above 0 and at most 0.01 (radians).
    choice
        Which choice of mountains and valleys is folded where letters of a grid are missing, from 1.

    Raises
    ------
    InputError
        If the source cannot be read, or has no flat state.
    DesignError
        If no motion was found, or none up to the angle.
    """
    if angle is not None and not 0 < angle <= np.pi:
        raise InputError(
            "this is no fold angle",
            where="fold_pattern: angle",
            got=plain(angle),
            expected="above 0 and at most pi",
        )
    if frames < 2:
        raise InputError(
            "these are no frames of a motion",
            where="fold_pattern: frames",
            got=str(frames),
            expected="at least 2",
        )
    if not 0 < tolerance <= LOOSEST:
        raise InputError(
            "this is no tolerance",
            where="fold_pattern: tolerance",
            got=plain(tolerance),
            expected=f"above 0 and at most {LOOSEST:g} (radians)",
        )
    read = read_pattern(source, unit=unit, weld=weld)
    flat = read.flat
    if flat is None:
        raise InputError(read.not_flat, where=f"{source}:")
    if read.unit not in MILLIMETRES:
        note = "the file states no unit of length: it is taken in mm, unless --unit says another"
        read = replace(read, unit="mm", notes=(*read.notes, note))
    asked = Asked(largest=np.pi if angle is None else angle, choice=choice, tolerance=tolerance)
    findings, rows = judge_sheet(flat, read.unit, asked=asked, progress=stretch(progress, 0.0, 0.6))
    motion = findings.motion
    if isinstance(motion, Still):
        raise DesignError(motion.reason)
    states = _states(findings, motion, asked, frames, stretch(progress, 0.6, 0.8))
    if angle is not None and states.ends not in (ENDS["asked"], ENDS["closed"]):
        raise DesignError(
            f"the motion does not reach {plain(np.rad2deg(angle))} degrees",
            size=f"it ends at {in_degrees(states.reached)} degrees: {states.ends}",
        )
    placing, placed, play = Placing(flat), [], 0.0
    for number in range(frames):
        positions, part = placing.placed(states.folds[number])
        positions.flags.writeable = False
        play = max(play, part)
        degrees = np.rad2deg(states.folds[number])
        placed.append(DocumentState(positions, degrees, float(np.rad2deg(states.drives[number]))))
        progress(0.8 + 0.2 * (number + 1) / frames, "placing panels")
    if play > TORN * max(CLOSED_EXACTLY, states.residual) * flat.diagonal:
        raise DesignError(
            "the motion that was found tears the sheet at a hole",
            size=f"panels part by {plain(play)} {read.unit}; others were not looked for",
        )
    document = document_of_pattern(flat, states.letters, placed, title=read.title, unit=read.unit)
    document = replace(document, contact=_first_contact(motion, states.contact))
    return Folded(read, flat, motion, tuple(rows), states, document, play)


def _states(
    findings: Findings, motion: FoldingMotion, asked: Asked, frames: int, progress: Progress
) -> States:
    """States of the motion where it closes, or else of one that nearly does."""
    if motion.exact:
        drives = np.linspace(0.0, motion.drives[-1], frames)
        folds, miss = motion.folds_at(drives), motion.miss
        return States(motion.letters, drives, folds, miss, motion.reached, motion.ends)
    pattern = findings.pattern
    if motion.way == "closed form":
        pattern = replace(pattern, letters=motion.letters)
    found = follow(
        pattern,
        largest=asked.largest,
        states=frames,
        tolerance=asked.tolerance,
        progress=stretch(progress, 0.0, 0.5),
    )
    contact = look_for_contact(found, stretch(progress, 0.5, 1.0))
    worst, ends = float(found.residuals.max()), ENDS[found.end]
    return States(found.letters, found.drives, found.folds, worst, found.reached, ends, contact)


def _first_contact(motion: FoldingMotion, seen: SampledContact | None) -> FirstContact | None:
    """The first panels that are known to meet."""
    proof, seen = motion.proof, seen or motion.seen
    if proof is not None and proof.contact is not None:
        return FirstContact(float(np.rad2deg(proof.contact.drive)), proof.contact.panels)
    if seen is not None and seen.met is not None and seen.panels is not None:
        return FirstContact(float(np.rad2deg(seen.met)), seen.panels)
    return None


def write_folded(
    folded: Folded, directory: str | Path, *, force: bool = False
) -> tuple[list[Path], Sequence[Format]]:
    """Write a folded pattern as FOLD, glTF and a page: all or none; and what cannot be written.

    Parameters
    ----------
    directory
        Where to; made if needed. Files of an earlier run that this one does not write are removed;
        all others stay.
    force
        Whether files that are not of an earlier run, or were changed, may be written over; the
        pattern never is.

    Raises
    ------
    InputError
        If the directory cannot be written to, or a file is in the way there.
    """
    directory = Path(directory)
    pictures = for_pictures(folded.pattern, folded.document)
    missing = [each for each in FORMATS if not each.ready()]
    output = OutputDirectory(directory, inputs=(folded.source.path,), force=force)
    with output.replacing() as draft:
        for each in FORMATS:
            if each not in missing:
                document = folded.document if each is FOLD else pictures
                each.write(draft / each.file, document, DEFAULT_SETTINGS)
        names = sorted(file.name for file in draft.iterdir())
    return [directory / name for name in names], missing
