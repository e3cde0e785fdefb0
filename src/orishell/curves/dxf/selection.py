"""Which entities of a DXF file's modelspace are meant, those in inserted blocks among them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from itertools import chain
from typing import TYPE_CHECKING, Final

from orishell.conventions.errors import InputError
from orishell.curves.dxf.entities import CURVE_TYPES, layer_of, name_of
from orishell.curves.pieces import MAX_PIECES

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.entities.dxfentity import DXFEntity

MAX_DEPTH = 16
"""How deep blocks may be inserted into each other."""
LISTED = 12
DRAWN_TYPES: Final = {*CURVE_TYPES, "INSERT"}
LIGHTER: Final = (
    "copy the curve into a file of its own (WBLOCK in AutoCAD, Export Selected in Rhino)"
)
EXPLODE: Final = "EXPLODE makes lines, arcs and polylines of what is made of them"


def chosen_curves(
    document: Drawing, layer: str | None, handle: str | None
) -> list[tuple[DXFEntity, str]]:
    """The curves on a layer, or of the entity with a handle, or all that are seen; their layers.

    Raises InputError: If there are none.
    """
    space = document.modelspace()
    if handle is not None:
        found = [each for each in space if handle_of(each) == handle.upper().lstrip("0")]
        if not found:
            raise _unknown(
                "handle",
                handle,
                [handle_of(each) for each in space if each.dxftype() in CURVE_TYPES],
            )
        curves = list(_exploded(found, "0"))
        if not curves:
            raise InputError(
                "this entity is no curve",
                got=name_of(found[0]),
                expected="one of " + ", ".join(CURVE_TYPES),
                remedy=EXPLODE,
            )
        return curves
    if layer is None:
        seen = visible_curves(document)
        if not seen:
            raise _nothing(document)
        return seen
    curves = list(_exploded(space, None))
    chosen = [(entity, on) for entity, on in curves if on.casefold() == layer.casefold()]
    if not chosen:
        raise _unknown("layer", layer, sorted({on for _, on in curves}))
    return chosen


def visible_curves(document: Drawing, most: int = MAX_PIECES) -> list[tuple[DXFEntity, str]]:
    """All curves of the modelspace that are not on a layer which is off, with their layers.

    Raises InputError: If there are more than ``most``, or blocks inserted without end.
    """
    frozen = {each.dxf.name.casefold() for each in document.layers if each.is_frozen()}
    off = {each.dxf.name.casefold() for each in document.layers if each.is_off()}
    curves = _exploded(document.modelspace(), None, most=most, frozen=frozen)
    return [(entity, on) for entity, on in curves if on.casefold() not in frozen | off]


def _exploded(
    entities: Iterable[DXFEntity],
    layer: str | None,
    depth: int = 0,
    most: int = MAX_PIECES,
    frozen: Collection[str] = (),
) -> Iterator[tuple[DXFEntity, str]]:
    """Visible curves and the layers that they count for, those in inserted blocks among them.

    What is inserted on a frozen layer is not seen, whatever its own.
    """
    from ezdxf.entities.insert import Insert

    count = 0
    for entity in entities:
        if entity.dxftype() not in DRAWN_TYPES or entity.dxf.get("invisible", 0):
            continue
        own = layer_of(entity)
        on = layer if layer is not None and own == "0" else own
        if isinstance(entity, Insert):
            if on.casefold() in frozen:
                continue
            if depth >= MAX_DEPTH:
                raise InputError(
                    "blocks are inserted into each other without end",
                    got=name_of(entity),
                    expected=f"at most {MAX_DEPTH} levels",
                    remedy=EXPLODE,
                )
            if entity.mcount > most:
                raise InputError(
                    "a block is inserted too often", got=name_of(entity), remedy=LIGHTER
                )
            inserts = entity.multi_insert() if entity.mcount > 1 else [entity]
            found: Iterator[tuple[DXFEntity, str]] = chain.from_iterable(
                _exploded(insert.virtual_entities(), on, depth + 1, most, frozen)
                for insert in inserts
            )
        else:
            found = iter([(entity, on)])
        for each in found:
            count += 1
            if count > most:
                raise InputError(
                    "the drawing has too many entities",
                    expected=f"at most {most}",
                    remedy=LIGHTER,
                )
            yield each


def _nothing(document: Drawing) -> InputError:
    """What there is where no curve is seen."""
    space = document.modelspace()
    hidden = sorted({on for _, on in _exploded(space, None)})
    if hidden:
        got = "curves that are not seen, on " + ", ".join(map(repr, hidden[:LISTED]))
        remedy = " or ".join(f'layer = "{on}"' for on in hidden[:LISTED])
        return InputError("nothing is drawn here", got=got, remedy=f"choose one with {remedy}")
    counts = Counter(each.dxftype() for each in space)
    got = ", ".join(f"{count} {kind}" for kind, count in counts.most_common(LISTED))
    paper = sum(len(layout) for layout in document.layouts if not layout.is_modelspace)
    moved = "CHSPACE moves what is in paper space into the modelspace"
    return InputError(
        "nothing is drawn here",
        got=got or (f"{paper} in paper space" if paper else ""),
        expected=f"one of {', '.join(CURVE_TYPES)} in the modelspace",
        remedy=EXPLODE if got else moved if paper else "draw the curve there",
    )


def handle_of(entity: DXFEntity) -> str:
    """The handle of an entity, as it is compared; empty if it has none."""
    return str(entity.dxf.get("handle") or "").upper().lstrip("0")


def _unknown(key: str, wanted: str, known: list[str]) -> InputError:
    more = f" and {len(known) - LISTED} more" if len(known) > LISTED else ""
    return InputError(
        f"there is no curve {'on' if key == 'layer' else 'with'} this {key}",
        got=repr(wanted[:60]),
        expected="one of " + ", ".join(known[:LISTED]) + more if known else "",
        remedy=f"choose one of these, or leave {key} out"
        if known
        else "draw the curve in the modelspace",
    )
