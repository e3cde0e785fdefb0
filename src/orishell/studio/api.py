"""What the studio's server answers to its pages, field by field: ``info`` is what they load first.

Their types in ``frontend/src/shared/api-types.ts`` are written from these.
"""

from __future__ import annotations

from typing import Any, Literal, NotRequired, TypedDict

from orishell.conventions.row import Row
from orishell.document import FirstContact
from orishell.io.view import Curves
from orishell.motion.crease_pattern import Mark
from orishell.shell.carry_found import CarrySearch
from orishell.shell.family_choice import FamilyChoice, FamilyTrial
from orishell.shell.note_remedies import Mendable
from orishell.shell.report import Report
from orishell.shell.tradeoff import Tradeoff
from orishell.workshop.palettes import Layer
from orishell.workshop.sheets import Waste

Tables = dict[str, Any]
"""The tables of a design file."""
FaultKind = Literal["input", "design", "limit", "time", "key", "fault"]
NAME = "shell"
"""The name of a design that was given none."""


class Remedy(TypedDict):
    """A change of the design that was tried and works."""

    text: str
    # values of keys of the design file, the tables in front of them; null removes a key
    changes: dict[str, Any]


class Fault(TypedDict):
    """What is wrong with a request or its design."""

    kind: FaultKind
    message: str  # all of it in one text
    what: str
    where: str
    keys: list[str]  # the keys of the design file that it is about, the tables in front of them
    got: str
    expected: str
    remedy: str
    detail: str
    place: str
    size: str
    limit: str  # what stands in the way, where nothing was found that works
    remedies: list[Remedy]  # what was tried and works, the nearest first


class RefusedDrawing(TypedDict):
    """A drawn sheet that is refused, to be shown with what is wrong with it."""

    lines: list[tuple[float, float, float, float]]  # from x, y to x, y
    letters: str  # what each is, as in FOLD
    marks: list[Mark]


class Refusal(TypedDict):
    """The answer to a request that failed; of a design, with the curves that can be drawn."""

    error: Fault
    curves: NotRequired[Curves]
    drawing: NotRequired[RefusedDrawing]  # of a drawn sheet


class Range(TypedDict):
    """Values of a parameter that were tried, and those that work."""

    span: tuple[float, float]  # those that were tried
    intervals: list[tuple[float, float]]  # those that work
    # whether all works that was tried below the first interval, and above the last
    beyond: tuple[bool, bool]
    # why values below the lowest interval, or above the highest, fail; empty at the span's end
    below: str
    above: str


class Ranges(TypedDict):
    """Values that work, for every parameter by its key."""

    ranges: dict[str, Range]


class Parsed(TypedDict):
    """The tables of a design file, read from its text."""

    design: Tables


class Written(TypedDict):
    """The text of a design file, made from its tables."""

    text: str


class CurveFields(TypedDict):
    """The table of a target curve that was read from a file: a path, or points."""

    path: NotRequired[str]
    points: NotRequired[list[list[float]]]
    smooth: NotRequired[bool]


class DroppedCurve(TypedDict):
    """A curve whose file was dropped onto the page, and a note on how it was read."""

    table: CurveFields
    note: str


class Patch(TypedDict):
    """A rectangle in plan: what of a surface is to be covered."""

    centre: tuple[float, float]
    size: tuple[float, float]  # along its own x and y
    turn_deg: float  # from the plan's x to its own


class DrawnSurface(TypedDict):
    """A target surface, to be drawn before a shell is fitted to it; arrays in base64."""

    points: str  # (rows, columns, 3) in single precision
    lattice: tuple[int, int]  # rows and columns
    rim: str  # (K, 3) once around, in single precision
    corners: tuple[int, int, int, int]  # which points of the rim are its corners
    patch: Patch | None  # what of it is covered; null: it is given in another way
    factor: tuple[float, float, float]  # by which x, y and z of its table are multiplied


class DroppedTarget(TypedDict):
    """A surface or a drawn sheet whose file was dropped onto the page, and how it was read."""

    table: dict[str, Any]
    note: str


class DrawingLook(TypedDict):
    """What a drawing that was dropped onto the page is, as far as its lines tell."""

    pattern: bool  # whether it has mountains, valleys and a border


class DrawnSheetFacts(TypedDict):
    """What is known of a drawn sheet before a shell is made of it."""

    rows: list[Row]


class BuiltSizes(TypedDict):
    """How large a shell is, by the keys of the table [target.fit] (lengths)."""

    outside: dict[str, float]
    # clear width and depth, and headroom, 0 where there is none; null: it does not stand
    inside: dict[str, float] | None
    head_height: float  # up to which width and depth are clear


