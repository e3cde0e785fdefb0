"""Answers to the pages' requests, computed in processes of their own."""

from __future__ import annotations

import base64
import contextlib
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Final

import numpy as np

from orishell.conventions.errors import ClashError, InputError, OrishellError
from orishell.conventions.memory import key_of
from orishell.conventions.progress import Progress, stretch
from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.record import as_table
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import DesignFile, check_design, starter_file
from orishell.families.registry import FAMILIES
from orishell.io.formats import all_formats
from orishell.io.view import Curves, dump_view
from orishell.shell.carry import find_carrying
from orishell.shell.designed import design_of
from orishell.shell.family_choice import FamilyTrial
from orishell.shell.make import Shell, make_shell
from orishell.shell.note_remedies import find_mend, find_mendable
from orishell.shell.open_questions import compare_families
from orishell.shell.pictures import lay_surface
from orishell.shell.steps import STEPS
from orishell.shell.tradeoff import Tradeoff, find_tradeoff
from orishell.studio.api import (
    NAME,
    Booklet,
    DrawingLook,
    DrawnSheetFacts,
    DrawnSurface,
    DroppedCurve,
    DroppedTarget,
    Fault,
    Mended,
    Parsed,
    Ranges,
    Refusal,
    SearchState,
    Sheets,
    Tables,
    Verified,
    Written,
)
from orishell.studio.drawings import (
    describe_drawing,
    looks_like_pattern,
    read_dropped_pattern,
    refused_sheet,
)
from orishell.studio.dropped import read_dropped, sampled
from orishell.studio.exports import export_shell, preview_booklet, require_exported
from orishell.studio.pages import design_name
from orishell.studio.processes import Send, ignore, require_small
from orishell.studio.ranges import find_ranges
from orishell.studio.refusals import RefusalError, describe_error
from orishell.studio.searches import search_variants
from orishell.studio.sheets import preview_sheets
from orishell.studio.sizes import head_of, measure_sizes
from orishell.studio.surfaces import coarser, draw_surface, read_dropped_mesh

COARSE = 0.1
"""Of the work of a fit, what a coarser one first is, about."""
OF_FILES = ("language", "paper", "paper_scale")
"""Settings of the workshop on which files depend, but no shell."""
FEWEST_STATES, STATES, MOST_STATES = 3, 25, 50
NO_CURVES: Curves = {"f": [], "g": []}


@dataclass(slots=True)
class Latest:
    """The shell that this process proved last: its files take no second proof."""

    key: str = ""
    shell: Shell | None = None

    def keep(self, key: str, shell: Shell) -> None:
        """Take the place of the shell before."""
        self.key, self.shell = key, shell

    def find(self, key: str) -> Shell | None:
        """The shell, if it is the one with this key."""
        return self.shell if key == self.key else None


LATEST = Latest()


