"""All formats by one test: what is written is what is read back, in any unit."""

import json
import math
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from cad_tools import REQUIRED as CAD
from documents import EXAMPLES, FAMILIES, SMALL, demo_document, loaded_document, thick_document
from io_readers import READERS
from node_tools import REQUIRED as NODE
from node_tools import lacking
from orishell.conventions.errors import InputError
from orishell.document import LARGEST_COORDINATE, SHELL, Document
from orishell.io import Settings, document_of_fold, read_fold, write_fold
from orishell.io.format import Format
from orishell.io.formats import (
    ALL,
    all_formats,
    find_formats,
    format_modules,
    format_of,
    formats_for,
)
from orishell.io.solids import solids_in
from samples import thorough

Array = NDArray[np.float64]

METRES = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254, "ft": 0.3048}
SINGLE = {"glb", "stl", "3dm", "html", "3mf", "step"}
"""Formats whose coordinates are single precision, or about as exact."""

STEP = ("orthodiagonal", "in")
"""Whose STEP file is always read back."""


def in_unit(document: Document, unit: str) -> Document:
    """The same numbers, of another unit."""
    return replace(document, unit=unit)


def farthest(points: Array, others: Array) -> float:
    """Largest distance of a point from the nearest of the others."""
    away = np.linalg.norm(points[:, None] - others[None], axis=-1)
    return float(away.min(axis=1).max())


def corners(document: Document) -> Array:
    """Corners (k, 3) of all boards at the target."""
    return np.concatenate([each.corners.reshape(-1, 3) for each in solids_in(document, SHELL)])


@pytest.mark.parametrize(
    ("format_", "family", "unit"),
    [
        pytest.param(
            *(format_, family, unit),
            id=f"{unit}-{family}-{format_.name}",
            marks=[thorough]
            * ((family, unit) != STEP and (format_.name == "step" or unit == STEP[1])),
        )
        for unit in ("m", "in")
        for family in FAMILIES
        for format_ in all_formats()
    ],
)
def test_what_is_written_is_read_back(
    format_: Format, family: str, unit: str, tmp_path: Path
) -> None:
    if not format_.ready():
        lacking(f"{format_.missing}: {format_.remedy}", CAD if format_.solid else NODE)
    if format_.solid:
        document = thick_document(family, size=SMALL)
    elif format_.analysed:
        document = loaded_document(family)
    else:
        document = demo_document(family, size=SMALL)
    document = in_unit(document, unit)
    assert document.flat is not None
    path = tmp_path / format_.file
    format_.write(path, document, Settings(print_state="target"))
    content = READERS[format_.name](path)
    scale = 1.0
    if content.metres is not None:
        scale = content.metres / METRES[unit]
    size = float(np.linalg.norm(np.ptp(document.flat, axis=0)))
    if content.space is not None:
        precision = 1e-6 if format_.name in SINGLE else 1e-12
        there, here = scale * content.space, document.shell.positions
        if format_.solid:  # corners of boards, up to the place where they are printed
            there, here = (each - each.min(axis=0) for each in (there, corners(document)))
        assert farthest(there, here) < precision * size
        assert farthest(here, there) < precision * size
    if content.plane is not None and format_.name != "origami-simulator":
        shift = scale * content.plane.min(axis=0) - document.flat.min(axis=0)
        # Not the other way: corners between two cuts, or two creases, in a line are left out.
        assert farthest(scale * content.plane - shift, document.flat) < 1e-9 * size
    if content.lengths is not None:
        ends = document.flat[document.mesh.edges]
        length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        letters = np.array(document.assignment)
        expected = {letter: float(length[letters == letter].sum()) for letter in "MV"}
        if format_.name == "origami-simulator":  # its page has no unit
            scale = sum(expected.values()) / sum(content.lengths.values())
        for letter, total in expected.items():
            assert scale * content.lengths[letter] == pytest.approx(total, rel=1e-6)
    # Something of the shell is compared for every format but what is printed to be read.
    found = [content.space, content.plane, content.lengths]
    assert format_.task in ("paper", "kit") or any(each is not None for each in found)


def test_every_format_has_a_reader() -> None:
    assert [each.name for each in all_formats()] == list(format_modules()) == sorted(READERS)


TOY = """
from orishell.io.format import Format

def write_toy(path, document, settings):
    path.write_text(document.title)

FORMAT = Format("toy", "shell.toy", (".toy",), "the title alone", write_toy)
"""


ONE_FORMAT_MORE = """
import json, sys
from orishell.io import formats
formats.__path__.append(sys.argv[1])
from orishell.cli.main import run

for words in json.loads(sys.argv[2]):
    sys.argv = ["orishell", *words]
    try:
        run()
    except SystemExit as ended:
        if ended.code:
            raise
"""


