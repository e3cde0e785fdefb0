"""The text of a formula as a syntax tree: characters, parentheses and lengths are checked."""

from __future__ import annotations

import ast
import re
import warnings

from orishell.conventions.errors import FormulaError

MAX_LENGTH = 500
MAX_DEPTH = 100
DECIMAL_COMMA = re.compile(r"\d+(,)\d+")


def syntax_tree(text: str) -> ast.expr:
    """The syntax tree of a formula, columns as in its text; what may stand in it is not checked.

    Raises FormulaError with the place of the fault.
    """
    if len(text) > MAX_LENGTH:
        raise FormulaError(
            "the formula is too long",
            text,
            MAX_LENGTH,
            got=f"{len(text)} characters",
            expected=f"at most {MAX_LENGTH}",
        )
    if not text.strip():
        raise FormulaError("the formula is empty", text, 0)
    _check_characters(text)
    comma = DECIMAL_COMMA.search(text)
    if comma is not None:
        raise FormulaError(
            "numbers have a decimal point, not a comma",
            text,
            comma.start(1),
            got=repr(comma[0]),
            remedy=f"write {comma[0].replace(',', '.')}",
        )
    lead = len(text) - len(text.lstrip())
    # Inside parentheses the parser minds neither leading blanks nor line ends.
    source = "(" + text[lead:] + "\n)"
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            tree = ast.parse(source, mode="eval")
    except (SyntaxError, Warning, RecursionError, MemoryError, ValueError) as error:
        column = (
            error.offset - 2 + lead
            if isinstance(error, SyntaxError) and error.offset and error.lineno == 1
            else len(text)
        )
        raise FormulaError(
            "this is not a formula",
            text,
            max(0, min(column, len(text))),
            remedy="write products with *, as in 2*x, and arguments in parentheses, as in sin(x)",
        ) from None
    for node in ast.walk(tree):
        if isinstance(node, ast.expr):
            node.col_offset += lead - 1
    return tree.body


def _check_characters(text: str) -> None:
    """Refuse what a formula never holds, and unbalanced or too deep parentheses, by place."""
    opened: list[int] = []
    for column, character in enumerate(text):
        if not (character.isascii() and (character.isalnum() or character in " .+-*/()^,_")):
            raise FormulaError(
                "this character is not allowed in a formula", text, column, got=repr(character)
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
