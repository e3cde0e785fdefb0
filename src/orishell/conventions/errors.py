"""The errors that orishell raises, and the one form that their messages have.

An error says what is wrong, where, what was got, what was expected, and how to mend it.
:class:`InputError` is the user's text (exit status 2), :class:`DesignError` a target that
the family cannot reach (exit status 1).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self


def printable(text: str) -> str:
    """A line of text with every character that a terminal would obey escaped.

    Parameters
    ----------
    text
        The line.
    """
    if text.isprintable():
        return text
    return "".join(
        each if each.isprintable() else each.encode("unicode_escape").decode() for each in text
    )


LONGEST_PLACE = 240
"""Characters of a place that a message has: names of files are anything that a user writes."""


class OrishellError(Exception):
    """Base class of all errors of orishell; ``exit_status`` is what the command line returns."""

    exit_status = 1


class InputError(OrishellError):
    """A file, a key or a value that the user gave cannot be used.

    Parameters
    ----------
    what
        What is wrong, in one clause.
    where
        The place in its file, outermost first; made from ``keys`` where it is left out.
    keys
        Keys of the design file that it is about, the tables in front of them, or tables.
    file
        The file.
    got, expected
        What was found there and what would have been accepted.
    remedy
        What to do about it, or a question that says what may have been meant.
    changes
        What of it a program may do: values by the names under which the reader takes them.
    detail
        Further lines, for example the formula with a caret under the fault.
    whole
        Whether a whole number would have been accepted.
    """

    exit_status = 2

    def __init__(
        self,
        what: str,
        *,
        where: str = "",
        keys: tuple[str, ...] = (),
        file: Path | str = "",
        got: str = "",
        expected: str = "",
        remedy: str = "",
        changes: Mapping[str, Value] | None = None,
        detail: str = "",
        whole: bool = False,
    ) -> None:
        super().__init__(what)
        self.what = what
        self.whole = whole
        self.where = where or _place_of(keys)
        self.keys = keys
        self.file = str(file)
        self.got = got
        self.expected = expected
        self.remedy = remedy
        self.changes = dict(changes or {})
        self.detail = detail

    def located(self, where: str) -> Self:
        """Put an outer place, ``where``, in front of the one known so far, and return the error."""
        self.where = f"{where} {self.where}".strip()
        return self

    def at_key(self, key: str, where: str = "") -> Self:
        """Put a key or table of the design file in front of the place and the keys known so far.

        Parameters
        ----------
        where
            How messages write the key, if otherwise than others.
        """
        self.keys = tuple(f"{key}.{inner}" for inner in self.keys) or (key,)
        return self.located(where or _place_of((key,)))

    def in_file(self, file: Path | str) -> Self:
        """Say which file the error is about, and return the error."""
        self.file = str(file)
        return self

    def __str__(self) -> str:
        facts = [
            f"{name} {text}"
            for name, text in (("got", self.got), ("expected", self.expected))
            if text
        ]
        sentence = "; ".join([self.what, ", ".join(facts)] if facts else [self.what]) + "."
        if self.remedy.endswith("?"):
            sentence += f" {self.remedy[0].upper()}{self.remedy[1:]}"
        elif self.remedy:
            sentence += f" Remedy: {self.remedy}."
        where = self.where.removesuffix(":")
        if len(where) > LONGEST_PLACE:
            where = f"{where[:LONGEST_PLACE]}..."
        places = [self.file, where, sentence]
        sentence = printable(": ".join(filter(None, places)))
        return f"{sentence}\n{self.detail}" if self.detail else sentence


def _place_of(keys: tuple[str, ...]) -> str:
    """Keys of one table, or a table, as messages write them: "[pattern] rows, columns"."""
    if not keys:
        return ""
    table, _, first = keys[0].rpartition(".")
    if not table:
        return f"[{first}]"
    return f"[{table}] " + ", ".join(key.removeprefix(f"{table}.") for key in keys)


class FormulaError(InputError):
    """A formula that cannot be used; ``column`` is the 0-based place of the fault."""

    def __init__(self, what: str, text: str, column: int, **facts: Any) -> None:
        begin = max(0, min(column, len(text)) - 60)
        shown = "".join(c if c.isprintable() else " " for c in text[begin : begin + 80])
        caret = " " * (column - begin) + "^"
        super().__init__(
            f"{what} at character {column + 1}", detail=f"    {shown}\n    {caret}", **facts
        )
        self.column = column


class CurveError(InputError):
    """A curve that cannot be used: not finite, not regular, too short, without a range."""


Vertices = list[int] | list[list[int]] | list[list[list[int]]]
"""Rows and columns of vertices, of pairs of them, of lists of pairs."""
Value = float | int | str | list[float] | list[str] | Vertices | dict[str, list[int]]
"""What can be written at a key of the design file."""


@dataclass(frozen=True, slots=True)
class Remedy:
    """Keys of the design file, and what to write there instead."""

    # Values by key, the tables in front of it: "pattern.xi_deg", "target.g.scale". None removes a
    # key.
    changes: Mapping[str, Value | None]
    words: str = ""  # what is done, where keys and values would not say it

    def __or__(self, other: Remedy) -> Remedy:
        """Both changes; where they share a key, that of ``other``."""
        return Remedy({**self.changes, **other.changes})

    def __str__(self) -> str:
        if self.words:
            return self.words
        written = [_written(key, value) for key, value in self.changes.items() if value is not None]
        removed = [key.rpartition(".")[2] for key, value in self.changes.items() if value is None]
        without = [f"without {', '.join(removed)}"] if removed else []
        return " ".join([" with ".join(written), *without]).strip()


def _written(key: str, value: Value) -> str:
    table, _, name = key.rpartition(".")
    return f"{name} = {as_toml(value)}" + ("" if table == "pattern" else f" in [{table}]")


def as_toml(value: Value) -> str:
    """A value as a design file has it, tables within their line.

    Parameters
    ----------
    value
        The value.
    """
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{key} = {as_toml(each)}' for key, each in value.items())} }}"
    if isinstance(value, list):
        return f"[{', '.join(map(as_toml, value))}]"
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else repr(value).removesuffix(".0")


class DesignError(OrishellError):
    """A target that the family cannot reach.

    Parameters
    ----------
    condition
        The condition that fails.
    keys
        Keys of the design file that the condition is about, the tables in front of them.
    place
        Where it fails (row, column, place on the curve).
    size
        By how much, and where its limit is.
    candidates
        What may be worth trying, the nearest first, computed as it is asked for. Messages do not
        show it.
    remedies
        What has been tried, through the whole design with its proof, and works; the nearest first.
    limit
        What stands in the way, if all that was tried failed.
    excess
        By how much the condition fails: 0 at its limit, and more the farther from it, so that a
        search finds its way back. A share of the limit, of an angle the share of half a turn; None
        where no size is known, or the limit is zero. What takes time to find is found when it is
        asked for.
    """

    exit_status = 1

    def __init__(
        self,
        condition: str,
        *,
        keys: tuple[str, ...] = (),
        place: str = "",
        size: str = "",
        candidates: Iterable[Remedy] = (),
        remedies: tuple[Remedy, ...] = (),
        limit: str = "",
        excess: float | Callable[[], float | None] | None = None,
    ) -> None:
        super().__init__(condition)
        self.condition, self.keys = condition, keys
        self.place = place
        self.size = size
        self.candidates = candidates
        self.remedies = remedies
        self.limit = limit
        self._excess = excess

    @property
    def excess(self) -> float | None:
        """By how much the condition fails; None if that is not known."""
        if callable(self._excess):
            self._excess = self._excess()
        return None if self._excess is None else max(0.0, float(self._excess))

    def __str__(self) -> str:
        sentence = self.condition
        if self.place:
            sentence += f", {self.place}"
        if self.size:
            sentence += f": {self.size}"
        sentence += "."
        if self.remedies:
            sentence += f" Nearest found that works: {', or '.join(map(str, self.remedies))}."
        if self.limit:
            sentence += f" No value was found that works: {self.limit}."
        return sentence


class ClashError(DesignError):
    """Panels that meet before the shell reaches its target.

    Parameters
    ----------
    condition, place, size
        Which panels, at which drive, and the depth of the corrugation there.
    excess
        The share of the way to the target that is missing.
    flap
        Width of the flaps if one of them is a flap, else 0 (length).
    thick
        Whether their boards meet, and panels without a thickness would not.
    """

    def __init__(
        self,
        condition: str,
        *,
        place: str = "",
        size: str = "",
        excess: float | None = None,
        flap: float = 0.0,
        thick: bool = False,
    ) -> None:
        super().__init__(condition, place=place, size=size, excess=excess)
        self.flap, self.thick = flap, thick


class VerificationError(OrishellError):
    """A result that does not pass its own verification: a fault of the program."""
