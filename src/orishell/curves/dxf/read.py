"""One curve from a DXF file: what stands in its modelspace, in a unit of length."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypeVar

import numpy as np

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.curves.dxf.entities import CURVE_TYPES, FLAT, Drawn, draw_entity, layer_of, name_of
from orishell.curves.files import MAX_BYTES, name_parts, read_source
from orishell.curves.joining import Chain, join_pieces
from orishell.curves.pieces import MAX_PIECES, Piece

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
MAX_DEPTH = 16
"""How deep blocks may be inserted into each other."""
LISTED = 12
DRAWN_TYPES: Final = {*CURVE_TYPES, "INSERT"}


def read_dxf(
    path: Path,
    *,
    into: str,
    layer: str | None = None,
    handle: str | None = None,
    unit: str | None = None,
) -> Chain:
    """The curve that the modelspace of a DXF file draws.

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
        None, the file is taken to be in the unit of the result.

    Raises
    ------
    InputError
        If the file cannot be read, has no such layer or entity, or what it draws is not flat or
        makes no curve with two ends; with the file and the place.
    """
    choice = f" layer {layer!r}" if layer is not None else f" handle {handle}" if handle else ""
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused when joined
            stated, drawn = read_entities(path, lambda document: _drawn(document, layer, handle))
        name, size = (unit, MILLIMETRES[unit]) if unit else stated or (into, MILLIMETRES[into])
        require_one_plane(drawn)
        pieces = [piece for each in drawn for piece in each.pieces]
        try:
            joined = join_pieces(pieces, lambda point: f"({point[0]:.6g}, {point[1]:.6g}) {name}")
        except CurveError as error:
            raise _naming(error, drawn) from None
    except InputError as error:
        raise error.located(f"{path}{choice}:") from None
    return joined.scaled(1.0 if name == into else size / MILLIMETRES[into])


def _naming(error: CurveError, drawn: list[Drawn]) -> CurveError:
    """The error about all pieces, with their entities and what there is to choose."""
    together: dict[str, list[Piece]] = {}
    for each in drawn:
        for choice in each.choices:
            together.setdefault(choice, []).extend(each.pieces)
    return name_parts(
        error,
        [(each.name, each.pieces) for each in drawn],
        sorted(together.items(), key=lambda item: item[0].startswith("handle")),
        "put the entities that are meant on a layer of their own and choose it with layer, or "
        "remove the others",
    )


def _require_end(content: bytes) -> None:
    """Refuse a file that is cut off: ezdxf might read its first half."""
    if content.startswith(b"AC10"):
        raise InputError("this is DWG, not DXF", remedy="save it as DXF in the CAD program")
    if not content.rstrip(b"\0\x1a \t\r\n").endswith(b"EOF"):
        raise InputError(
            "this is not DXF, or it is cut off", got="no EOF at the end", remedy="save it again"
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


def _drawn(document: Drawing, layer: str | None, handle: str | None) -> list[Drawn]:
    """What the chosen entities draw."""
    return [
        replace(draw_entity(each), choices=_choices(each, on))
        for each, on in _chosen(document, layer, handle)
    ]


def _choices(entity: DXFEntity, on: str) -> tuple[str, ...]:
    """How to choose an entity, or its layer; one in a block has no handle of its own."""
    handle = _handle(entity)
    return (f'layer = "{on}"', *([f'handle = "{handle}"'] if handle else []))


def _chosen(
    document: Drawing, layer: str | None, handle: str | None
) -> list[tuple[DXFEntity, str]]:
    space = document.modelspace()
    if handle is not None:
        found = [each for each in space if _handle(each) == handle.upper().lstrip("0")]
        if not found:
            raise _unknown(
                "handle", handle, [_handle(each) for each in space if each.dxftype() in CURVE_TYPES]
            )
        curves = list(_exploded(found, "0"))
        if not curves:
            raise InputError(
                "this entity is no curve",
                got=name_of(found[0]),
                expected="one of " + ", ".join(CURVE_TYPES),
            )
        return curves
    if layer is None:
        return visible_curves(document)
    curves = list(_exploded(space, None))
    chosen = [(entity, on) for entity, on in curves if on.casefold() == layer.casefold()]
    if not chosen:
        raise _unknown("layer", layer, sorted({on for _, on in curves}))
    return chosen


def visible_curves(document: Drawing, most: int = MAX_PIECES) -> list[tuple[DXFEntity, str]]:
    """All curves of the modelspace that are not on a layer which is off, with their layers.

    Raises InputError: If there are more than ``most``, or blocks inserted without end.
    """
    unseen = {
        each.dxf.name.casefold() for each in document.layers if each.is_off() or each.is_frozen()
    }
    curves = _exploded(document.modelspace(), None, most=most)
    return [(entity, on) for entity, on in curves if on.casefold() not in unseen]


def _exploded(
    entities: Iterable[DXFEntity], layer: str | None, depth: int = 0, most: int = MAX_PIECES
) -> Iterator[tuple[DXFEntity, str]]:
    """Visible curves and the layers that they count for, those in inserted blocks among them."""
    from ezdxf.entities.insert import Insert

    count = 0
    for entity in entities:
        if entity.dxftype() not in DRAWN_TYPES or entity.dxf.get("invisible", 0):
            continue
        own = layer_of(entity)
        on = layer if layer is not None and own == "0" else own
        if isinstance(entity, Insert):
            if depth >= MAX_DEPTH:
                raise InputError(
                    "blocks are inserted into each other without end",
                    got=name_of(entity),
                    expected=f"at most {MAX_DEPTH} levels",
                )
            if entity.mcount > most:
                raise InputError("a block is inserted too often", got=name_of(entity))
            inserts = entity.multi_insert() if entity.mcount > 1 else [entity]
            found: Iterator[tuple[DXFEntity, str]] = chain.from_iterable(
                _exploded(insert.virtual_entities(), on, depth + 1, most) for insert in inserts
            )
        else:
            found = iter([(entity, on)])
        for each in found:
            count += 1
            if count > most:
                raise InputError("the drawing has too many entities", expected=f"at most {most}")
            yield each


def require_one_plane(drawn: list[Drawn]) -> None:
    """Refuse curves that lie above each other: seen from above they would seem to meet.

    Raises InputError: Naming one that lies elsewhere than the first.
    """
    if not drawn:
        return
    level = float(drawn[0].z[0])
    reach = max(each.reach for each in drawn)
    for each in drawn:
        if not np.abs(each.z - level).max() <= FLAT * reach:
            raise InputError(
                "the entities lie in different planes",
                where=each.name,
                got=f"z = {each.z[0]:.6g}",
                expected=f"{level:.6g}, as {drawn[0].name} has",
                remedy="move them into one plane, or choose one with layer or handle",
            )


def _handle(entity: DXFEntity) -> str:
    return str(entity.dxf.get("handle") or "").upper().lstrip("0")


def _unknown(key: str, wanted: str, known: list[str]) -> InputError:
    more = f" and {len(known) - LISTED} more" if len(known) > LISTED else ""
    return InputError(
        f"there is no curve {'on' if key == 'layer' else 'with'} this {key}",
        got=repr(wanted[:60]),
        expected="one of " + ", ".join(known[:LISTED]) + more if known else "",
        remedy="" if known else "the modelspace has no curves",
    )
