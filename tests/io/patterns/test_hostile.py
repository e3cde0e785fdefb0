"""500 files that mean no good: each is read, or refused with one error of one line.

Good files are damaged by a generator with a fixed seed, in their bytes and in what they say.
"""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.io import read_pattern
from patterns import dxf_of, fold_of, huffman, miura, svg_of, write
from samples import THOROUGH
from timing import HANGS

FILES = 500 if THOROUGH else 60
SECONDS = HANGS
"""Most processor time that a file may take: 0.15 were seen."""
REFUSED = 0.8
"""At least so many must be refused: otherwise the damage tests nothing. 0.9 were."""

Generator = np.random.Generator
ABSURD: list[Any] = [None, True, -1, 1e400, 1e300, -1e-320, 10**30, 0.5]
ABSURD += ["x", [], {}, [[]], "\0", "NaN"]


def good(kind: str, rng: Generator) -> str:
    pattern = miura(3, 3) if rng.integers(2) else huffman(3, 4)
    if kind == "svg":
        return svg_of(pattern, width_mm=100.0 if rng.integers(2) else None)
    if kind == "dxf":
        return dxf_of(pattern)
    keys = fold_of(pattern, faces=bool(rng.integers(4)))
    if rng.integers(2):
        folded = np.column_stack([pattern.vertices, np.ones(len(pattern.vertices))]).tolist()
        frame = {"frame_inherit": True, "frame_parent": 0, "vertices_coords": folded}
        keys["file_frames"] = [frame]
    return json.dumps(keys, indent=0)


def cut_off(text: str, rng: Generator) -> str:
    return text[: rng.integers(len(text))]


def twice(text: str, rng: Generator) -> str:
    a, b = np.sort(rng.integers(0, len(text), 2))
    return text[:b] + text[a:]


