"""What the studio's processes do: from the tables of a design to what its pages show."""

from __future__ import annotations

import base64
import io
import tempfile
import time
import zipfile
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np

from orishell.curves import Curve, trace_curve
from orishell.errors import ClashError, DesignError, InputError, OrishellError
from orishell.io import LAST, Settings
from orishell.io.registry import find_formats
from orishell.io.view import contact_of, dump_view
from orishell.overlays import lay_surface
from orishell.report import ClashTest, Shell, make_shell
from orishell.spec import DesignFile, check_design
from orishell.studio.dropped import read_dropped
from orishell.studio.ranges import find_ranges
from orishell.studio.workers import Payload, Progress, Task
from orishell.toml_file import parse_toml
from orishell.units import MILLIMETRES
from orishell.writing import write_format

MAX_VERTICES = 60_000
"""Vertices of a sheet in the studio, at most; the command line takes more."""
DRAWN = 200
"""Points of a curve that are drawn, about."""
ZIP_DATE = (1980, 1, 1, 0, 0, 0)
NAME = "shell"
"""What a design is called that has no name."""


class RefusedDesignError(OrishellError):
    """A design that cannot be made, of curves that can be drawn all the same."""

    def __init__(self, error: OrishellError, curves: dict[str, Any]) -> None:
        super().__init__(str(error))
        self.error = error
        self.curves = curves


def describe_error(error: OrishellError) -> dict[str, Any]:
    """An error field by field.

    Parameters
    ----------
    error
        The error.
    """
    if isinstance(error, RefusedDesignError):
        return {**describe_error(error.error), "curves": error.curves}
    fields = ("what", "where", "got", "expected", "remedy", "condition", "place", "size", "limit")
    found = {name: getattr(error, name, "") for name in fields}
    kind, remedies = ("design", error.remedies) if isinstance(error, DesignError) else ("input", ())
    return {
        "error": {
            **found,
            "what": found["what"] or found["condition"],
            "kind": kind,
            "message": str(error).removeprefix(f"{NAME}.toml: "),
            "remedies": [
                {"text": str(remedy), "changes": dict(remedy.changes)} for remedy in remedies
            ],
        },
    }


def make_view(payload: Payload, advanced: Progress) -> bytes:
    """The view of a design, contact and distances not examined yet.

    Parameters
    ----------
    payload
        What the page sent: the tables of a design under "design", and what the task asks for.
    advanced
        Is told the share that is done, and of what.

    Raises
    ------
    InputError
        If there is no design in the payload, or the number of states is none.
    RefusedDesignError
        If the design cannot be made; holds its curves.
    """
    file = _read(payload, tolerated=True)
    curves = {"f": _sampled(file.f, "f"), "g": _sampled(file.g, "g")}
    frames = payload.get("states", 25)
    if not isinstance(frames, int) or isinstance(frames, bool):
        raise InputError(
            "the number of states is a whole number", where="states", got=repr(frames)[:40]
        )
    try:
        shell = make_shell(
            replace(file, frames=min(max(frames, 2), 50)),
            clash_test=ClashTest(skipped=True),
            searched=lambda share: advanced(share, "choosing rows and columns"),
            measured=False,
        )
    except OrishellError as error:
        raise RefusedDesignError(error, curves) from None
    document = lay_surface(shell.document, shell.design, measured=False)
    document = replace(document, report=shell.report)
    return dump_view(document, {"curves": curves})


def verify(payload: Payload, advanced: Progress) -> dict[str, Any]:
    """The full report of a design, with its contact and the distances of its vertices.

    Parameters
    ----------
    payload
        What the page sent: the tables of a design under "design", and what the task asks for.
    advanced
        Is told the share that is done, and of what.
    """
    file = _read(payload)
    refusal = None
    try:
        shell = _examined(file, advanced, allowed=False)
    except ClashError as error:
        refusal = describe_error(error)["error"]
        shell = _examined(file, advanced, allowed=True)
    document = lay_surface(shell.document, shell.design)
    assert document.distances is not None
    distances = base64.b64encode(document.distances.astype("<f4").tobytes()).decode()
    result = {
        "report": shell.report,
        "contact": contact_of(shell.report, document.grid_shape),
        "distance": distances,
        "refusal": refusal,
    }
    if file.pattern.flap == "auto":  # it may be narrower now than the view had it
        view = dump_view(replace(document, report=shell.report))
        result["view"] = base64.b64encode(view).decode()
    return result


def ranges(payload: Payload, advanced: Progress) -> dict[str, Any]:
    """Admissible values of the numeric parameters.

    Parameters
    ----------
    payload
        What the page sent: the tables of a design under "design", and what the task asks for.
    advanced
        Is told the share that is done, and of what.
    """
    file = _read(payload)
    begin = time.perf_counter()
    try:
        file.pattern.design(file.f, file.g)
    except OrishellError:
        advanced(0.0, "looking for admissible values")
    found = find_ranges(file, advanced, time.perf_counter() - begin)
    return {"ranges": {key: asdict(each) for key, each in found.items()}}


