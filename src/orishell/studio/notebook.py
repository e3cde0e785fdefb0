"""The viewer in a notebook."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import InputError
from orishell.design import Design
from orishell.document import Document
from orishell.document.from_design import document_of_design
from orishell.io.formats.html import read_viewer
from orishell.io.view import dump_view
from orishell.shell.make import Shell
from orishell.shell.pictures import lay_surface

if TYPE_CHECKING:
    from anywidget import AnyWidget

HEIGHT = 560
"""Height of the viewer in a notebook (pixels)."""
HIGHEST = 10_000
"""Pixels that it may be high; browsers draw on no canvas much higher."""


def show(shell: Shell | Design | Document, *, height: int = HEIGHT) -> AnyWidget:
    """A widget that shows a shell and lets it fold.

    Parameters
    ----------
    shell
        A shell, a design of any family, or a document such as that of a FOLD file.
    height
        Height of the widget in pixels.

    Returns
    -------
    AnyWidget
        It displays itself at the end of a cell; its ``view`` is what it shows.

    Raises
    ------
    InputError
        If it is none of these, the height is no number of pixels, the viewer has not been built, or
        anywidget is not installed.
    """
    if not (isinstance(height, int | np.integer) and 0 < height <= HIGHEST):
        raise InputError(
            "the viewer cannot be as high as this",
            where="show: height",
            got=repr(height)[:60],
            expected=f"a whole number of pixels from 1 to {HIGHEST}",
        )
    document = _document(shell)
    # The widget's traits are made at run time.
    widget: AnyWidget = _widget_class()(view=dump_view(document), height=int(height))
    return widget


def _document(shell: Shell | Design | Document) -> Document:
    match shell:
        case Document():
            return shell
        case Design():
            return lay_surface(document_of_design(shell), shell)
        case Shell():
            return lay_surface(shell.document, shell.design)
    raise InputError(
        "the viewer cannot show this",
        got=type(shell).__name__,
        expected="a Shell, a Design or a Document",
        remedy="make a document of a motion with orishell.document.from_design.document_of_motion, "
        "of a FOLD file with orishell.io.document_of_fold",
    )


@cache
def _widget_class() -> type[AnyWidget]:
    try:
        from anywidget import AnyWidget
        from traitlets import Bytes, Int
    except ImportError:
        raise InputError(
            "widgets need anywidget, which is not installed",
            remedy='pip install "orishell[notebook]"',
        ) from None

    class Viewer(AnyWidget):
        """The viewer; ``view`` holds the bytes of :func:`orishell.io.view.dump_view`."""

        _esm = read_viewer()
        view = Bytes().tag(sync=True)
        height = Int(HEIGHT).tag(sync=True)

    return Viewer