def test_a_format_is_one_file(tmp_path: Path) -> None:
    (tmp_path / "toy.py").write_text(TOY)
    text = (EXAMPLES / "figure1.toml").read_text()
    for many, few in (("rows = 9 ", "rows = 5 "), ("columns = 11 ", "columns = 5 ")):
        assert many in text
        text = text.replace(many, few)
    (tmp_path / "figure1.toml").write_text(text)
    out = ("--out", ".", "--write", "toy", "--no-clash-test")
    calls = [
        ["design", "--help"],
        ["design", "figure1.toml", *out],
        ["convert", "shell.fold", "again.toy"],
    ]
    command = [sys.executable, "-c", ONE_FORMAT_MORE, str(tmp_path), json.dumps(calls)]
    said = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    assert re.search(r"svg,\W+toy,\W+vtu;\W+or\W+all", said)
    assert (tmp_path / "shell.toy").read_text().startswith("figure1: parallel-repeating")
    assert (tmp_path / "again.toy").read_bytes() == (tmp_path / "shell.toy").read_bytes()


@pytest.mark.parametrize("family", FAMILIES)
def test_fold_is_lossless_to_the_bit(family: str, tmp_path: Path) -> None:
    document = demo_document(family)
    write_fold(tmp_path / "one.fold", document)
    again = document_of_fold(read_fold(tmp_path / "one.fold"))
    write_fold(tmp_path / "two.fold", again)
    assert (tmp_path / "one.fold").read_bytes() == (tmp_path / "two.fold").read_bytes()
    np.testing.assert_array_equal(again.flat, document.flat)
    np.testing.assert_array_equal(again.fold_angles_deg, document.fold_angles_deg)
    assert again.assignment == document.assignment
    assert again.grid_shape == document.grid_shape
    assert len(again.states) == len(document.states)
    for ours, theirs in zip(document.states, again.states, strict=True):
        np.testing.assert_array_equal(ours.positions, theirs.positions)
        np.testing.assert_array_equal(ours.fold_angles_deg, theirs.fold_angles_deg)
        assert ours.drive_deg == theirs.drive_deg


def test_names_and_endings() -> None:
    assert find_formats([ALL]) == tuple(each for each in all_formats() if each.ready())
    assert [each.name for each in find_formats([" SVG", "dxf", "svg"])] == ["dxf", "svg"]
    assert find_formats([]) == ()
    with pytest.raises(InputError, match="dwg"):
        find_formats(["dxf", "dwg"])
    assert format_of(Path("a/b.SVG")).name == "svg"
    assert format_of(Path("b.origami-simulator.svg")).name == "origami-simulator"
    assert format_of(Path("b.pvd")).name == "vtu"
    for path in ("b.dwg", "b", ".svg"):
        with pytest.raises(InputError, match="no format has this ending"):
            format_of(Path(path))


def test_all_means_solids_and_structures_only_where_there_are_any() -> None:
    thin, thick = demo_document("orthodiagonal"), thick_document("orthodiagonal")
    loaded = loaded_document("orthodiagonal").loaded
    solid = {each.name for each in all_formats() if each.solid}
    analysed = {each.name for each in all_formats() if each.analysed}
    assert (solid, analysed) == ({"step", "3mf"}, {"inp"})
    chosen, missing = formats_for([ALL], thin)
    assert (solid | analysed).isdisjoint(each.name for each in (*chosen, *missing))
    chosen, missing = formats_for([ALL], thick)
    assert analysed.isdisjoint(each.name for each in (*chosen, *missing))
    assert "booklet" not in {each.name for each in (*chosen, *missing)}
    designed = replace(thick, loaded=loaded, report={"unit": "m"})
    chosen, missing = formats_for([ALL], designed)
    assert {*chosen, *missing} == set(all_formats())
    assert all(each.ready() for each in chosen)
    assert not any(each.ready() for each in missing)
    # Who names one gets it, or learns why not.
    assert "3mf" in {each.name for each in formats_for(["3mf", ALL], thin)[0]}
    assert [each.name for each in formats_for(["", "3mf"], thin)[0]] == ["3mf"]


def test_what_no_format_holds_is_refused() -> None:
    """Single precision, which STL, glTF and the pages have, ends at 3.4e38."""
    document = demo_document()
    assert document.flat is not None
    for size in (1e37, math.inf, math.nan):
        with pytest.raises(InputError, match="too large for files"):
            replace(document, flat=document.flat * size)
    replace(document, flat=document.flat / np.abs(document.flat).max() * LARGEST_COORDINATE)


def test_a_paper_model_of_what_is_larger_than_all_measure_is_refused(tmp_path: Path) -> None:
    document = demo_document()
    assert document.flat is not None
    huge = replace(document, flat=document.flat * 1e20)
    (pdf,) = find_formats(["pdf"])
    with pytest.raises(InputError, match="too large for a paper model"):
        pdf.write(tmp_path / "a.pdf", huge, Settings())
