"""The table [search] of a design file: what may be changed, and what is to be small."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal, Self

from pydantic import Discriminator, Field, Tag, field_validator, model_validator

from orishell.conventions.table import Number, Several, Table, misfit
from orishell.conventions.toml_file import DEEPEST

Method = Literal["auto", "nsga2", "nsga3", "grid"]
"""How designs are chosen: NSGA-II, or III beyond three objectives; or one of them, or all there
are."""


LONGEST_KEY, MOST_PARTS = 300, DEEPEST
"""Characters of a key of the design file, and its parts, at most."""
DIGITS, NARROWEST, WIDEST = 1e-9, 1e-300, 1e300
"""Width of a range: of its larger number, so that its values have digits that differ; at least;
and at most."""


class Range(Table):
    """Numbers from one to another."""

    low: int | Number
    high: int | Number
    step: Annotated[int | Number, Field(gt=0)] | None = None

    @model_validator(mode="after")
    def _check(self) -> Self:
        if not self.low < self.high:
            raise misfit(f"a value above low ({self.low:g})", self.high, "high")
        width = self.high - self.low
        least = max(NARROWEST, DIGITS * max(abs(self.low), abs(self.high)))
        if not least <= width <= WIDEST:
            expected = f"numbers that are apart by at least {least:.3g} and by at most {WIDEST:g}"
            raise misfit(expected, self.high, "high")
        return self


class Limit(Table):
    """What a figure may be at least, and at most."""

    least: Number | None = None
    most: Number | None = None

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.least is None and self.most is None:
            raise misfit("least, most or both", {})
        if self.least is not None and self.most is not None and self.least > self.most:
            expected = f"a value of at least {self.least:g}, which is least"
            raise misfit(expected, self.most, "most")
        return self


Choices = Annotated[Several[Any], Field(min_length=1, max_length=1000)]
Allowed = Annotated[
    Annotated[Range, Tag("range")] | Annotated[Choices, Tag("choices")],
    Discriminator(lambda value: "range" if isinstance(value, dict) else "choices"),
]
"""What a key may be."""


class Search(Table):
    """What may be changed in the design, and what is to be as small as can be."""

    variables: Annotated[dict[str, Allowed], Field(min_length=1)]
    minimise: Annotated[Several[str], Field(min_length=1, max_length=8)]
    subject_to: dict[str, Limit] = Field(default_factory=dict)
    evaluations: Annotated[int, Field(ge=1, le=1_000_000)] = 400
    population: Annotated[int, Field(ge=4, le=10_000)] = 40
    seed: Annotated[int, Field(ge=0, lt=2**32)] = 1
    method: Method = "auto"

    @field_validator("variables")
    @classmethod
    def _require_choice(cls, variables: dict[str, Any]) -> dict[str, Any]:
        for key, values in variables.items():
            if len(key) > LONGEST_KEY or key.count(".") >= MOST_PARTS:
                raise misfit(
                    f"a key of at most {LONGEST_KEY} characters and {MOST_PARTS} parts",
                    f"{len(key)} characters, {key.count('.') + 1} parts",
                )
            if isinstance(values, tuple):
                if not _all_finite(values):
                    raise misfit("finite numbers", values, key)
                if any(each in values[:k] for k, each in enumerate(values)):
                    raise misfit("values that differ", values, key)
        return variables

    @field_validator("minimise")
    @classmethod
    def _require_different(cls, names: tuple[str, ...]) -> tuple[str, ...]:
        if len(set(names)) < len(names):
            raise misfit("figures that differ", names)
        return names


def _all_finite(value: Any) -> bool:
    """Whether no number in a value is infinite or none: those have no place in a journal."""
    if isinstance(value, dict | list | tuple):
        return all(map(_all_finite, value.values() if isinstance(value, dict) else value))
    return not isinstance(value, float) or math.isfinite(value)


def with_joined_keys(raw: dict[str, Any]) -> dict[str, Any]:
    """The tables of a design file, keys of [search] without quotes joined by their dots.

    TOML takes them for tables within each other.
    """
    search = raw.get("search")
    if not isinstance(search, dict):
        return raw
    joined = {
        name: dict(pair for key, value in search[name].items() for pair in _joined(key, value))
        for name in ("variables", "subject_to")
        if isinstance(search.get(name), dict)
    }
    return {**raw, "search": {**search, **joined}}


def _joined(key: str, value: Any) -> Iterator[tuple[str, Any]]:
    """Dotted keys and what they may be: a table of tables or lists is a part of the key."""
    parts = value.values() if isinstance(value, dict) else ()
    if parts and all(isinstance(each, dict | list) for each in parts):
        for name, inner in value.items():
            yield from _joined(f"{key}.{name}", inner)
    else:
        yield key, value
