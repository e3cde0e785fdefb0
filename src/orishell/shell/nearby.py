"""A sheet nearby that folds, as a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.document import DocumentState
from orishell.document.from_pattern import document_of_pattern
from orishell.io import OutputDirectory
from orishell.io.format import DEFAULT_SETTINGS
from orishell.io.formats.fold import FORMAT as FOLD
from orishell.motion.crease_pattern import CreasePattern
from orishell.verification.pattern.motion import FoldingMotion
from orishell.verification.pattern.verdict import PatternVerdict


def nearby_pattern(verdict: PatternVerdict) -> CreasePattern:
    """The sheet near a pattern that folds where the pattern does not, with all its letters.

    Parameters
    ----------
    verdict
        What was found of the pattern.

    Raises
    ------
    DesignError
        If none was found, or there is no need.
    """
    findings = verdict.findings
    motion = None if findings is None else findings.motion
    if findings is None or not isinstance(motion, FoldingMotion) or motion.nearby is None:
        folds = any(row.subject == "folds" and row.sign == "holds" for row in verdict.rows)
        raise DesignError(
            "there is no sheet nearby to write",
            size="the pattern folds as it is" if folds else "none was found that folds",
        )
    flat = findings.pattern
    return CreasePattern(
        motion.nearby.vertices, flat.edges, motion.letters, flat.faces, flat.edge_faces
    )


def write_nearby(verdict: PatternVerdict, target: str | Path, *, force: bool = False) -> None:
    """Write that sheet as FOLD.

    Parameters
    ----------
    verdict
        What was found of the pattern.
    target
        The file.
    force
        Whether a file there that orishell did not write, or that was changed, may be written over;
        the pattern never is.

    Raises
    ------
    DesignError
        If there is no such sheet.
    InputError
        If the file cannot be written, or another is in its way.
    """
    target, read = Path(target), verdict.read
    pattern = nearby_pattern(verdict)
    flat = np.column_stack([pattern.vertices, np.zeros(len(pattern.vertices))])
    flat.flags.writeable = False
    state = DocumentState(flat, np.zeros(len(pattern.edges)), 0.0)
    document = document_of_pattern(
        pattern, pattern.letters, [state], title=f"{read.title}, moved to fold", unit=read.unit
    )
    output = OutputDirectory(target.parent, inputs=(read.path,), force=force)
    output.require_usable([target.name])
    with output.adding() as draft:
        FOLD.write(draft / target.name, document, DEFAULT_SETTINGS)
