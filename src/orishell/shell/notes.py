"""All that a user should read of a shell: the notes of its report."""

from __future__ import annotations

from orishell.shell.build_warnings import warn_of_building
from orishell.shell.cutting import warn_of_cutting
from orishell.shell.deployment_warnings import warn_of_deployment
from orishell.shell.facts import Facts
from orishell.shell.one_motion import warn_of_freedom
from orishell.shell.piece_warnings import warn_of_joints
from orishell.shell.steps import Work


def all_notes(facts: Facts, work: Work) -> tuple[str, ...]:
    """Sentences a user should read of what was found of a shell."""
    found, analysis = facts.found, facts.analysis
    file, design, lock = found.file, found.design, found.lock
    return (
        *file.notes,
        *design.warnings,
        *lock.warnings,
        *warn_of_freedom(found.freedom),
        *warn_of_building(design, lock, found.feet, file.unit, file.workshop),
        *warn_of_joints(design, lock, file.unit),
        *warn_of_deployment(
            file,
            design,
            lock,
            facts.deployment,
            work.progress,
            mended=work.asks("remedies"),
            one=found.freedom.one_motion,
        ),
        *warn_of_cutting(design, facts.cutting, file.unit),
        *(() if analysis is None else analysis.warnings),
    )
