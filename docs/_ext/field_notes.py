"""What is said of the fields of a class: the comments beside them, or above one or several."""

from __future__ import annotations

import ast
import inspect
import io
import re
import textwrap
import tokenize
from functools import cache
from typing import get_type_hints


@cache
def field_notes(thing: type) -> dict[str, str]:
    """The note of each field of a class and of those it is made of.

    A comment stands behind its field, or above it; one above is also of the fields right below that
    have none of their own. A property that files have is explained by its docstring.
    """
    notes: dict[str, str] = {}
    for each in reversed(thing.__mro__):
        if each.__module__.startswith("orishell"):
            notes |= _own_notes(each)
    for name in getattr(thing, "REPORTED", ()):
        part, _, rest = name.partition(".")
        if rest:
            notes[name] = field_notes(get_type_hints(thing)[part]).get(rest, "")
        elif name not in notes:
            notes[name] = (inspect.getdoc(getattr(thing, name)) or "").partition("\n")[0]
    return notes


def _own_notes(thing: type) -> dict[str, str]:
    source = textwrap.dedent(inspect.getsource(thing))
    (tree,) = ast.parse(source).body
    assert isinstance(tree, ast.ClassDef)
    comments = {
        token.start[0]: token.string.removeprefix("#").strip()
        for token in tokenize.generate_tokens(io.StringIO(source).readline)
        if token.type == tokenize.COMMENT
    }
    whole = {line for line in comments if source.splitlines()[line - 1].lstrip()[:1] == "#"}
    notes: dict[str, str] = {}
    shared, last = "", 0
    for field in tree.body:
        if not isinstance(field, ast.AnnAssign) or not isinstance(field.target, ast.Name):
            continue
        first = field.lineno
        while first - 1 in whole:
            first -= 1
        above = " ".join(comments[line] for line in range(first, field.lineno))
        inside = (
            comments.get(line, "") for line in range(field.lineno, (field.end_lineno or 0) + 1)
        )
        beside = re.sub(r"^(noqa|type: ignore)\S*( #)?\s*", "", " ".join(filter(None, inside)))
        shared = above or (shared if last == first - 1 and not beside else "")
        notes[field.target.id] = above or beside or shared
        last = field.end_lineno or 0
    return {name: _sentence(note) for name, note in notes.items() if note}


def _sentence(note: str) -> str:
    return note[:1].upper() + note[1:] + ("" if note.endswith(".") else ".")
