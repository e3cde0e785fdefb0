"""A crease pattern folded: the motion of any pattern, and files with its states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from orishell.clash.sampled import SampledContact, look_for_contact
from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.progress import Progress, no_progress, stretch
from orishell.conventions.quantities import MILLIMETRES, Unit, plain
from orishell.conventions.record import record
from orishell.conventions.row import Row
from orishell.document import Document, DocumentState, FirstContact
from orishell.document.from_pattern import document_of_pattern, for_pictures
from orishell.io import OutputDirectory, ReadPattern, read_pattern
from orishell.io.format import DEFAULT_SETTINGS, Format
from orishell.io.formats.fold import FORMAT as FOLD
from orishell.io.formats.gltf import FORMAT as GLTF
from orishell.io.formats.html import FORMAT as HTML
from orishell.motion.following import TOLERANCE, Followed, follow
from orishell.shell.closed_form import in_closed_form
from orishell.verification.pattern.motion import ENDS
from orishell.verification.pattern.on_grid import OnGrid
from orishell.verification.pattern.rows import of_freedom, of_letters

FORMATS: tuple[Format, ...] = (FOLD, GLTF, HTML)
LOOSEST = 0.01
"""Vertices that may miss closing by more fold whatever their sectors are (radians)."""
ROUNDING = 1e-9
"""Vertices that miss closing by more do not close exactly (radians)."""
TORN = 100.0
"""Panels do not make one sheet if they part by more than this times what vertices miss, or by as
much of the sheet's diagonal where these close but for rounding."""


@record
class Folded:
    """A crease pattern and its motion."""

    source: ReadPattern
    motion: Followed
    document: Document  # all states, panels with all their corners
    play: float  # how far panels part at creases at most, in any state (length)
    contact: SampledContact  # what was seen of contact
    # how many choices of mountains and valleys fold it where letters are missing, or 0: not known
    choices: int
    choice: int  # which of them is folded, from 1
    closed_form: bool  # whether fold angles are in closed form, or else followed numerically

    def rows(self) -> list[Row]:
        """What was found, worst first."""
        pattern = self.source.flat
        assert pattern is not None
        return sorted(
            [
                self._folds(),
                self._contact(),
                of_freedom(self.motion.freedom),
                *of_letters(pattern, self.choices, self.choice),
                *self._notes(),
            ],
            key=lambda row: row.sign != "warns",
        )

    def _folds(self) -> Row:
        motion = self.motion
        finding = (
            f"to {plain(np.rad2deg(motion.reached))} degrees: {ENDS[motion.end]}; "
            f"{'in closed form' if self.closed_form else 'followed numerically'}, vertices close "
            f"to {motion.residuals.max():.0e} rad, panels part by {self.play:.0e} "
            f"{self.source.unit} at creases"
        )
        to_rounding = motion.residuals.max() <= ROUNDING
        if not to_rounding:
            finding += ": to a tolerance, not exactly"
        good = to_rounding and motion.end in ("asked", "closed")
        return Row("holds" if good else "warns", "folds", finding)

    def _contact(self) -> Row:
        seen = self.contact
        looked = f"looked at every {plain(np.rad2deg(seen.apart))} degrees"
        if seen.met is None or seen.panels is None:
            upto = f"none seen up to {plain(np.rad2deg(seen.clear))} degrees"
            return Row("says", "contact", f"{upto}, {looked}; between that is not proved")
        first, second = seen.panels
        finding = (
            f"panels {first} and {second} meet at {plain(np.rad2deg(seen.met))} degrees; {looked}, "
            "so that others may touch before; states beyond are written, but not looked at"
        )
        return Row("warns", "contact", finding)

    def _notes(self) -> list[Row]:
        return [Row("says", "read", note) for note in self.source.notes]


@checked()
def fold_pattern(
    source: str | Path,
    *,
    angle: float | None = None,
    frames: int = 25,
    unit: Unit | None = None,
    weld: float | None = None,
    tolerance: float = TOLERANCE,
    choice: int = 1,
    progress: Progress = no_progress,
) -> Folded:
    """Fold a crease pattern from a FOLD, SVG or DXF file as its mountains and valleys ask.

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
        Unit of length, where the source names none or a wrong one.
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
        If the source cannot be read, has no flat state, or names no unit.
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
    if read.flat is None:
        raise InputError(read.not_flat, where=f"{source}:")
    if read.unit not in MILLIMETRES:
        raise InputError(
            "the pattern has no unit of length",
            where=f"{source}:",
            remedy="name that of its coordinates, for example --unit mm",
        )
    largest = np.pi if angle is None else angle
    grid = OnGrid.of(read.flat)
    ways = [] if grid is None else grid.ways()
    if not 1 <= choice <= max(len(ways), 1):
        raise InputError(
            "there is no such choice of mountains and valleys",
            where="fold_pattern: choice",
            got=str(choice),
            expected=f"1 to {len(ways)}" if len(ways) > 1 else "1: there are no others",
        )
    motion = follow(
        ways[choice - 1].pattern if ways else read.flat,
        largest=largest,
        states=frames,
        tolerance=tolerance,
        progress=stretch(progress, 0.0, 0.7),
    )
    if angle is not None and motion.end not in ("asked", "closed"):
        raise DesignError(
            f"the motion does not reach {plain(np.rad2deg(angle))} degrees",
            size=f"it ends at {plain(np.rad2deg(motion.reached))} degrees: {ENDS[motion.end]}",
        )
    exact = in_closed_form(motion)
    motion = exact or motion
    states, play = [], 0.0
    for number in range(frames):
        positions, part = motion.placed(number)
        positions.flags.writeable = False
        play = max(play, part)
        degrees = np.rad2deg(motion.folds[number])
        states.append(DocumentState(positions, degrees, float(np.rad2deg(motion.drives[number]))))
        progress(0.7 + 0.1 * (number + 1) / frames, "placing panels")
    if play > TORN * max(ROUNDING, motion.residuals.max()) * read.flat.diagonal:
        raise DesignError(
            "the motion that was found tears the sheet at a hole",
            size=f"panels part by {plain(play)} {read.unit}; others were not looked for",
        )
    contact = look_for_contact(motion, stretch(progress, 0.8, 1.0))
    document = document_of_pattern(
        read.flat, motion.letters, states, title=read.title, unit=read.unit
    )
    if contact.met is not None and contact.panels is not None:
        first = FirstContact(float(np.rad2deg(contact.met)), contact.panels)
        document = replace(document, contact=first)
    return Folded(
        read, motion, document, play, contact, len(ways), choice, closed_form=exact is not None
    )


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
    pattern = folded.motion.pattern
    pictures = for_pictures(pattern, folded.document)
    missing = [each for each in FORMATS if not each.ready()]
    output = OutputDirectory(directory, inputs=(folded.source.path,), force=force)
    with output.replacing() as draft:
        for each in FORMATS:
            if each not in missing:
                document = folded.document if each is FOLD else pictures
                each.write(draft / each.file, document, DEFAULT_SETTINGS)
        names = sorted(file.name for file in draft.iterdir())
    return [directory / name for name in names], missing
