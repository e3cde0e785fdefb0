"""What Hops, Rhino's component for programs over HTTP, sends and reads.

It asks a component's address for its ports, and posts its inputs to ``solve``. A value is a text
with JSON in it and the name of its type in .NET. Hops keeps answers of status 200 by their
requests: so refusals have another. It takes quotation marks away from both ends of a text, no
more, and reads numbers as its country writes them: so texts are sent as they are, numbers never.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

import orjson

from orishell.conventions.errors import InputError
from orishell.io.rhino_geometry import UNIT_SYSTEMS, rhino3dm

GIVEN: Final[dict[str, dict[str, Any]]] = tomllib.loads(
    Path(__file__).with_name("components.toml").read_text(encoding="utf-8")
)
"""The components by their paths: names, drawings, ports."""
SENT: Final = {
    "Text": "System.String",
    "Boolean": "System.Boolean",
    "Curve": "Rhino.Geometry.PolylineCurve",
    "Mesh": "Rhino.Geometry.Mesh",
    "Line": "Rhino.Geometry.Line",
    "Plane": "Rhino.Geometry.Plane",
    "Point": "Rhino.Geometry.Point3d",
}
"""The types of what components give, by the kinds of their ports."""
UNITS: Final = {name: unit for unit, name in UNIT_SYSTEMS.items()}
TAKEN: Final = {"Text": (str,), "Boolean": (bool,), "Integer": (int,), "Number": (float, int)}
ICON: Final = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="24" height="24" fill="none" stroke="#1d3d5c" '
    'stroke-width="1.8" stroke-linejoin="round" stroke-linecap="round"><path d="{}"/></svg>'
)


def described(path: str) -> dict[str, object]:
    """A component as Hops reads it: each input takes one value, an output may give a tree.

    Parameters
    ----------
    path
        Its address below the program's.
    """

    def ports(given: Mapping[str, Sequence[Any]]) -> list[dict[str, object]]:
        return [
            {
                **{"Name": name, "ParamType": kind, "Description": what},
                **{"AtLeast": 1, "AtMost": 1, "Default": default[0] if default else None},
            }
            for name, (kind, what, *default) in given.items()
        ]

    given = GIVEN[path]
    return {
        **{"Uri": f"/{path}", "Name": given["name"], "Category": "orishell"},
        **{"Description": given["what"], "Icon": ICON.format(given["icon"])},
        **{"Inputs": ports(given["inputs"]), "Outputs": ports(given["outputs"])},
    }


def values_of(path: str, sent: Any) -> dict[str, Any]:
    """The values of a component's inputs by their names; geometry as rhino3dm has it.

    Parameters
    ----------
    path
        The component's.
    sent
        The values of a request.

    Raises
    ------
    InputError
        If one is missing, or is not what the input takes.
    """
    items: dict[str, list[Any]] = {}
    try:
        for tree in sent:
            items[tree["ParamName"]] = [
                item for each in tree["InnerTree"].values() for item in each
            ]
        return {
            name: _value(name, items.get(name, []), *port)
            for name, port in GIVEN[path]["inputs"].items()
        }
    except (AttributeError, KeyError, TypeError):
        expected = "items with type and data, in InnerTree of each ParamName"
        what = "these are no values as Hops sends them"
        raise InputError(what, expected=expected, remedy="update Hops") from None


def _value(name: str, items: list[Any], kind: str, _: str, *default: Any) -> Any:
    """The one value of an input."""
    if default and not items:
        return default[0]
    if len(items) != 1:
        got, remedy = f"{len(items)}", "connect one, and set the component anew by its path"
        raise InputError("one value is expected", where=f"input {name}", got=got, remedy=remedy)
    value = plain_value(items[0]["data"])
    if kind == "Text" and isinstance(value, int | float) and not isinstance(value, bool):
        value = str(items[0]["data"])
    if kind == "Integer" and isinstance(value, float) and value.is_integer():
        value = int(value)
    if kind not in TAKEN:
        value = _decoded(value)
    fits = TAKEN.get(kind, (rhino3dm().GeometryBase,))
    if not isinstance(value, fits) or (isinstance(value, bool) and kind != "Boolean"):
        raise unfit(name, str(items[0]["type"]), kind)
    return float(value) if kind == "Number" else value


def unfit(name: str, got: str, kind: str) -> InputError:
    """The refusal of a value that an input does not take.

    Parameters
    ----------
    name
        The input's.
    got, kind
        What there is, and what it takes.
    """
    what, remedy = "this does not fit", f"connect what is a {kind.lower()}"
    return InputError(what, where=f"input {name}", got=got[:60], expected=kind, remedy=remedy)


def plain_value(data: str) -> Any:
    """What JSON in a text says; a text that is none is itself.

    Parameters
    ----------
    data
        The text.
    """
    try:
        return orjson.loads(data)
    except orjson.JSONDecodeError:
        return data


def _decoded(value: Any) -> Any:
    """What rhino3dm makes of an object that Rhino encoded; None if it is none."""
    try:
        return rhino3dm().CommonObject.Decode(value)
    except (RuntimeError, TypeError, ValueError, KeyError):
        return None


def answered(path: str, given: Sequence[Any], warnings: Sequence[str] = ()) -> bytes:
    """The answer of a component.

    Parameters
    ----------
    path
        The component's.
    given
        What its outputs have, in their order: a value, a list, or lists by the path of their
        branch. Texts, also of JSON, are sent as they are; what rhino3dm has is encoded.
    warnings
        What Grasshopper says beside it.
    """
    outputs = zip(GIVEN[path]["outputs"].items(), given, strict=True)
    values = [
        {"ParamName": name, "InnerTree": _tree(SENT[kind], value)}
        for (name, (kind, *_)), value in outputs
    ]
    return orjson.dumps({"values": values, "warnings": list(warnings), "errors": []})


def refused(message: str) -> bytes:
    """The answer to what is refused, which becomes the component's error.

    Parameters
    ----------
    message
        The whole message, with its remedy.
    """
    return orjson.dumps({"values": [], "warnings": [], "errors": [message]})


def _tree(kind: str, value: Any) -> dict[str, list[dict[str, str]]]:
    if not isinstance(value, dict):
        value = {"0": value if isinstance(value, list) else [value]}
    return {
        branch: [{"type": kind, "data": _data(item)} for item in items]
        for branch, items in value.items()
        if items
    }


def _data(item: Any) -> str:
    if isinstance(item, str):
        return item
    return orjson.dumps(item.Encode() if hasattr(item, "Encode") else item).decode()