def parse(payload: Payload, advanced: Progress) -> dict[str, Any]:
    """The tables of a design file's text, checked.

    Parameters
    ----------
    payload
        What the page sent: the tables of a design under "design", and what the task asks for.
    advanced
        Is told the share that is done, and of what.

    Raises
    ------
    InputError
        If it is not TOML, or no design.
    """
    tables = parse_toml(str(payload.get("text", "")))
    _read({**payload, "design": tables})
    return {"design": tables}


def write_toml(payload: Payload, advanced: Progress) -> dict[str, Any]:
    """The text of a design file.

    Parameters
    ----------
    payload
        What the page sent: the tables of a design under "design", and what the task asks for.
    advanced
        Is told the share that is done, and of what.

    Raises
    ------
    InputError
        If there is no design.
    """
    import tomli_w

    _read(payload)
    return {"text": tomli_w.dumps(payload["design"])}


def read_curve(payload: Payload, advanced: Progress) -> dict[str, Any]:
    """Points of a curve in a CSV, SVG or DXF file that was dropped onto the page.

    Parameters
    ----------
    payload
        What the page sent: the tables of a design under "design", and what the task asks for.
    advanced
        Is told the share that is done, and of what.

    Raises
    ------
    InputError
        If there is no such unit, or no curve in the file.
    """
    name, content, unit = (str(payload.get(key, "")) for key in ("name", "content", "unit"))
    if unit not in MILLIMETRES:
        raise InputError("there is no such unit", where="unit", got=repr(unit))
    return read_dropped(name, content, unit)


def export(payload: Payload, advanced: Progress) -> tuple[str, bytes]:
    """The name and the bytes of a file in a format, or of an archive of several.

    Parameters
    ----------
    payload
        What the page sent: the tables of a design under "design", and what the task asks for.
    advanced
        Is told the share that is done, and of what.

    Raises
    ------
    InputError
        If not one format is named, or the design is refused.
    """
    formats = find_formats([str(payload.get("format"))])
    if len(formats) != 1:
        raise InputError("not one format is named", where="format", got=repr(payload.get("format")))
    (format_,) = formats
    file = _read(payload)
    shell = _examined(file, advanced, allowed=True)
    settings = Settings(state=_state(payload.get("state")), workshop=file.workshop)
    with tempfile.TemporaryDirectory(prefix="orishell-") as directory:
        write_format(shell, format_, Path(directory), settings)
        paths = sorted(Path(directory).iterdir())
        if len(paths) == 1:
            return paths[0].name, paths[0].read_bytes()
        archive = io.BytesIO()
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
            for path in paths:
                packed.writestr(zipfile.ZipInfo(path.name, ZIP_DATE), path.read_bytes())
        return f"{Path(format_.file).stem}-{format_.name}.zip", archive.getvalue()


TASKS: dict[str, Task] = {
    "design": make_view,
    "verify": verify,
    "ranges": ranges,
    "parse": parse,
    "format": write_toml,
    "curve": read_curve,
    "export": export,
}


def _read(payload: Payload, *, tolerated: bool = False) -> DesignFile:
    """The design file of a payload, small enough for the studio."""
    design = payload.get("design")
    if not isinstance(design, dict):
        raise InputError("there is no design", where="design", expected="its tables")
    name = "".join(
        each for each in str(payload.get("name", NAME)) if each.isalnum() or each in "-_ "
    )
    file = check_design(design, Path(f"{name or NAME}.toml"), files=False)
    file.require_target()
    if file.tolerance is not None and not tolerated:
        return file
    vertices = (file.pattern.rows + 2) * (file.pattern.columns + 2)
    if vertices > MAX_VERTICES:
        raise InputError(
            "the sheet is too large for the studio",
            where="[pattern] rows, columns",
            got=f"{vertices} vertices",
            expected=f"at most {MAX_VERTICES}",
            remedy="use orishell design",
        )
    return file


def _examined(file: DesignFile, advanced: Progress, *, allowed: bool) -> Shell:
    test = ClashTest(
        allowed=allowed,
        advanced=lambda share: advanced(share, "looking for contact"),
        mended=lambda share: advanced(share, "looking for what works"),
    )
    return make_shell(
        file, clash_test=test, searched=lambda share: advanced(share, "choosing rows and columns")
    )


def _sampled(curve: Curve, name: str) -> list[list[float]]:
    """Points of a curve as it is drawn; empty if it is none."""
    try:
        trace = trace_curve(curve, name)
    except InputError:
        return []
    kept = np.unique(np.rint(np.linspace(0, len(trace.points) - 1, DRAWN)).astype(int))
    corners = np.flatnonzero(np.abs(trace.heading - trace.arriving) > 0)
    points = trace.points[np.union1d(kept, corners[:DRAWN])]
    return [[float(x), float(y)] for x, y in points]


def _state(value: object) -> int:
    if value in (None, "locked"):
        return LAST
    if value == "flat":
        return 0
    if isinstance(value, int) and not isinstance(value, bool) and value >= 0:
        return value
    raise InputError("there is no such state", where="state", got=repr(value))
