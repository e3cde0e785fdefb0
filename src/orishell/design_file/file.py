"""A design file, read and checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from orishell.conventions.arguments import path_of
from orishell.conventions.asked import Asked
from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.conventions.table import placed
from orishell.curves import Curve
from orishell.deployment import FROM_FLAT, Deployment
from orishell.design import Design, PanelSpec, PiecedSurface
from orishell.design.end_walls import EndWall, require_one_wall_each
from orishell.design.stiffeners import Stiffeners
from orishell.design_file.constructions import (
    plate_density,
    plates_of,
    require_boards,
    require_both_sides,
    require_frames,
    require_inner,
    require_meant_thickness,
    require_one_hinge_density,
)
from orishell.design_file.doubts import doubts_of
from orishell.design_file.faults import explain, read_tables
from orishell.design_file.fit import FitTable
from orishell.design_file.inputs import input_files
from orishell.design_file.memory import require_memory
from orishell.design_file.search import Search, with_joined_keys
from orishell.design_file.tables import (
    FileTable,
    Ground,
    keys_of,
    sized,
    structure_of,
    value_at,
    weighed,
    with_values,
)
from orishell.design_file.targets import Known
from orishell.families.pattern import Pattern
from orishell.families.registry import pattern_of
from orishell.families.tolerance import Tolerance
from orishell.motion.drawing import Drawing
from orishell.structure.settings import Structure
from orishell.workshop import Workshop

CURVES = ("shell.unit", "target")
"""Where it is said what the target is."""


@record
class DesignFile:
    """A checked design file."""

    path: Path  # where it was read from
    family: str  # the family's name
    unit: str  # unit of length of the curves and of all files written
    target: tuple[Curve, Curve] | None  # the target curves f and g, or None
    # the family's parameters; its rows and columns have no meaning if there is a tolerance
    pattern: Pattern
    # how near the shell is to be to its surface, if rows and columns are to be chosen
    tolerance: Tolerance | None
    frames: int  # number of states to write
    # distance at which panels touch, relative to the diagonal of the flat sheet
    contact_tolerance: float
    workshop: Workshop  # how the flat sheet is drawn and cut
    tables: dict[str, Any] = field(repr=False)  # what the file says, table by table
    ground: Ground = "z0"  # where a shell that can stand is put
    deployment: Deployment = FROM_FLAT  # how it is deployed
    panel: PanelSpec | None = None  # what its panels are made of; None if they have no thickness
    # what is put into its folds where it stands; None if nothing is
    stiffeners: Stiffeners | None = None
    # mass by volume of its boards, where these are its own; 0 if it is not known (kg/m^3)
    plate_density: float = 0.0
    end_walls: tuple[EndWall, ...] = ()  # what closes its ends once it stands
    # how it is analysed as a structure; None if that was not asked for
    structure: Structure | None = None
    search: Search | None = None  # what is searched for among its variants; None if nothing is
    files: bool = True  # whether its curves and its surface may come from files
    # the surface in place of f and g, or None; the first that there is, where its turn is open
    surface: PiecedSurface | None = None
    inner: Curve | None = None  # the curve of a second skin, drawn where f is; None if it has none
    # turns of the surface's rectangle to be tried (degrees); none if the file says how it is turned
    turns: tuple[float, ...] = ()
    # sizes that the built shell is to have; None if they are the target's
    fit: FitTable | None = field(default=None, repr=False)
    # the drawn sheet in place of f and g, or None
    drawing: Drawing | None = field(default=None, repr=False)
    # the design of a target nearby, with whose sheet a fit begins; None where it begins anew
    before: Design | None = field(default=None, repr=False)
    # the keys of the file as it was read, and which of them were asked for, by what was made of it
    # with changes, too
    keys: Asked = field(default_factory=Asked, repr=False)

    @property
    def panel_count(self) -> int:
        """Number of panels, the flaps included."""
        return (self.pattern.rows + 1) * (self.pattern.columns + 1)

    @property
    def inputs(self) -> tuple[Path, ...]:
        """The file, and those that it names: what is written never takes their place."""
        return input_files(self.path, self.tables) if self.files else ()

    @property
    def notes(self) -> tuple[str, ...]:
        """What is to be said of how the files of its target were read."""
        return self._known.notes + doubts_of(self.surface, self.unit, sized=self.fit is not None)

    @property
    def _known(self) -> Known:
        """What its target is."""
        return Known(self.target, self.inner, self.surface, self.turns, self.drawing)

    def changed(self, values: Mapping[str, Any]) -> DesignFile:
        """The design file with other values at some keys, as if they had been typed in.

        Parameters
        ----------
        values
            Values by key, the tables in front of it: "pattern.rows". None removes a key.

        Raises
        ------
        InputError
            As when the file is read.
        """
        return self._with(values, self.keys)

    def tried(self, values: Mapping[str, Any]) -> DesignFile:
        """The design file changed for a trial: what that is asked for is not asked of this file.

        Parameters
        ----------
        values
            As for :meth:`changed`.

        Raises
        ------
        InputError
            As when the file is read.
        """
        return self._with(values, Asked())

    def _with(self, values: Mapping[str, Any], keys: Asked) -> DesignFile:
        tables = with_values(self.tables, values)
        same = all(value_at(tables, key) == value_at(self.tables, key) for key in CURVES)
        known = self._known if same else None
        made = _checked(tables, self.path, files=self.files, known=known, keys=keys)
        return replace(made, before=self.before)

    @property
    def f(self) -> Curve:
        """The swept curve."""
        return self.require_target()[0]

    @property
    def g(self) -> Curve:
        """The curve that it is swept along."""
        return self.require_target()[1]

    def require_target(self) -> tuple[Curve, Curve]:
        """Both target curves.

        Raises
        ------
        InputError
            If the file has none.
        """
        if self.target is None:
            raise InputError(
                "there is no target",
                file=self.path,
                keys=("target",),
                remedy="add [target.f] and [target.g], or use orishell design, which needs none",
            )
        return self.target


def read_design_file(path: str | Path) -> DesignFile:
    """Read and check a design file.

    Parameters
    ----------
    path
        The file.

    Raises
    ------
    InputError
        Naming the file, the key, what was found and what is expected.
    """
    path = path_of(path, "design file")
    return check_design(read_tables(path), path)


def check_design(raw: dict[str, Any], path: Path, *, files: bool = True) -> DesignFile:
    """Check the tables of a design file.

    Parameters
    ----------
    raw
        The tables.
    path
        Where they were read from; files of curves are found beside it.
    files
        Whether curves may come from files.

    Raises
    ------
    InputError
        Naming the file, the key, what was found and what is expected.
    """
    require_meant_thickness(raw, path)
    return _checked(with_joined_keys(raw), path, files=files)


def _checked(
    raw: dict[str, Any],
    path: Path,
    *,
    files: bool,
    known: Known | None = None,
    keys: Asked | None = None,
) -> DesignFile:
    """A checked design file; a target that is known is not read again."""
    keys, first = keys or Asked(), keys is None
    try:
        file = FileTable.model_validate(raw)
    except ValidationError as error:
        raise explain(path, raw, error, keys_of(Pattern)) from None
    given = [key for key in placed(file, keys.asked) if key != "pattern"]  # the family's table
    family = pattern_of(file.shell.family, file=path, keys=("shell.family",))
    directory = path.parent if files else None
    drawn = None if file.target is None else file.target.pattern
    if known is None and drawn is not None:  # it says how many rows there are
        try:
            known = Known(drawing=drawn.drawing(directory, file.shell.unit))
        except InputError as error:
            raise error.in_file(path) from None
    table = sized(path, file, None if known is None else known.drawing)
    try:
        pattern = family.model_validate(table)
    except ValidationError as error:
        raise explain(path, raw, error, keys_of(family), ("pattern",)) from None
    given += placed(pattern, keys.asked, "pattern.")
    if first:
        keys.given = tuple(key for key in given if value_at(raw, key) is not None)
    require_memory(path, pattern, file.motion.frames)
    panel = file.panel if file.panel.thickness else None
    try:
        require_frames(file.motion.frames, file.deployment)
        unit = file.shell.unit
        structure = structure_of(file.structure, file.load_case, panel, unit)
        workshop = file.workshop.beside(directory)
        require_one_hinge_density(panel, workshop)
        require_boards(file.tolerance, panel)
        panel, workshop = weighed(file.structure, panel, workshop, unit)
        stiffeners = plates_of(file.stiffeners, structure, panel, unit)
        panels = file.panel, panel
        density = plate_density(stiffeners, file.structure, panels, file.workshop, unit)
        if file.target is not None and file.target.fit is not None:
            file.target.fit.require_headroom(unit)
            if file.target.sizes_alone:
                file.target.fit.require_lengths(pattern.lengths())
        if known is None:
            known = Known() if file.target is None else file.target.known(directory, unit)
        require_both_sides(structure, stiffeners, panel)
        require_inner(known.inner is not None, stiffeners)
        require_one_wall_each(file.end_wall)
    except InputError as error:
        raise error.in_file(path) from None
    return DesignFile(
        path=path,
        family=file.shell.family,
        unit=file.shell.unit,
        target=known.curves,
        inner=known.inner,
        surface=known.surface,
        turns=known.turns,
        drawing=known.drawing,
        fit=None if file.target is None else file.target.fit,
        pattern=pattern,
        tolerance=file.tolerance,
        frames=file.motion.frames,
        contact_tolerance=file.motion.contact_tolerance,
        workshop=workshop,
        ground=file.shell.ground,
        deployment=file.deployment,
        panel=panel,
        stiffeners=stiffeners,
        plate_density=density,
        end_walls=file.end_wall,
        structure=structure,
        search=file.search,
        tables=raw,
        files=files,
        keys=keys,
    )
