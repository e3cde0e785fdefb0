"""Everything that can go wrong, said once and in one form.

An error says what is wrong, where, what was got, what was expected, and how to mend it.
:class:`InputError` is the user's text (exit status 2), :class:`DesignError` a target that
the family cannot reach (exit status 1).
"""

from __future__ import annotations

from typing import Self


def printable(text: str) -> str:
    """A line of text in which every character that a terminal would obey is an escape.

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


class OrishellError(Exception):
    """The root of the family; ``exit_status`` is what the command line returns."""

    exit_status = 1


class InputError(OrishellError):
    """Something the user wrote is not usable.

    Parameters
    ----------
    what
        What is wrong, in one clause.
    where
        File, table and key, outermost first; see :meth:`located`.
    got, expected
        What was found there and what would have been accepted.
    remedy
        What to do about it.
    detail
        Further lines, for example the formula with a caret under the fault.
    """

    exit_status = 2

    def __init__(
        self,
        what: str,
        *,
        where: str = "",
        got: str = "",
        expected: str = "",
        remedy: str = "",
        detail: str = "",
    ) -> None:
        super().__init__(what)
        self.what = what
        self.where = where
        self.got = got
        self.expected = expected
        self.remedy = remedy
        self.detail = detail

    def located(self, where: str) -> Self:
        """Put an outer place in front of the one known so far, and return the error.

        Parameters
        ----------
        where
            The outer place.
        """
        self.where = f"{where} {self.where}".strip()
        return self

    def __str__(self) -> str:
        facts = [
            f"{name} {text}"
            for name, text in (("got", self.got), ("expected", self.expected))
            if text
        ]
        sentence = "; ".join([self.what, ", ".join(facts)] if facts else [self.what]) + "."
        if self.remedy:
            sentence += f" Remedy: {self.remedy}."
        if self.where:
            sentence = f"{self.where.removesuffix(':')}: {sentence}"
        sentence = printable(sentence)
        return f"{sentence}\n{self.detail}" if self.detail else sentence


class FormulaError(InputError):
    """A formula that cannot be used; ``column`` is the 0-based place of the fault."""

    def __init__(
        self,
        what: str,
        text: str,
        column: int,
        *,
        got: str = "",
        expected: str = "",
        remedy: str = "",
    ) -> None:
        begin = max(0, min(column, len(text)) - 60)
        shown = "".join(c if c.isprintable() else " " for c in text[begin : begin + 80])
        caret = " " * (column - begin) + "^"
        super().__init__(
            f"{what} at character {column + 1}",
            got=got,
            expected=expected,
            remedy=remedy,
            detail=f"    {shown}\n    {caret}",
        )
        self.column = column


class CurveError(InputError):
    """A curve that cannot be used: not finite, not regular, too short, without a range."""


class DesignError(OrishellError):
    """A target that the family cannot reach.

    Parameters
    ----------
    condition
        The condition that fails.
    place
        Where it fails (row, column, place on the curve).
    size
        By how much.
    nearest
        The nearest value of a parameter that works, or what to change if none is known.
    """

    exit_status = 1

    def __init__(
        self, condition: str, *, place: str = "", size: str = "", nearest: str = ""
    ) -> None:
        super().__init__(condition)
        self.condition = condition
        self.place = place
        self.size = size
        self.nearest = nearest

    def __str__(self) -> str:
        sentence = self.condition
        if self.place:
            sentence += f", {self.place}"
        if self.size:
            sentence += f": {self.size}"
        sentence += "."
        return f"{sentence} Nearest that works: {self.nearest}." if self.nearest else sentence


class VerificationError(OrishellError):
    """A result that does not pass its own verification: a fault of the program."""
