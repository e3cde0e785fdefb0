"""The text of a formula as a syntax tree: characters, parentheses and lengths are checked."""

from __future__ import annotations

import ast
import warnings

from orishell.conventions.errors import FormulaError
from orishell.curves.formula_signs import ALLOWED, DECIMAL_COMMA, Plain, mended, plainly

MAX_LENGTH = 500
MAX_DEPTH = 100


def syntax_tree(text: str) -> tuple[ast.expr, Plain]:
    """The syntax tree of a formula, columns as in its text, and what it is in plain signs.

    What may stand in it is not checked. Raises FormulaError with the place of the fault.
    """
    if len(text) > MAX_LENGTH:
        raise FormulaError(
            "the formula is too long",
            text,
            MAX_LENGTH,
            got=f"{len(text)} characters",
            expected=f"at most {MAX_LENGTH}",
        )
    plain = plainly(text)
    if not plain.text.strip():
        raise FormulaError("the formula is empty", text, 0)
    _check_characters(text, plain.columns[0])
    comma = DECIMAL_COMMA.search(text)
    if comma is not None:
        raise FormulaError(
            "numbers have a decimal point, not a comma",
            text,
            comma.start(1),
            got=repr(comma[0]),
            remedy=f"write {comma[0].replace(',', '.')}",
        )
    lead = len(plain.text) - len(plain.text.lstrip())
    # Inside parentheses the parser minds neither leading blanks nor line ends.
    source = "(" + plain.text[lead:] + "\n)"
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            tree = ast.parse(source, mode="eval")
    except (SyntaxError, Warning, RecursionError, MemoryError, ValueError) as error:
        column = (
            error.offset - 2 + lead
            if isinstance(error, SyntaxError) and error.offset and error.lineno == 1
            else len(plain.text)
        )
        remedy, at = mended(text)
        at = plain.column(max(0, column)) if at is None else at
        raise FormulaError("this is not a formula", text, at, remedy=remedy) from None
    for node in ast.walk(tree):
        if isinstance(node, ast.expr):
            node.col_offset = plain.column(node.col_offset + lead - 1)
    return tree.body, plain


def _check_characters(text: str, begin: int) -> None:
    """Refuse what a formula never holds, and unbalanced or too deep parentheses, by place.

    begin: Where the formula begins, behind what it is said to give.
    """
    opened: list[int] = []
    for column in range(begin, len(text)):
        character = text[column]
        if not ((character.isascii() and character.isalnum()) or character in ALLOWED):
            raise FormulaError(
                "this character is not allowed in a formula",
                text,
                column,
                got=repr(character),
                remedy=mended(text)[0] if character in "|√" else "",
            )
        if character == "(":
            opened.append(column)
            if len(opened) > MAX_DEPTH:
                raise FormulaError(
                    "the formula is nested too deeply",
                    text,
                    column,
                    expected=f"at most {MAX_DEPTH} levels",
                )
        elif character == ")":
            if not opened:
                raise FormulaError("a closing parenthesis without its opening one", text, column)
            opened.pop()
    if opened:
        raise FormulaError("a parenthesis is never closed", text, opened[-1])