class Verified(TypedDict):
    """A shell that has been verified: its report, contact and distances."""

    report: Report
    contact: FirstContact | None
    # distances of the vertices from the surface: single precision, in base64; empty without one
    distance: str
    # why the design is refused although its shell can be shown: panels meet before it locks
    refusal: Fault | None
    mendable: list[Mendable]  # notes that a change may mend, which nobody has tried
    sizes: BuiltSizes
    view: str | None  # A view in base64 that takes the place of the one shown; null: that one stays


class DrawnSheet(TypedDict):
    """One drawing for the workshop."""

    file: str  # the name of the file that it is exported to, without its ending
    title: str
    svg: str  # the drawing; its lines are wider than in the file, where that makes them visible


class LayerPen(TypedDict):
    """A layer of the drawings, its name in words and its colour ("#rrggbb")."""

    layer: Layer
    label: str
    colour: str


class PaperPages(TypedDict):
    """A paper model on its pages."""

    says: str  # its scale and pages in words; why there is none, if it takes too many
    svg: str  # a picture of the model with the frames and numbers of its pages; empty then


class Sheets(TypedDict):
    """The drawings that a workshop gets, and what they come to."""

    sheets: list[DrawnSheet]
    unit: str
    layers: list[LayerPen]  # those that are drawn somewhere, in the order of work
    palette: str  # what the palette is for
    stock: Waste  # sheets, waste, and length of cuts and creases, boards not counted
    boards: int | None  # sheets of stock for boards; null if there are none, or no stock
    paper: PaperPages


class BookletPicture(TypedDict):
    """A page of the booklet: what its first line says, and all of it."""

    title: str
    svg: str


class Booklet(TypedDict):
    """The booklet of a kit."""

    pages: list[BookletPicture]


class Advance(TypedDict):
    """The share of the work that is done, from 0 to 1, and what the work is."""

    progress: float
    what: str


class Mended(TypedDict):
    """What does what the notes on a matter say; null where nothing that was tried does."""

    mend: Remedy | None


class MendResult(TypedDict):
    """The last line of the answer: what does away with a note."""

    result: Mended


class Result(TypedDict):
    """The last line of the answer: the verified shell."""

    result: Verified


class VerifiedSoFar(TypedDict):
    """A line of the answer: what is known before the structure of the shell is."""

    found: Verified


class FitFound(TypedDict):
    """A line of the answer: the view of a coarser sheet, in base64."""

    found: str


class FitResult(TypedDict):
    """The last line of the answer: the view of the sheet that was fitted, in base64."""

    result: str


class FamiliesFound(TypedDict):
    """A line of the answer: what the families make of the target that were tried so far."""

    found: list[FamilyTrial]


class FamiliesResult(TypedDict):
    """The last line of the answer: what all make of it, and the one that is taken."""

    result: FamilyChoice


class TradeoffResult(TypedDict):
    """The last line of the answer: what fewer panels cost."""

    result: Tradeoff


class SheetsResult(TypedDict):
    """The last line of the answer: the drawings."""

    result: Sheets


class BookletResult(TypedDict):
    """The last line of the answer: the booklet."""

    result: Booklet


class SearchedDesign(TypedDict):
    """A design that was made."""

    values: dict[str, Any]  # what keys of the design file have in it, the tables in front of them
    figures: dict[str, float]  # its figures, by name


class FrontMember(TypedDict):
    """A design that no other beats."""

    number: int  # which it is of all designs that were sent, from 0
    costs: str  # what a step to it from the knee gains and costs, in words; empty for the knee


class Objective(TypedDict):
    """A figure that is to be small, and its name with its unit."""

    name: str
    label: str


class SearchState(TypedDict):
    """How far a search has come."""

    objectives: list[Objective]
    baseline: SearchedDesign | None  # the design as it was opened; null if it cannot be made
    designs: list[SearchedDesign]  # those that keep all limits and were not sent before
    front: list[FrontMember]  # those that no other beats, by their first objective
    knee: int  # place of the knee in the front; -1 where nothing is in it
    # designs that were made, or cannot be, and of how many at most
    made: int
    total: int
    # why designs cannot be made or break limits, the commonest reason first, and how many do
    refused: list[tuple[str, int]]


class SearchFound(TypedDict):
    """A line of the answer: how far the search has come."""

    found: SearchState


class SearchAnswer(TypedDict):
    """The last line of the answer: the search has come to its end."""

    result: SearchState


class CarryFound(TypedDict):
    """A line of the answer: what was tried so far, and how each trial ended."""

    found: list[str]


class CarryResult(TypedDict):
    """The last line of the answer: designs that carry, or what was tried in vain."""

    result: CarrySearch
