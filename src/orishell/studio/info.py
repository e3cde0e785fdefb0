"""What a page loads first, field by field: what there is to choose from, and limits."""

from __future__ import annotations

from typing import Literal, NotRequired, TypedDict

from orishell.conventions.table import Kind, Measure
from orishell.families.pattern import Aim
from orishell.studio.api import Tables


class Parameter(TypedDict):
    """A parameter of a family, or a setting of the workshop, as a control shows it."""

    key: str
    label: str
    help: str
    kind: Kind
    auto: bool
    unit: Measure
    choices: list[str]
    default: float | str | bool | None  # null: the design must give it
    only: Aim | None  # the target without which it has no meaning
    advanced: bool  # whether it is folded away until it is asked for
    # how far the slider reaches; left out where that depends on the curves
    slider: NotRequired[tuple[float, float]]
    step: NotRequired[float]  # between two of its places


class Family(TypedDict):
    """A family of crease patterns."""

    label: str
    what: str
    borders: str  # what the panels beside its inner columns are
    aims: list[Aim]  # what its shells can follow
    parameters: list[Parameter]


class KeyWords(TypedDict):
    """A key of the design file in words."""

    label: str
    help: str  # one line on what it does
    unit: Measure  # of its values: "length" is the design's unit
    # its values and their labels, the default first; empty where they are not listed
    choices: dict[str, str]


class TableWords(TypedDict):
    """A table of the design file in words."""

    label: str  # the section of the page that has its controls; empty where there is none
    keys: dict[str, KeyWords]


class MaterialFacts(TypedDict):
    """What panels may be made of."""

    name: str
    modulus: float  # Young's modulus (N/m2)
    strength: float  # what it bears (N/m2)
    density: float  # mass by volume (kg/m3)
    grain: bool  # whether it bears by its grain
    sandwich: bool  # whether it is faces on a core
    conservative: str  # what is on the safe side in these values, and what is not


class Example(TypedDict):
    """A design to begin with: its tables, and the text of its file."""

    name: str
    title: str
    text: str
    design: Tables


class FileFormat(TypedDict):
    """A format of files that a shell can be written in."""

    name: str
    file: str
    what: str
    # what the design must have for it: panels with a thickness, or loads; empty where any will do
    needs: Literal["", "thickness", "loads"]


class Archive(FileFormat):
    """Files of several formats in one archive."""

    settings: list[str]  # the keys of the table [workshop] that matter to it


class ExportTask(TypedDict):
    """What one writes files for."""

    name: str
    label: str
    what: str  # what is written, in a sentence
    archives: list[Archive]  # they come before its formats
    formats: list[str]  # the names of its formats
    settings: list[str]  # the keys of the table [workshop] that matter to it
    state: bool  # whether its files show one state, which is chosen
    # what is shown of it before it is written
    preview: Literal["sheets", "paper", "booklet", "shell"]


class Largest(TypedDict):
    """Limits of the studio: vertices of a sheet, bytes of a request, seconds of a design."""

    vertices: int
    bytes: int
    seconds: float


class NamedDesign(TypedDict):
    """The design file that the studio was started with."""

    name: str
    design: Tables


class SearchFigure(TypedDict):
    """A figure that a search can make small, or keep within limits."""

    name: str
    words: str  # its name in words
    unit: str  # its unit, "{unit}" standing for that of lengths; empty where it has none
    of_structure: bool  # whether it is there only where the design has a table [structure]
    most: float | None  # its limit where the table [search] sets none; null if it has none then


class SearchInfo(TypedDict):
    """What a search can be for."""

    figures: list[SearchFigure]
    evaluations: int  # designs that are made at most where the table [search] does not say it
    install: str  # the command that installs what a search needs; empty where that is installed


class Info(TypedDict):
    """What the page loads first: what there is to choose from, limits, the design to open."""

    version: str
    units: list[str]
    families: dict[str, Family]
    examples: list[Example]
    formats: list[FileFormat]
    tasks: list[ExportTask]
    workshop: list[Parameter]
    tables: dict[str, TableWords]
    materials: list[MaterialFacts]
    search: SearchInfo
    limits: Largest
    start: NamedDesign | None
