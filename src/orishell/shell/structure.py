"""A design as a structure: what belongs to it, and what is found."""

from __future__ import annotations

from orishell.conventions.progress import Progress
from orishell.deployment import Site
from orishell.design import Design
from orishell.locking import Lock
from orishell.structure.analyse import analyse
from orishell.structure.model import Frame
from orishell.structure.results import Analysis
from orishell.structure.settings import Structure


def load_shell(
    design: Design, lock: Lock, site: Site, structure: Structure, progress: Progress
) -> Analysis:
    """Analyse a design as a structure.

    Raises InputError: As :func:`~orishell.shell.analyse.analyse_structure` does.
    """
    frame = Frame(
        unit=site.unit,
        feet=None if site.feet is None else site.feet.rows,
        ties=site.ties,
        areal_mass=site.areal_density * site.metres**2,
        built=lock.built,
    )
    return analyse(design, structure, frame, progress)
