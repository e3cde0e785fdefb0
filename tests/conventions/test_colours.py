"""One colour for one meaning, wherever it is seen: files and pages are read back."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import numpy as np
import pygltflib
import pytest
import rhino3dm

from documents import demo_document
from orishell.conventions.colours import (
    AMOUNT_MAP,
    DARK,
    DISTANCE_MAP,
    LIGHT,
    linear_rgb,
    rgb,
)
from orishell.io import Settings
from orishell.io.formats import find_formats
from orishell.workshop.palettes import load_palette

SHARED = Path(__file__).parents[2] / "frontend" / "src" / "shared"
DRAWN = {"MOUNTAIN": "mountain", "VALLEY": "valley", "CUT": "border-crease"}


def written(name: str, directory: Path) -> Path:
    (format_,) = find_formats([name])
    format_.write(directory / format_.file, demo_document(), Settings())
    return directory / format_.file


def style_sheet() -> str:
    """The text of ``frontend/src/shared/meanings.css``: the colours for pages."""
    themes = (
        (":root,\n:host", LIGHT),
        (':root[data-theme="dark"],\n:host([data-theme="dark"])', DARK),
    )
    blocks = [
        f"{where} {{\n" + "".join(f"  --{name}: {value};\n" for name, value in each.items())
        for where, each in themes
    ]
    return (
        "/* Made from src/orishell/conventions/colours.py by tests/conventions/test_colours.py; "
        "do not edit. */\n" + "}\n".join(blocks) + "}\n"
    )


def test_numbers_of_a_colour() -> None:
    assert rgb("mountain") == (0xD6 / 255, 0x27 / 255, 0x28 / 255)
    # IEC 61966-2-1: half the light is 188 of 255, and the ends are the ends.
    np.testing.assert_allclose(linear_rgb("mountain"), [0.672443, 0.0202886, 0.0212190], rtol=1e-5)
    assert linear_rgb("border-crease") == (0, 0, 0)
    assert set(LIGHT) == set(DARK)


def test_pages_have_the_same_colours() -> None:
    sheet = SHARED / "meanings.css"
    if os.environ.get("ORISHELL_WRITE_GOLDEN"):
        sheet.write_text(style_sheet())
    assert sheet.read_text() == style_sheet()
    assert all(f"--{name}: {colour};" in style_sheet() for name, colour in LIGHT.items())
    theme = (SHARED / "theme.css").read_text()
    assert not [name for name in LIGHT if f"--{name}:" in theme]
    for name, colours in (("DISTANCE_MAP", DISTANCE_MAP), ("AMOUNT_MAP", AMOUNT_MAP)):
        (ramp,) = re.findall(rf"{name} = \[(.*?)\]", (SHARED / "colours.ts").read_text())
        assert tuple(re.findall(r"#[0-9a-f]{6}", ramp)) == colours


def test_the_palette_to_look_at_and_its_drawings(tmp_path: Path) -> None:
    colours = {str(layer): pen.colour for layer, pen in load_palette("plain").pens.items()}
    for layer, meaning in DRAWN.items():
        assert colours[layer] == LIGHT[meaning]
    svg = written("svg", tmp_path).read_text()
    for layer, meaning in DRAWN.items():
        (group,) = re.findall(rf'<g[^>]*id="{layer}"[^>]*>', svg)
        assert f'stroke="{LIGHT[meaning]}"' in group
    pdf = written("pdf", tmp_path).read_bytes().decode("latin-1")
    strokes = {
        tuple(round(255 * float(each)) for each in found)
        for found in re.findall(r"(?m)^([.\d]+) ([.\d]+) ([.\d]+) RG", pdf)
    }
    assert strokes >= {tuple(round(255 * each) for each in rgb(name)) for name in DRAWN.values()}


def test_rhino(tmp_path: Path) -> None:
    model: Any = rhino3dm.File3dm.Read(str(written("3dm", tmp_path)))
    colours = {layer.Name: layer.Color for layer in model.Layers}
    meanings = DRAWN | {"f": "curve-f", "g": "curve-g", "panels": "panel-front"}
    for layer, meaning in meanings.items():
        wanted = tuple(round(255 * each) for each in rgb(meaning))
        assert tuple(colours[layer])[:3] == wanted, layer


@pytest.mark.parametrize("state", [0, "target"])
def test_lines_of_gltf(state: int, tmp_path: Path) -> None:
    """Every edge is drawn once, in the colour of its assignment, with a panel beside it."""
    document = demo_document()
    (format_,) = find_formats(["glb"])
    format_.write(tmp_path / "a.glb", document, Settings(state=state))
    file: Any = pygltflib.GLTF2().load(str(tmp_path / "a.glb"))
    blob = file.binary_blob()
    names = [material.name for material in file.materials]
    for material in file.materials:
        found = material.pbrMetallicRoughness.baseColorFactor
        np.testing.assert_allclose(found, [*linear_rgb(material.name), 1.0])
    mesh = document.mesh
    drawn: dict[tuple[int, int], str] = {}
    for panel, node in enumerate(file.nodes[1:]):
        area, *lines = file.meshes[node.mesh].primitives
        assert (area.mode, names[area.material]) == (4, "panel-front")
        for line in lines:
            assert line.mode == 1
            assert line.attributes.POSITION == area.attributes.POSITION
            accessor = file.accessors[line.indices]
            begin = file.bufferViews[accessor.bufferView].byteOffset + accessor.byteOffset
            ends = np.frombuffer(blob, "<u2", accessor.count, begin).reshape(-1, 2)
            for first, second in np.sort(mesh.faces[panel][ends], axis=1).tolist():
                assert (first, second) not in drawn
                drawn[first, second] = names[line.material]
    meanings = {"M": "mountain", "V": "valley", "F": "unfolded", "B": "border-crease"}
    edges = np.sort(mesh.edges, axis=1).tolist()
    assert drawn == {
        (first, second): meanings[letter]
        for (first, second), letter in zip(edges, document.assignment, strict=True)
    }
