"""A client that does what Rhino's Hops does with a server, for tests.

Written after the source of Hops (``src/hops`` of mcneel/compute.rhino3d: RemoteDefinition.cs,
HopsComponent.cs): which addresses it asks, what it posts, what it takes of an answer.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import httpx

from orishell.io.rhino_geometry import rhino3dm
from studio_server import free_port

rhino = rhino3dm()
DOTNET = {str: "System.String", bool: "System.Boolean", int: "System.Int32", float: "System.Double"}
ITEM = (1, 1)
GEOMETRY = {
    "Rhino.Geometry.Mesh": rhino.Mesh,
    "Rhino.Geometry.PolylineCurve": rhino.PolylineCurve,
}
STRUCTURES = {"Rhino.Geometry.Line", "Rhino.Geometry.Plane", "Rhino.Geometry.Point3d"}


@contextmanager
def running_hops() -> Iterator[str]:
    """Where ``orishell hops`` answers as long as the context lasts, with a key of its own."""
    port = free_port()
    with tempfile.TemporaryDirectory() as home, Path(home, "words").open("wb") as heard:
        words = Path(heard.name)
        command = [sys.executable, "-m", "orishell", "hops", "--port", str(port)]
        process = subprocess.Popen(command, env={**os.environ, "HOME": home}, stderr=heard)
        try:
            yield _printed(process, words)
        finally:
            process.terminate()
            process.wait(timeout=30)
            assert "Traceback" not in words.read_text()


def _printed(process: subprocess.Popen[bytes], words: Path) -> str:
    end = time.monotonic() + 60
    while time.monotonic() < end and process.poll() is None:
        if found := re.search(r"at (http\S+)", words.read_text()):
            return found[1]
        time.sleep(0.05)
    raise RuntimeError(words.read_text())


class HopsError(Exception):
    """The component turns red: what its balloon says."""


def sent_as(value: Any) -> dict[str, str]:
    """A value as Hops sends it: the type of .NET, and JSON in a text."""
    if isinstance(value, dict):  # of an object that is to be spoilt
        return value
    if type(value) in DOTNET:
        return {"type": DOTNET[type(value)], "data": json.dumps(value)}
    return {"type": f"Rhino.Geometry.{type(value).__name__}", "data": json.dumps(value.Encode())}


def taken(item: Mapping[str, str]) -> Any:
    """What Hops makes of an item of an answer: texts lose quotation marks at their ends only."""
    kind, data = item["type"], item["data"].strip('"')
    if kind == "System.String":
        assert not (data.strip().startswith("{") and "\\" in data)  # Hops would unescape it
        return data
    if kind == "System.Boolean":
        return {"true": True, "false": False}[data.lower()]
    if kind in STRUCTURES:
        return json.loads(data)
    found = rhino.CommonObject.Decode(json.loads(data))
    assert isinstance(found, GEOMETRY[kind])
    return found


@dataclass
class Document:
    """A Grasshopper document: its unit, and the answers that Hops keeps for it."""

    client: httpx.Client  # with the address as its base, and the key in it
    unit: str = "Meters"
    kept: dict[str, Any] = field(default_factory=dict)

    def place(self, name: str) -> dict[str, Any]:
        """Set a component by its path: Hops asks twice, and takes no answer that is no JSON."""
        for _ in range(2):
            answer = self.client.get(name)
            assert "json" in answer.headers["content-type"]
        found: dict[str, Any] = answer.json()
        assert {"Description", "Inputs", "Outputs"} <= found.keys()
        return found

    def body(self, name: str, **given: Any) -> dict[str, Any]:
        """What Hops posts: every input, unconnected ones with their default."""
        values = []
        for port in self.place(name)["Inputs"]:
            assert (port["AtLeast"], port["AtMost"]) == ITEM
            value = given.pop(port["Name"], port["Default"])
            assert value is not None, f"{port['Name']} is not connected"
            branch = value if isinstance(value, list) else [value]
            tree = {"0": [sent_as(each) for each in branch]}
            values.append({"ParamName": port["Name"], "InnerTree": tree})
        assert not given
        return {
            "absolutetolerance": 0.001,
            "angletolerance": 1.0,
            "modelunits": self.unit,
            "algo": None,
            "pointer": name,
            "cachesolve": True,
            "recursionlevel": 0,
            "values": values,
            "warnings": [],
            "errors": [],
        }

    def solve(self, name: str, **given: Any) -> dict[str, Any]:
        """What the outputs have, each a value, a list or a tree; raises HopsError if it is red."""
        return self.post(self.body(name, **given), name)

    def post(self, body: Mapping[str, Any], name: str) -> dict[str, Any]:
        """The answer to a request, from what Hops keeps if it has it."""
        text = json.dumps(body)
        if text not in self.kept:
            answer = self.client.post(
                "solve",
                content=text,
                headers={"content-type": "application/json; charset=utf-8"},
            )
            assert answer.status_code not in {500, 408}  # of which Hops makes something else
            schema = answer.json()
            assert {"values", "errors", "warnings"} <= schema.keys()
            if schema["errors"]:
                assert answer.status_code != 200  # Hops would keep it
                raise HopsError(*schema["errors"])
            self.kept[text] = schema
        schema = self.kept[text]
        self.warnings = schema["warnings"]
        assert [each["ParamName"] for each in schema["values"]] == [
            port["Name"] for port in self.place(name)["Outputs"]
        ]
        return {each["ParamName"]: _structure(each["InnerTree"]) for each in schema["values"]}


def _structure(tree: Mapping[str, Any]) -> Any:
    branches = {path: [taken(item) for item in items] for path, items in tree.items()}
    items = [item for each in branches.values() for item in each]
    if len(items) == 1:
        return items[0]
    return items if len(branches) <= 1 else branches
