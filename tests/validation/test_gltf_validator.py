"""Khronos' glTF validator (npm, 2.0.0-dev.3.10) finds nothing wrong with our glTF files."""

from __future__ import annotations

import json
import struct
from functools import partial
from pathlib import Path

import pytest

from documents import FAMILIES, demo_document, thick_document
from node_tools import ask_node
from orishell.io.format import DEFAULT_SETTINGS
from orishell.io.formats.gltf import write_gltf

DOCUMENTS = {
    **{family: partial(demo_document, family) for family in FAMILIES},
    "sandwich": partial(thick_document, "orthodiagonal", "sandwich"),
    "bevel": partial(thick_document, "orthodiagonal", "bevel"),
}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_no_errors_and_no_warnings(tmp_path: Path, name: str) -> None:
    document = DOCUMENTS[name]()
    write_gltf(tmp_path / "shell.glb", document, DEFAULT_SETTINGS)
    report = ask_node("validate_gltf.cjs", {"path": str(tmp_path / "shell.glb")})
    assert report["mimeType"] == "model/gltf-binary"
    issues = report["issues"]
    assert issues["messages"] == []
    assert (issues["numErrors"], issues["numWarnings"]) == (0, 0)
    # It has looked at the whole shell and its motion.
    assert report["info"]["animationCount"] == 1
    assert report["info"]["totalTriangleCount"] >= 2 * len(document.mesh.faces)


def test_the_validator_would_tell(tmp_path: Path) -> None:
    """A vertex outside the bounds that the file states is an error."""
    path = tmp_path / "shell.glb"
    write_gltf(path, demo_document(), DEFAULT_SETTINGS)
    content = path.read_bytes()
    (length,) = struct.unpack_from("<I", content, 12)
    described = json.loads(content[20 : 20 + length])
    bounded = next(accessor for accessor in described["accessors"] if "max" in accessor)
    bounded["max"][0] += 1.0
    text = json.dumps(described).encode()
    text += b" " * (-len(text) % 4)
    rest = content[20 + length :]
    path.write_bytes(
        struct.pack("<4sIII", b"glTF", 2, 20 + len(text) + len(rest), len(text))
        + b"JSON"
        + text
        + rest
    )
    issues = ask_node("validate_gltf.cjs", {"path": str(path)})["issues"]
    assert issues["numErrors"] >= 1
    assert "ACCESSOR_MAX_MISMATCH" in {message["code"] for message in issues["messages"]}
