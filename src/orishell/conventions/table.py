"""What all tables of the design file share, and how the studio shows their keys."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import KW_ONLY, dataclass, replace
from inspect import Signature
from types import UnionType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    ClassVar,
    Final,
    Literal,
    Self,
    TypeVar,
    Union,
    cast,
    get_args,
    get_origin,
)

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError, PydanticKnownError

from orishell.conventions.asked import PLACE, Place

T = TypeVar("T")

TRACE = 1e-15
"""Smaller sizes and densities are mistakes, and their products vanish."""

Number = Annotated[float, Field(allow_inf_nan=False)]


def misfit(
    expected: str, got: Any, key: str = "", choices: Collection[str] = ()
) -> PydanticCustomError:
    """The error about a value that does not fit.

    key: Names it within what is checked.
    choices: Texts of which one may have been meant.
    """
    more = {"key": key} if key else {}
    return PydanticCustomError("misfit", expected, {"got": got, "choices": list(choices), **more})


def _no_trace(value: float) -> float:
    if 0 < value < TRACE:
        raise misfit(f"0, or a value of at least {TRACE}", value)
    return value


Size = Annotated[Number, Field(ge=0), AfterValidator(_no_trace)]
"""0 where there is none."""


def entries(count: int | None = None) -> BeforeValidator:
    """What makes a tuple of a list, whose entries are checked as strictly as any value."""

    def unchangeable(value: Any) -> Any:
        if isinstance(value, list):
            value = tuple(value)
        if count is None or not isinstance(value, tuple) or len(value) == count:
            return value
        few = len(value) < count
        size = {"actual_length": len(value), "min_length" if few else "max_length": count}
        raise PydanticKnownError("too_short" if few else "too_long", {"field_type": "List", **size})

    return BeforeValidator(unchangeable)


Several = Annotated[tuple[T, ...], entries()]
Pair = Annotated[tuple[T, T], entries(2)]


class _SignatureOfTable:
    """What a table is made of, asked of its class before any is made."""

    def __get__(self, table: object, kind: Any) -> Signature:
        kind.model_rebuild()  # which puts the signature there
        return cast("Signature", kind.__signature__)


class Table(BaseModel):
    """A table of the design file, which is the settings of its subject.

    It has no unknown keys, and its values have the type they should have. Where it stands in a file
    it notes which of its keys are read. What checks it is made when it is first used: a command
    uses few of them.
    """

    __signature__ = _SignatureOfTable()

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, defer_build=True)

    SAMPLE: ClassVar[Mapping[str, Any]] = {}
    """Some of its keys as messages show it; a value in place of the table is that of the first."""

    if not TYPE_CHECKING:  # else every attribute would be known

        def __getattribute__(self, name: str) -> Any:
            """A value, noted as asked for."""
            place = super().__getattribute__("__dict__").get(PLACE)
            if place is not None:
                place.note(name)
            return super().__getattribute__(name)

    def replace_unchecked(self, **values: Any) -> Self:
        """The table with other values, which nobody checks, and which are not those of a file."""
        assert values.keys() <= type(self).model_fields.keys()
        made = self.model_copy(update=values)
        if PLACE in vars(made):
            vars(made)[PLACE] = vars(made)[PLACE].without(values)
        return made

    def noting(self, asked: set[str]) -> Self:
        """The table, which notes in another set what it is asked for."""
        made = self.model_copy()
        if PLACE in vars(made):
            vars(made)[PLACE] = Place(vars(made)[PLACE].keys, asked)
        return made

    def note_all(self, beside: Collection[str] = ()) -> None:
        """Note that it is read as a whole, or all of it beside some keys."""
        for name in type(self).model_fields.keys() - set(beside):
            getattr(self, name)


def placed(table: Table, asked: set[str], inside: str = "") -> Iterator[str]:
    """Have a table and those within it note what they are asked for; the keys that they have.

    Parameters
    ----------
    asked
        Where to: a set of dotted keys.
    inside
        The key of the table itself, with a dot behind it.
    """
    keys: dict[str, str] = {}
    for name, field in type(table).model_fields.items():
        if name not in table.model_fields_set:
            continue
        key = inside + (field.alias or name)
        # A table that a plain value stands for has no keys of its own.
        found = _tables_in(getattr(table, name), key)
        tables = [each for each in found if each[1].model_fields_set]
        if not tables:
            keys[name] = key
            yield key
        for place, inner in tables:
            yield from placed(inner, asked, f"{place}.")
    vars(table)[PLACE] = Place(keys, asked)


def _tables_in(value: Any, key: str) -> Iterator[tuple[str, Table]]:
    """The tables in a value by their keys, those of a list by their numbers from 0."""
    if isinstance(value, Table):
        yield key, value
    elif isinstance(value, tuple | Mapping):
        named = value.items() if isinstance(value, Mapping) else enumerate(value)
        for number, each in named:
            yield from _tables_in(each, f"{key}.{number}")


Kind = Literal["integer", "number", "choice", "angles4", "switch", "size"]
Measure = Literal["length", "deg", "kg/m", "kg/m²", ""]


@dataclass(frozen=True, slots=True)
class Knob:
    """One parameter, as a control of the studio shows it: metadata of its key in a table.

    A "switch" is on or off, a "size" is a width and a height. The unit "length" is the design's.
    Without a slider it depends on the curves how far it reaches. What is ``advanced`` is folded
    away until it is asked for. Its kind, whether it may be "auto", and its choices, where the type
    of its key lists them, are those of that type: ``knobs_of`` fills them in.
    """

    label: str
    help: str
    unit: Measure = ""
    _: KW_ONLY
    slider: tuple[float, float] | None = None
    step: float | None = None
    advanced: bool = False
    choices: tuple[str, ...] = ()
    kind: Kind = "number"
    auto: bool = False

    @classmethod
    def angle(
        cls,
        label: str,
        help: str,  # noqa: A002 # the field's name
        slider: tuple[float, float],
        *,
        step: float = 0.5,
        advanced: bool = False,
    ) -> Knob:
        """A knob for an angle in degrees."""
        return cls(label, help, "deg", slider=slider, step=step, advanced=advanced)

    def of_type(self, annotation: Any) -> Knob:
        """The knob of a key with such a type."""
        found = list(_alternatives(annotation))
        listed = [each for each in found if isinstance(each, str) and each != "auto"]
        choices = self.choices or tuple(dict.fromkeys(listed))
        kinds: list[Kind] = [KINDS[each] for each in found if each in KINDS]
        kind: Kind = "choice" if choices else next(iter(kinds), "number")
        return replace(self, kind=kind, auto="auto" in found and not choices, choices=choices)


KINDS: Final[dict[Any, Kind]] = {int: "integer", bool: "switch", list: "angles4", tuple: "size"}
"""Controls of the types that are neither numbers nor choices."""


def _alternatives(annotation: Any) -> Iterator[Any]:
    """The types that a value may have, lists and tuples without their entries, and literals."""
    origin = get_origin(annotation)
    if origin is Annotated:
        yield from _alternatives(get_args(annotation)[0])
    elif origin is Literal:
        yield from get_args(annotation)
    elif origin in (Union, UnionType):
        for each in get_args(annotation):
            yield from _alternatives(each)
    else:
        yield origin or annotation


def knobs_of(model: type[BaseModel]) -> dict[str, Knob]:
    """The knobs of all keys of a table that the studio shows, in their order."""
    return {
        key: each.of_type(field.annotation)
        for key, field in model.model_fields.items()
        for each in field.metadata
        if isinstance(each, Knob)
    }
