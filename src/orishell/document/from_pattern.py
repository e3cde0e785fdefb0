"""The document of a crease pattern and its motion, with panels of any number of corners."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from orishell.design.part import DocumentState
from orishell.document.document import Document
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.mesh import QuadMesh, build_mesh
from orishell.motion.parts import refine
from orishell.numerics.arrays import Array


def document_of_pattern(
    pattern: CreasePattern,
    letters: NDArray[np.str_],
    states: Sequence[DocumentState],
    *,
    title: str,
    unit: str,
) -> Document:
    """The document of a pattern and states of its motion.

    Its panels are whole in ``loops`` of its mesh, as FOLD has them. Other formats, which work on
    four corners, take :func:`for_pictures` of it.

    Parameters
    ----------
    pattern
        The flat sheet.
    letters
        Letter (E,) of every edge, as the motion folds it.
    states
        States of its motion, with their fold angles, the flat one first.
    title
        One line that says what it is.
    unit
        Unit of length; "unit" if none is known.
    """
    return Document(
        title=title,
        unit=unit,
        mesh=QuadMesh(
            len(pattern.vertices),
            pattern.faces[:, [0, 1, 2, -1]],
            pattern.faces,
            pattern.edges,
            pattern.edge_faces,
            pattern.crease,
            np.zeros(len(pattern.faces), np.int64),
            np.zeros(len(pattern.faces), np.bool_),
        ),
        assignment=tuple(letters.tolist()),
        flat=_still(pattern.vertices),
        fold_angles_deg=_known(states[-1]),
        states=tuple(states),
        grid_shape=None,
        curves={},
    )


def for_pictures(pattern: CreasePattern, document: Document) -> Document:
    """The document with panels of four corners only, for pictures: the same one if all have.

    Parameters
    ----------
    pattern
        The flat sheet that the document was made of.
    document
        What :func:`document_of_pattern` made.
    """
    if pattern.faces.shape[1] == 4 and (pattern.faces >= 0).all():
        return document
    refined = refine(pattern)
    sides = np.stack([refined.faces, np.roll(refined.faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    assert document.flat is not None
    flat = _still(refined.extended(document.flat))
    keys, halves = (np.sort(each, axis=1) @ [len(flat), 1] for each in (sides, refined.halves))
    more = np.stack(np.divmod(np.setdiff1d(keys, halves), len(flat)), axis=-1)
    zero = np.zeros(len(more))

    def on_halves(angles: Array) -> Array:
        return np.append(np.repeat(angles, 2), zero)

    contact = document.contact
    if contact is not None:
        first, second = np.searchsorted(refined.panels, contact.panels).tolist()
        contact = replace(contact, panels=(first, second))
    letters = np.repeat(np.array(document.assignment), 2)
    return replace(
        document,
        mesh=build_mesh(
            refined.faces,
            len(flat),
            np.concatenate([refined.halves, more]),
            np.append(letters == "C", zero > 0),
        ),
        assignment=(*letters.tolist(), *["J"] * len(more)),
        flat=flat,
        fold_angles_deg=on_halves(document.fold_angles_deg),
        states=tuple(
            replace(
                state,
                positions=_still(refined.extended(state.positions)),
                fold_angles_deg=on_halves(_known(state)),
            )
            for state in document.states
        ),
        names=tuple(map(str, refined.panels.tolist())),
        contact=contact,
    )


def _known(state: DocumentState) -> Array:
    assert state.fold_angles_deg is not None
    return state.fold_angles_deg


def _still(array: Array) -> Array:
    """Contiguous and read-only."""
    found = np.ascontiguousarray(array)
    found.flags.writeable = False
    return found
