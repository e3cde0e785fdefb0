"""The plane that the curves of a DXF file lie in, seen from above, from the front or the right."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, cast

import numpy as np

from orishell.conventions.errors import InputError
from orishell.curves.dxf.entities import FLAT, Drawn, PlaneError, draw_entity

if TYPE_CHECKING:
    from ezdxf.entities.dxfentity import DXFEntity
    from ezdxf.entities.dxfgfx import DXFGraphic

VIEWS: Final = {
    "drawn in x and z, as seen from the front: z is its height": (0, 2, 1, -1),
    "drawn in y and z, as seen from the right: z is its height": (1, 2, 0, 1),
}
"""Upright planes: what is said of them, which coordinates run to the right, upwards and towards who
looks, and the sign of the last one."""


def draw_in_plane(entities: Sequence[DXFEntity]) -> tuple[list[Drawn], tuple[str, ...]]:
    """What entities draw in the one plane that they lie in, and what is to be said of it.

    That is a plane of constant z, or if one of them leaves it, of constant y or x.

    Raises InputError: If they lie in no such plane.
    """
    try:
        drawn = [draw_entity(each) for each in entities]
    except PlaneError as error:
        for note, (right, up, depth, sign) in VIEWS.items():
            try:
                drawn = [draw_entity(_turned(each, right, up, depth, sign)) for each in entities]
            except PlaneError:
                continue
            require_one_plane(drawn, "xyz"[depth], sign)
            return drawn, (note,)
        raise error from None
    require_one_plane(drawn)
    return drawn, ()


def _turned(entity: DXFEntity, right: int, up: int, depth: int, sign: int) -> DXFEntity:
    """A copy of the entity with other coordinates as its x, y and z."""
    from ezdxf.math import Matrix44

    turn = np.zeros((4, 4))
    turn[[right, up, depth, 3], range(4)] = 1, 1, sign, 1
    copy = cast("DXFGraphic", entity.copy())
    copy.transform(Matrix44(turn.ravel().tolist()))
    copy.dxf.handle = entity.dxf.get("handle")  # messages name the entity
    return copy


def require_one_plane(drawn: Sequence[Drawn], depth: str = "z", sign: int = 1) -> None:
    """Refuse curves that lie above each other: seen from above they would seem to meet.

    Parameters
    ----------
    depth, sign
        The coordinate towards who looks, and the sign that it has been given.

    Raises
    ------
    InputError
        Naming one that lies elsewhere than the first.
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
                got=f"{depth} = {sign * each.z[0] + 0.0:.6g}",
                expected=f"{sign * level + 0.0:.6g}, as {drawn[0].name} has",
                remedy="move them into one plane (FLATTEN in AutoCAD, ProjectToCPlane in Rhino), "
                "or choose one with layer or handle",
            )
