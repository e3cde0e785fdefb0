"""Words of what builders read, in their language."""

from __future__ import annotations

import re
from functools import cache
from importlib.resources import files
from typing import Any

from orishell.conventions.record import record
from orishell.conventions.toml_file import parse_toml
from orishell.workshop.settings import Language

_POINT = re.compile(r"(?<=\d)\.(?=\d)")

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


@cache
def load_words(language: Language) -> Words:
    """The words of a language."""
    text = (files("orishell.workshop.kit") / f"booklet.{language}.toml").read_text(encoding="utf-8")
    return Words(parse_toml(text))
