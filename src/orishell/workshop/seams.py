"""Seams, along which the strips of a shell are joined by hinges where it is no one flat sheet.

Both sides of a seam bear one name, as joints of parts do: 2-3c is the third panel's between 2 and
3. These are the numbers of parts, or those of strips from 1 where parts have none.
"""

from __future__ import annotations

from collections import Counter

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.fitted_words import label_edges
from orishell.workshop.palettes import Text

HEIGHT = 0.06
"""Height of names at most, as a share of the mean edge."""
ROOM = 2.0
"""Heights of a name that must fit into its panel."""


@record
class Seams:
    """Edges of strips that are joined, as a document has them that is cut."""

    edges: Integers  # (K, 2), that of the left strip first
    panels: Integers  # (K, 2), the panels at these

    @classmethod
    def of(cls, document: Document) -> Seams:
        """Those of a document as it is cut; none of one sheet."""
        known, mesh = document.cut_from, document.mesh
        edges = np.flatnonzero(~mesh.crease & (mesh.edges < len(known)).all(axis=1))
        keys = np.sort(known[mesh.edges[edges]], axis=1) @ [len(known) + 1, 1]
        order = np.argsort(keys, kind="stable")
        first = np.flatnonzero(keys[order][1:] == keys[order][:-1])
        pairs = np.stack([edges[order[first]], edges[order[first + 1]]], axis=1)
        panels = mesh.edge_faces[pairs].max(axis=-1)
        left = np.argsort(panels, axis=1)
        pairs, panels = (np.take_along_axis(each, left, axis=1) for each in (pairs, panels))
        down = np.argsort(panels[:, 0])
        return cls(pairs[down], panels[down])


def strip_numbers(document: Document) -> Integers:
    """The strip (F,) of every panel of a document as it is cut, from 1; 1 for all of one sheet."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count, mesh = len(document.mesh.faces), document.mesh
    if not len(document.cut_from):
        return np.ones(count, np.int64)
    first, second = mesh.edge_faces[mesh.crease].T
    joined = coo_array((np.ones(len(first)), (first, second)), shape=(count, count))
    return np.asarray(1 + connected_components(joined, directed=False)[1], np.int64)


def seam_names(
    document: Document, number: Integers, panels: Integers | None = None
) -> tuple[Text, ...]:
    """Names along both sides of all seams, or on some ``panels`` only.

    Parameters
    ----------
    number
        The number (F,) of the part that every panel belongs to.
    """
    seams = Seams.of(document)
    if not len(seams.edges):
        return ()
    counts: Counter[tuple[int, int]] = Counter()
    words = []
    for one, other in number[seams.panels].tolist():
        pair = min(one, other), max(one, other)
        counts[pair] += 1
        words.append(f"{pair[0]}-{pair[1]}{letters(counts[pair])}")
    beside, edges = seams.panels.T.ravel(), seams.edges.T.ravel()
    flat, mesh = document.require_flat(), document.mesh
    corners: Array = flat[mesh.faces[beside]]
    most = HEIGHT * float(document.edge_lengths().mean())
    labels = label_edges((*words, *words), corners, flat[mesh.edges[edges]], tall=ROOM, most=most)
    return labels.of(None if panels is None else np.isin(beside, panels))


def letters(count: int) -> str:
    """Letters for a number, as in spreadsheets: 1 is a, 26 is z, 27 is aa."""
    found = ""
    while count:
        count, last = divmod(count - 1, 26)
        found = chr(ord("a") + last) + found
    return found
