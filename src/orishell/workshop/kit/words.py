"""Words of what builders read, in their language."""

from __future__ import annotations

import re
from functools import cache
from importlib.resources import files
from typing import Any

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.conventions.toml_file import parse_toml
from orishell.workshop.settings import Language

_POINT = re.compile(r"(?<=\d)\.(?=\d)")

MOST = 5
"""Of missing keys so many are named."""

_SQUARE = re.compile(r"\b(mm|cm|m|in|ft)2\b")


@record
class Words:
    """The words of a booklet in one language: those of ``booklet.en.toml``, and its like."""

    tables: dict[str, Any]

    def say(self, key: str, **values: object) -> str:
        """The words of a key, as in "parts.tie", with values in their places.

        Numbers in values have the decimal sign of the language.
        """
        place: Any = self.tables
        for part in key.split("."):
            place = place[part]
        sign = self.tables["decimal"]
        said = {
            name: _SQUARE.sub(r"\1²", _POINT.sub(sign, str(value)))
            for name, value in values.items()
        }
        return str(place).format(**said)


FIRST: Language = "en"
"""The language that has all keys."""


@cache
def load_words(language: Language) -> Words:
    """The words of a language.

    Raises
    ------
    InputError
        If it lacks some.
    """
    tables, first = _tables(language), _tables(FIRST)
    require_words(language, tables, first)
    return Words(tables)


def require_words(language: str, tables: dict[str, Any], first: dict[str, Any]) -> None:
    """Refuse the words of a language that lack keys of the first."""
    missing = sorted(_keys(first) - _keys(tables))
    if missing:
        raise InputError(
            "the words of the booklet are not all there",
            where=f"booklet.{language}.toml",
            got=f"{len(missing)} missing: {', '.join(missing[:MOST])}",
            expected=f"the keys of booklet.{FIRST}.toml",
            remedy="translate these keys, too",
        )


def _tables(language: Language) -> dict[str, Any]:
    text = (files("orishell.workshop.kit") / f"booklet.{language}.toml").read_text(encoding="utf-8")
    return parse_toml(text)


def _keys(tables: dict[str, Any]) -> set[str]:
    """Dotted keys of all words."""
    return {
        key
        for name, each in tables.items()
        for key in ([f"{name}.{k}" for k in _keys(each)] if isinstance(each, dict) else [name])
    }