@dataclass(frozen=True, slots=True)
class Task:
    """A request of a page; each method computes the answer to one kind."""

    payload: dict[str, Any]  # the tables under "design", and what else the answer takes
    progress: Progress
    send: Send = ignore  # is told what was found so far

    def warm_up(self) -> None:
        """Import what answers need, by answering: a small design of every family, and a proof."""
        all_formats()
        designs = [parse_toml(starter_file(family)) for family in FAMILIES]
        for design in designs:
            replace(self, payload={"design": design, "states": FEWEST_STATES}).make_view()
        designs[0]["pattern"] |= {"rows": 3, "columns": 3}
        replace(self, payload={"design": designs[0]}).verify()

    def make_view(self) -> bytes:
        """The view of a design, before rigidity, contact and distances are examined.

        Raises RefusalError, which holds its curves, if the design cannot be made.
        """
        file = self._design(tolerated=True)
        curves = NO_CURVES
        if file.target is not None:
            curves = {"f": sampled(file.f, "f"), "g": sampled(file.g, "g")}
        return self._view(file, self.progress, curves)

    def _view(self, file: DesignFile, progress: Progress, curves: Curves = NO_CURVES) -> bytes:
        """The view of a design, with its curves; a refusal holds these, too."""
        frames = self.payload.get("states", STATES)
        if not isinstance(frames, int) or isinstance(frames, bool):
            raise InputError(
                "the number of states must be a whole number", where="states", got=repr(frames)[:40]
            )
        try:
            states = min(max(frames, FEWEST_STATES), MOST_STATES)
            shown = file.changed({"motion.frames": states})
            shell = make_shell(shown, progress, clash="unexamined", skip=STEPS)
        except OrishellError as error:
            body: Refusal = {**describe_error(error), "curves": curves}
            drawing = None if file.drawing is None else refused_sheet(file.drawing)
            if drawing is not None:
                body["drawing"] = drawing
            raise RefusalError(body) from None
        document = lay_surface(shell.document, shell.design, measured=False)
        return dump_view(document, curves)

    def verify(self) -> Verified:
        """The full report of a design, its first contact and the distances of its vertices.

        What is known before its structure is, is told.
        """
        file = self._design()

        def tell(shell: Shell, refusal: Fault | None = None) -> None:
            self.send(self._verified(file, shell, refusal))

        refusal = None
        try:
            shell = make_shell(file, self.progress, told=tell)
        except ClashError as error:
            refusal = describe_error(error)["error"]
            told = partial(tell, refusal=refusal)
            shell = make_shell(file, self.progress, clash="allowed", told=told)
        LATEST.keep(self._key(), shell)
        return self._verified(file, shell, refusal)

    def mend(self) -> Mended:
        """A change of a design that does what its notes on a matter say, tried."""
        file, about = self._design(), str(self.payload.get("about"))
        shell, patient = LATEST.find(self._key()), bool(self.payload.get("patient"))
        report = None if shell is None else shell.report
        remedy = find_mend(file, about, self.progress, report, patient=patient)
        if remedy is None:
            return {"mend": None}
        return {"mend": {"text": str(remedy), "changes": dict(remedy.changes)}}

    def _verified(self, file: DesignFile, shell: Shell, refusal: Fault | None) -> Verified:
        """What pages are told of a shell; ``refusal`` says why its design is refused."""
        document = lay_surface(shell.document, shell.design).as_cut()
        distances = np.zeros(0) if document.distances is None else document.distances
        # Flaps of a width that the program chooses may be narrower now than the view had them, a
        # pack, where panels meet, less closed, and boards cut off where they would meet. What loads
        # do to the shell is found here only.
        met = file.deployment.start == "pack" and shell.lock.cause in {"clash", "unproved"}
        built = document.boards is not None or document.loaded is not None
        other = file.pattern.flap == "auto" or met or built
        notes = () if refusal is not None else shell.report.warnings
        mendable = find_mendable(file, notes, shell.analysis)
        return {
            "report": as_table(shell.report),
            "contact": document.contact,
            "distance": _text(distances.astype("<f4").tobytes()),
            "refusal": refusal,
            "mendable": as_table(mendable),
            "sizes": measure_sizes(shell, head_of(file)),
            "view": _text(dump_view(document)) if other else None,
        }

    def fit(self) -> str:
        """The view of a sheet that is fitted to its surface, in base64; a coarser one is first.

        Raises RefusalError if no sheet follows it.
        """
        file = self._design(tolerated=True)
        small = coarser(file)
        if small is not None:
            with contextlib.suppress(OrishellError):
                self.send(_text(self._view(small, stretch(self.progress, 0, COARSE))))
        return _text(self._view(file, stretch(self.progress, COARSE, 1)))

    def compare_families(self) -> dict[str, Any]:
        """What every family makes of a target, and which is taken; each is told of when it is done.

        Raises DesignError if none makes a shell.
        """
        tried: list[dict[str, Any]] = []

        def tell(trial: FamilyTrial) -> None:
            tried.append(as_table(trial))
            self.send(list(tried))

        found = compare_families(self._design(tolerated=True), self.progress, tell)
        return dict(as_table(found.answers.families))

    def draw_surface(self) -> DrawnSurface:
        """The target surface, before a shell is fitted to it."""
        file = self._design(tolerated=True)
        if file.surface is None:
            raise InputError("there is no surface", where="target")
        return draw_surface(file.surface, file.tables["target"]["surface"], file.unit)

    def read_mesh(self) -> DroppedTarget:
        """The table of a surface in the file of a mesh that was dropped onto the page."""
        return read_dropped_mesh(*self._dropped())

    def read_pattern(self) -> DroppedTarget:
        """The table of a drawn sheet in the file of a pattern that was dropped onto the page."""
        return read_dropped_pattern(*self._dropped(), self.payload.get("weld"))

    def look_at_drawing(self) -> DrawingLook:
        """Whether a drawing that was dropped onto the page is a crease pattern by its looks."""
        name, content, _ = self._dropped()
        return {"pattern": looks_like_pattern(name, content)}

    def describe_drawing(self) -> DrawnSheetFacts:
        """What is known of a drawn sheet, before a shell is made of it."""
        file = self._design()
        if file.drawing is None:
            raise InputError("there is no drawn sheet", where="target")
        return {"rows": list(describe_drawing(file.drawing, file.unit))}

    def find_ranges(self) -> Ranges:
        """Values of the numeric parameters that work."""
        file = self._design()
        if file.surface is not None or file.fit is not None:
            return {"ranges": {}}  # every value that is tried would be a fit
        begin = time.perf_counter()
        try:
            design_of(file, file.pattern)
        except OrishellError:
            self.progress(0.0, "looking for admissible values")
        return {"ranges": find_ranges(file, self.progress, time.perf_counter() - begin)}

    def parse(self) -> Parsed:
        """The tables of a design file, from its text, which is checked."""
        tables = parse_toml(str(self.payload.get("text", "")))
        replace(self, payload={**self.payload, "design": tables})._design(searched=True)
        return {"design": tables}

    def format(self) -> Written:
        """The text of a design file, from its tables."""
        import tomli_w

        self._design(searched=True)
        return {"text": tomli_w.dumps(self.payload["design"])}

    def read_curve(self) -> DroppedCurve:
        """The table of a curve in a CSV, SVG or DXF file that was dropped onto the page."""
        return read_dropped(*self._dropped())

    def _dropped(self) -> tuple[str, str, str]:
        """Name and content of a file that was dropped onto the page, and the unit of the design."""
        name, content, unit = (
            str(self.payload.get(key, "")) for key in ("name", "content", "unit")
        )
        if unit not in MILLIMETRES:
            raise InputError("there is no such unit", where="unit", got=repr(unit))
        return name, content, unit

    def find_tradeoff(self) -> Tradeoff:
        """How near sheets of many sizes come to the surface."""
        file = self._design()
        size, own = self.payload.get("size"), None
        if isinstance(size, dict):
            # Where sizes are to be chosen, those of the shell on the screen.
            shown = {f"pattern.{key}": size.get(key) for key in ("rows", "columns")}
            sized = file.changed({"tolerance": None, **shown})
            require_small(sized)
            own = (sized.pattern.rows, sized.pattern.columns)
        return find_tradeoff(file, self.progress, size=own)

    def search(self) -> SearchState:
        """What :func:`search_variants` finds."""
        path = self._design(searched=True).path
        return search_variants(self.payload["design"], path, self.progress, self.send)

    def make_it_carry(self) -> dict[str, Any]:
        """Designs that carry all load cases; what was tried so far is told."""
        found = find_carrying(self._design(), self.progress, lambda tried: self.send(list(tried)))
        return dict(as_table(found))

    def draw_sheets(self) -> Sheets:
        """The drawings that a workshop gets."""
        return preview_sheets(self._design(), self._name(), self.progress)

    def draw_booklet(self) -> Booklet:
        """The booklet of a kit, or the one that is written alone."""
        return preview_booklet(self._proved(), str(self.payload.get("format")), self.progress)

    def export(self) -> tuple[str, bytes]:
        """Name and bytes of the design in one format: a file, or a zip archive of several."""
        require_exported(self.payload)
        return export_shell(self._proved(), self.payload, self._name(), self.progress)

    def _proved(self) -> Shell:
        """The shell of the design, which files are written of, whether or not panels meet."""
        file = self._design()
        shell = LATEST.find(self._key()) or make_shell(file, self.progress, clash="allowed")
        LATEST.keep(self._key(), shell)
        return replace(shell, file=replace(shell.file, workshop=file.workshop))

    def _key(self) -> str:
        """What the shell of the design depends on: its tables, and the name that files show."""
        design = dict(self.payload["design"])
        workshop = design.get("workshop", {})
        design["workshop"] = {key: each for key, each in workshop.items() if key not in OF_FILES}
        return key_of("shell", self._name(), repr(design))

    def _name(self) -> str:
        return design_name(str(self.payload.get("name", NAME)))

    def _design(self, *, tolerated: bool = False, searched: bool = False) -> DesignFile:
        """The design file of the payload, small enough for the studio.

        What is wrong with the table [search] concerns only what asks for it.
        """
        design: Tables | None = self.payload.get("design")
        if not isinstance(design, dict):
            raise InputError("there is no design", where="design", expected="its tables")
        asked = {key: each for key, each in design.items() if searched or key != "search"}
        file = check_design(asked, Path(f"{self._name()}.toml"), files=False)
        if file.surface is None and file.pattern.sweeps():
            file.require_target()
        if file.tolerance is None or tolerated:
            require_small(file)
        return file


TASKS: Final[dict[str, Callable[[Task], Any]]] = {
    "warm_up": Task.warm_up,
    "design": Task.make_view,
    "families": Task.compare_families,
    "fit": Task.fit,
    "surface": Task.draw_surface,
    "mesh": Task.read_mesh,
    "pattern": Task.read_pattern,
    "drawing": Task.describe_drawing,
    "look": Task.look_at_drawing,
    "verify": Task.verify,
    "mend": Task.mend,
    "ranges": Task.find_ranges,
    "parse": Task.parse,
    "format": Task.format,
    "curve": Task.read_curve,
    "export": Task.export,
    "tradeoff": Task.find_tradeoff,
    "sheets": Task.draw_sheets,
    "booklet": Task.draw_booklet,
    "search": Task.search,
    "carry": Task.make_it_carry,
}


def answer(name: str, payload: dict[str, Any], progress: Progress, send: Send = ignore) -> Any:
    """The answer to a request of a page."""
    return TASKS[name](Task(payload, progress, send))


def _text(content: bytes) -> str:
    return base64.b64encode(content).decode()