def garbled(text: str, rng: Generator) -> str:
    letters = list(text)
    for place in rng.integers(0, len(text), 1 + len(text) // 200):
        letters[place] = chr(rng.integers(1, 300))
    return "".join(letters)


def other_numbers(text: str, rng: Generator) -> str:
    """A few numbers by others: also such as make lines cross, or panels lie on each other."""
    numbers = list(re.finditer(r"-?\d+(\.\d+)?(e-?\d+)?", text))
    values = [
        "0",
        "-1",
        "1e308",
        "1e999",
        "1",
        "2.5",
        "99999999999999999999",
        "-7",
        "nan",
        "3e-300",
    ]
    for k in sorted(rng.choice(len(numbers), min(4, len(numbers)), replace=False), reverse=True):
        begin, end = numbers[k].span()
        text = text[:begin] + values[rng.integers(len(values))] + text[end:]
    return text


def lines_mixed(text: str, rng: Generator) -> str:
    lines = text.split("\n")
    for _ in range(1 + len(lines) // 20):
        a, b = rng.integers(0, len(lines), 2)
        lines[a], lines[b] = lines[b], lines[a]
    return "\n".join(lines)


def of_wrong_type(text: str, rng: Generator) -> str:
    """Of FOLD a value somewhere in it; of others a word."""
    if text[:1] != "{":
        words = list(re.finditer("[A-Za-z]{3,}", text))
        word = words[rng.integers(len(words))]
        return text[: word.start()] + "é<&0" + text[word.end() :]
    keys = json.loads(text)
    at: Any = keys
    while True:
        place = list(at)[rng.integers(len(at))] if isinstance(at, dict) else rng.integers(len(at))
        inner = at[place]
        if not isinstance(inner, list | dict) or not inner or not rng.integers(3):
            break
        at = inner
    at[place] = ABSURD[rng.integers(len(ABSURD))]
    return json.dumps(keys)


def without_a_part(text: str, rng: Generator) -> str:
    a, b = np.sort(rng.integers(0, len(text), 2))
    return text[:a] + text[a + (b - a) // 3 :]


def rubbish(_: str, rng: Generator) -> str:
    return rng.bytes(500).decode("latin-1")


DAMAGES: list[Callable[[str, Generator], str]] = [
    cut_off, twice, garbled, other_numbers, other_numbers, lines_mixed, of_wrong_type,
    of_wrong_type, without_a_part, rubbish,
]  # fmt: skip


def outcome(path: Path) -> str:
    """The message with which a file is refused; empty if it is read."""
    try:
        found = read_pattern(path)
    except InputError as error:
        return str(error)
    assert found.flat is None or np.isfinite(found.flat.vertices).all()
    return ""


def test_hostile_files_are_read_or_refused_in_one_line(tmp_path: Path) -> None:
    refused = 0
    outcome(write(tmp_path / "good.dxf", miura(2, 2)))  # what is imported then is not counted
    for number in range(FILES):
        rng = np.random.default_rng([20261126, number])
        kind = ("fold", "svg", "dxf")[number % 3]
        damage = DAMAGES[number // 3 % len(DAMAGES)]
        path = tmp_path / f"hostile-{number}.{kind}"
        path.write_text(damage(good(kind, rng), rng), encoding="utf-8", errors="replace")
        begin = time.process_time()
        message = outcome(path)
        assert time.process_time() - begin < SECONDS, f"{number}: {damage.__name__}"
        if message:
            refused += 1
            assert "\n" not in message
            assert str(path) in message
            assert len(message) < 1000
    assert refused > REFUSED * FILES


SVG = "http://www.w3.org/2000/svg"
TRIANGLE = {"faces_vertices": [[0, 1, 2]]}


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("deep.fold", "[" * 100_000),
        ("deep.svg", "<svg>" + "<g>" * 5000),
        ("bomb.svg", '<!DOCTYPE svg [<!ENTITY a "aaaa">]><svg>&a;</svg>'),
        ("uses.svg", f'<svg xmlns="{SVG}"><g id="a"><use href="#a"/></g></svg>'),
        ("far.fold", json.dumps({**TRIANGLE, "vertices_coords": [[1e200, 0]] * 3})),
        ("same.fold", json.dumps({**TRIANGLE, "vertices_coords": [[0, 0]] * 3})),
        ("none.fold", "{}"),
        ("frames.fold", json.dumps({"file_frames": [{"frame_inherit": True, "frame_parent": 1}]})),
        ("none.dxf", "0\nEOF\n"),
    ],
)
def test_files_that_would_do_harm(name: str, content: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(content)
    with pytest.raises(InputError) as caught:
        read_pattern(tmp_path / name)
    assert "\n" not in str(caught.value)


def test_many_lines_across_each_other_are_refused_before_any_are_compared(tmp_path: Path) -> None:
    count = 1010  # a million crossings, and twenty thousand more
    rows = [f"M0 {k}H{count}M{k} 0V{count}" for k in range(count)]
    (tmp_path / "weave.svg").write_text(
        f'<svg xmlns="{SVG}" stroke="red">'
        + "".join(f'<path d="{row}"/>' for row in rows)
        + "</svg>"
    )
    with pytest.raises(InputError, match=r"too many lines .* at most 1000000 pairs"):
        read_pattern(tmp_path / "weave.svg")


def test_many_pieces_on_one_line_are_refused_before_any_are_compared(tmp_path: Path) -> None:
    """A line that runs to and fro 6000 times: all pieces lie on each other, 18 million pairs."""
    points = " ".join(f"{k % 2 * (5 + k % 7)},0" for k in range(6001))
    (tmp_path / "hatch.svg").write_text(
        f'<svg xmlns="{SVG}" stroke="red"><polyline points="{points}"/></svg>'
    )
    with pytest.raises(InputError, match="6000 lines, expected at most 1000000 pairs"):
        read_pattern(tmp_path / "hatch.svg")


def test_a_long_mark_within_a_panel_is_left_out_soon(tmp_path: Path) -> None:
    """A comb of 2000 teeth: taken away from its ends, one at a time, it would take minutes."""
    teeth = "".join(f"M{k} 1V{k % 7 + 2}M{k} 1H{k + 1}" for k in range(1, 2000))
    path = tmp_path / "comb.svg"
    path.write_text(
        f'<svg xmlns="{SVG}"><path d="M0 0H3000V9H0z" stroke="black"/>'
        f'<path d="{teeth}" stroke="yellow"/></svg>'
    )
    begin = time.process_time()
    found = read_pattern(path)
    assert len(found.faces) == 1
    assert "3998 marks" in " ".join(found.notes)
    assert time.process_time() - begin < SECONDS
