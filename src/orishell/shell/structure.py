"""A design as a structure: what its file says of it, and what is found."""

from __future__ import annotations

from orishell.conventions.progress import Progress
from orishell.conventions.quantities import conversion
from orishell.deployment.feet import find_feet
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.locking import Lock
from orishell.shell.deployment_report import areal_density, pairs_of_ties
from orishell.structure.analyse import analyse
from orishell.structure.model import Frame
from orishell.structure.results import Analysis
from orishell.structure.settings import Structure


def load_shell(
    file: DesignFile, design: Design, lock: Lock, structure: Structure, progress: Progress
) -> Analysis:
    """Analyse a design as a structure.

    Raises InputError: As :func:`~orishell.shell.analyse.analyse_structure` does.
    """
    feet, metres = find_feet(design), conversion(file.unit, "m")
    frame = Frame(
        unit=file.unit,
        feet=None if feet is None else feet.rows,
        ties=tuple(pairs_of_ties(design, file.deployment, feet)),
        areal_mass=areal_density(file, design, lock.built) * metres**2,
        built=lock.built,
    )
    return analyse(design, structure, frame, progress)
