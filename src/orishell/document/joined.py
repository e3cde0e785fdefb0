"""Several parts as one: meshes, states and boards one after the other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain
from typing import TypeVar

import numpy as np

from orishell.design.holes import Holes
from orishell.design.hung import HungLines
from orishell.design.part import DocumentState, MadeStates, Part
from orishell.motion.boards import Boards, join_boards
from orishell.motion.mesh import build_mesh
from orishell.numerics.arrays import Array, Integers

AnyPart = TypeVar("AnyPart", bound=Part)


def joined(
    first: AnyPart,
    others: Sequence[Part],
    flats: Sequence[Array],
    states: Sequence[DocumentState] = (),
) -> AnyPart:
    """A part with others behind it that do not hang together with it.

    Vertices, edges, panels and boards of the others come after its own, each by its name.

    Parameters
    ----------
    flats
        Vertices (V, 2) of every part, as it lies.
    states
        The states of all of them; none if only what is flat is asked for.
    """
    parts: tuple[Part, ...] = (first, *others)
    begins = np.cumsum([0, *map(len, flats)])

    def numbered(arrays: Iterable[Integers]) -> Integers:
        return np.concatenate([array + k for array, k in zip(arrays, begins, strict=False)])

    longest = max(part.mesh.loops.shape[1] for part in parts)
    loops = [
        np.pad(
            np.where(part.mesh.loops < 0, -1, part.mesh.loops + k),
            ((0, 0), (0, longest - part.mesh.loops.shape[1])),
            constant_values=-1,
        )
        for part, k in zip(parts, begins, strict=False)
    ]
    return replace(
        first,
        mesh=build_mesh(
            numbered(part.mesh.faces for part in parts),
            int(begins[-1]),
            numbered(part.mesh.edges for part in parts),
            np.concatenate([~part.mesh.crease for part in parts]),
            np.concatenate(loops),
        ),
        assignment=tuple(chain.from_iterable(part.assignment for part in parts)),
        flat=np.concatenate(flats),
        fold_angles_deg=np.concatenate([part.fold_angles_deg for part in parts]),
        states=states,
        grid_shape=None,
        named=first.named if states else {},
        names=tuple(p.panel_name(panel) for p in parts for panel in range(len(p.mesh.faces))),
        boards=_all_boards(parts, flats),
        holes=_all_holes(parts, flats),
        hung=HungLines.joined(
            chain((part.hung for part in parts), _all_borne(parts, flats)),
        ),
    )


def _all_boards(parts: Sequence[Part], flats: Sequence[Array]) -> Boards | None:
    """The boards of all parts, where these lie (V, 2) now; None if panels have no thickness."""
    made, first = [], 0
    for part, flat in zip(parts, flats, strict=True):
        if part.boards is not None:
            shift = np.append(flat[0] - part.require_flat()[0], 0.0)
            moved = replace(
                part.boards,
                panels=part.boards.panels + first,
                outlines=part.boards.outlines + shift,
            )
            made.append(moved)
        first += len(part.mesh.faces)
    return join_boards(made) if made else None


def _all_borne(parts: Sequence[Part], flats: Sequence[Array]) -> Iterator[HungLines | None]:
    """Where others hang on panels of all parts, where these lie (V, 2) now."""
    first = 0
    for part, flat in zip(parts, flats, strict=True):
        move = flat[0] - part.require_flat()[0]
        yield None if part.bears is None else part.bears.moved(first, move)
        first += len(part.mesh.faces)


def _all_holes(parts: Sequence[Part], flats: Sequence[Array]) -> Holes | None:
    """The holes of all parts, where these lie (V, 2) now; None if there are none."""
    made, first = [], 0
    for part, flat in zip(parts, flats, strict=True):
        if part.holes is not None:
            made.append(part.holes.moved(first, flat[0] - part.require_flat()[0]))
        first += len(part.mesh.faces)
    return Holes.joined(made)


def joined_states(parts: Sequence[Part]) -> Sequence[DocumentState]:
    """States of several parts that have as many each, put together as they are taken."""

    def together(which: int) -> DocumentState:
        states = [part.states[which] for part in parts]
        angles = [
            np.full(len(part.mesh.edges), np.nan)
            if state.fold_angles_deg is None
            else state.fold_angles_deg
            for part, state in zip(parts, states, strict=True)
        ]
        return replace(
            states[0],
            positions=np.concatenate([state.positions for state in states]),
            fold_angles_deg=np.concatenate(angles),
        )

    return MadeStates(len(parts[0].states), together)
