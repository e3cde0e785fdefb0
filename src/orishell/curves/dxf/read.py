"""One curve from a DXF file: what stands in its modelspace, in a unit of length."""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypeVar

import numpy as np

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.curves.dxf.entities import Drawn, draw_in_plane
from orishell.curves.dxf.selection import chosen_curves, handle_of
from orishell.curves.files import MAX_BYTES, name_parts, read_source, require_kind
from orishell.curves.joining import Chain, join_pieces
from orishell.curves.pieces import Piece

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.entities.dxfentity import DXFEntity

T = TypeVar("T")

UNITS: Final[dict[int, tuple[str, float]]] = {
    1: ("in", 25.4),
    2: ("ft", 304.8),
    3: ("mi", 1609344.0),
    4: ("mm", 1.0),
    5: ("cm", 10.0),
    6: ("m", 1e3),
    7: ("km", 1e6),
    8: ("uin", 25.4e-6),
    9: ("mil", 25.4e-3),
    10: ("yd", 914.4),
    11: ("A", 1e-7),
    12: ("nm", 1e-6),
    13: ("um", 1e-3),
    14: ("dm", 100.0),
    15: ("dam", 1e4),
    16: ("hm", 1e5),
    17: ("Gm", 1e12),
    21: ("survey ft", 1200e3 / 3937),
    22: ("survey in", 100e3 / 3937),
    23: ("survey yd", 3600e3 / 3937),
    24: ("survey mi", 1200e3 / 3937 * 5280),
}
"""Name and millimetres of each value of ``$INSUNITS`` (ezdxf's factors are good to 1e-11 only)."""
CHOSEN: Final = "on a layer of their own and choose it with layer"


def read_dxf(
    path: Path,
    *,
    into: str,
    layer: str | None = None,
    handle: str | None = None,
    unit: str | None = None,
    join: float | None = None,
) -> Chain:
    """The curve that the modelspace of a DXF file draws, seen from above.

    Where it lies in no plane of constant z it may lie in one of constant y, or x: then z is its
    height, and its notes say so.

    Parameters
    ----------
    path
        The file, as text or binary, of any version.
    into
        Unit of length of the result.
    layer
        The layer that is read, capitals or not; entities of a block on layer 0 count as the
        insertion's. Otherwise every layer that is not off or frozen.
    handle
        The one entity that is read.
    unit
        The file's unit, whatever its ``$INSUNITS`` says. If that is absent or 0, and this is
        None, the file is taken to be in the unit of the result, and its notes say so.
    join
        How far apart loose ends may be, in the file's unit.

    Raises
    ------
    InputError
        If the file cannot be read, has no such layer or entity, or what it draws is not flat or
        makes no curve with two ends; with the file and the place.
    """
    choice = f" layer {layer!r}" if layer is not None else f" handle {handle}" if handle else ""
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused when joined
            look = partial(_drawn, layer=layer, handle=handle)
            stated, (drawn, notes) = read_entities(path, look)
        name, size = (unit, MILLIMETRES[unit]) if unit else stated or (into, MILLIMETRES[into])
        if unit is None and stated is None:
            notes = (*notes, f"the file states no unit of length: its numbers were read as {into}")
        pieces = [piece for each in drawn for piece in each.pieces]
        try:
            joined = join_pieces(
                pieces, lambda point: f"({point[0]:.15g}, {point[1]:.15g}) {name}", join, name
            )
        except CurveError as error:
            raise _naming(error, drawn, join) from None
    except InputError as error:
        raise error.located(f"{path}{choice}:") from None
    joined = replace(joined, notes=(*notes, *joined.notes))
    return joined.scaled(1.0 if name == into else size / MILLIMETRES[into])


def _naming(error: CurveError, drawn: list[Drawn], join: float | None) -> CurveError:
    """The error about all pieces, with their entities and what there is to choose."""
    together: dict[str, list[Piece]] = {}
    for each in drawn:
        for choice in each.choices:
            together.setdefault(choice, []).extend(each.pieces)
    return name_parts(
        error,
        [(each.name, each.pieces) for each in drawn],
        sorted(together.items(), key=lambda item: item[0].startswith("handle")),
        otherwise=f"put the entities that are meant {CHOSEN}, or remove the others",
        alone=f"EXPLODE it, and put the pieces that are meant {CHOSEN}",
        join=join,
    )


def _require_end(content: bytes) -> None:
    """Refuse a file that is cut off: ezdxf might read its first half."""
    require_kind(content, "DXF")
    if not content.rstrip(b"\0\x1a \t\r\n").endswith(b"EOF"):
        raise InputError(
            "this is not DXF, or it is cut off",
            got="no EOF at the end",
            remedy="save it as DXF again",
        )


def read_entities(
    path: Path, look: Callable[[Drawing], T], most: int = MAX_BYTES
) -> tuple[tuple[str, float] | None, T]:
    """The unit that a DXF file states, one of :data:`UNITS`, and what ``look`` finds in it.

    Parameters
    ----------
    most
        Size that the file may have (bytes).

    Raises
    ------
    InputError
        If the file cannot be read, or is damaged.
    """
    from ezdxf.filemanagement import readfile

    content = read_source(path, "DXF file", most)
    _require_end(content)
    log = logging.getLogger("ezdxf")
    if not log.handlers:  # otherwise what it remarks on goes to standard error
        log.addHandler(logging.NullHandler())
    try:
        # Not ezdxf.recover: it drops what it cannot read, and half a profile looks like a whole.
        document = readfile(path)
        code = int(document.header.get("$INSUNITS", 0))
        found = look(document)
    except InputError:
        raise
    except Exception as error:  # in a damaged file ezdxf meets what it does not expect
        said = " ".join(str(error).encode("utf-8", "backslashreplace").decode().split())
        raise InputError(
            "this DXF file is damaged",
            got=f"{type(error).__name__}: {said[:120].rstrip('.')}",
            remedy="open it in a CAD program, repair it there and save it again",
        ) from None
    # Where the file says nothing, ezdxf says metres.
    return UNITS.get(code) if b"$INSUNITS" in content else None, found


def _drawn(
    document: Drawing, layer: str | None, handle: str | None
) -> tuple[list[Drawn], tuple[str, ...]]:
    """What the chosen entities draw, and what is to be said of it."""
    chosen = chosen_curves(document, layer, handle)
    drawn, notes = draw_in_plane([entity for entity, _ in chosen])
    return [
        replace(each, choices=_choices(entity, on))
        for each, (entity, on) in zip(drawn, chosen, strict=True)
    ], notes


def _choices(entity: DXFEntity, on: str) -> tuple[str, ...]:
    """How to choose an entity, or its layer; one in a block has no handle of its own."""
    handle = handle_of(entity)
    return (f'layer = "{on}"', *([f'handle = "{handle}"'] if handle else []))
