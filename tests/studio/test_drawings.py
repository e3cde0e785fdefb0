"""Crease patterns in the studio: from the files of other programs to designs, or refused."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

from mechanisms import flat_foldable, random_net
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.studio import api
from patterns import (
    CHANGES,
    SAMPLES,
    dxf_of,
    fold_of,
    jittered,
    miura,
    svg_of,
    waterbomb,
)
from patterns import of_mechanism as pattern_of
from samples import thorough
from typescript import fits

ARCH = Path(__file__).parents[2] / "examples" / "arch_pattern.svg"
TEXTS: dict[str, Any] = {
    ".fold": lambda pattern: json.dumps(fold_of(pattern)),
    ".svg": svg_of,
    ".dxf": dxf_of,
}


def dropped(client: httpx.Client, name: str, data: str | bytes, **asked: Any) -> httpx.Response:
    """The answer to a file that is dropped."""
    data = data.encode() if isinstance(data, str) else data
    content = base64.b64encode(data).decode()
    payload = {"name": name, "content": content, "unit": "m", **asked}
    return client.post("/api/pattern", json=payload)


def design_of(table: dict[str, Any], **pattern: Any) -> dict[str, Any]:
    """The design that the page makes of a table."""
    shell = {"family": "pattern", "unit": "m"}
    return {"shell": shell, "target": {"pattern": table}, "pattern": pattern}


def asked(client: httpx.Client, task: str, **payload: Any) -> Any:
    return client.post(f"/api/{task}", json=payload).json()


def refused(answer: httpx.Response) -> dict[str, Any]:
    """The one message of an answer that refuses a file; its status is one of the client's."""
    assert 400 <= answer.status_code < 500
    error: dict[str, Any] = answer.json()["error"]
    assert error["kind"] in {"input", "design"}
    assert error["what"]
    assert "dropped." not in error["message"], "the page's name of the file, not the server's"
    return error


def test_a_pattern_of_another_program_becomes_a_design_that_is_kept(client: httpx.Client) -> None:
    found = dropped(client, ARCH.name, ARCH.read_bytes()).json()
    assert fits(found, api.DroppedTarget)
    assert f"read from {ARCH.name}, in m" in found["note"]
    assert "no unit of length" in found["note"]
    design = design_of(found["table"])
    rows = asked(client, "drawing", design=design)
    assert fits(rows, api.DrawnSheetFacts)
    said = {each["subject"]: each["finding"] for each in rows["rows"]}
    assert said["sheet"].startswith("6 x 7 panels")
    assert "flat-foldable" in said["family"]
    assert client.post("/api/design", json={"design": design}).status_code == 200
    text = asked(client, "format", design=design)["text"]
    assert asked(client, "parse", text=text) == {"design": design}


@pytest.mark.parametrize("ending", TEXTS)
def test_what_a_file_says_is_in_the_table(client: httpx.Client, ending: str) -> None:
    pattern = pattern_of(flat_foldable(random_net(4, 5, 2)))
    table = dropped(client, f"mine{ending}", TEXTS[ending](pattern)).json()["table"]
    flat = np.array(table["vertices"])
    assert flat.shape == (6, 7, 2)
    # An SVG begins at its top left corner, its y downwards.
    moved = flat - flat.min(axis=(0, 1)) + pattern.vertices.min(axis=0)
    apart = np.linalg.norm(moved.reshape(-1, 1, 2) - pattern.vertices, axis=2).min(axis=1)
    assert apart.max() < 1e-12 * np.ptp(pattern.vertices)
    letters = "".join(table["row_creases"] + table["column_creases"])
    assert sorted(letters) == sorted(each for each in pattern.letters.tolist() if each in "MV")
    assert table.get("unit") == (None if ending == ".svg" else "mm")


def test_lines_that_do_not_meet_are_joined_by_what_the_refusal_offers(
    client: httpx.Client,
) -> None:
    # Edges have a length of 1 at least, the diagonal one of 9: ends lie up to 0.08 apart, more
    # than is joined unasked.
    torn = json.loads(json.dumps(fold_of(miura(), faces=False)))
    lines = np.array(torn["vertices_coords"])[np.array(torn["edges_vertices"])]
    lines += np.random.default_rng(1).uniform(-0.03, 0.03, lines.shape)
    strokes = {"B": "#000000", "M": "#ff0000", "V": "#0000ff"}
    drawn = "".join(
        f'<line x1="{a}" y1="{-b}" x2="{c}" y2="{-d}" stroke="{strokes[letter]}"/>'
        for ((a, b), (c, d)), letter in zip(lines.tolist(), torn["edges_assignment"], strict=True)
    )
    text = f'<svg xmlns="http://www.w3.org/2000/svg">{drawn}</svg>'
    answer = dropped(client, "torn.svg", text)
    assert fits(answer.json(), api.Refusal)
    # Both ends of every line that lies apart.
    assert len(answer.json()["drawing"]["marks"]) > 10
    error = refused(answer)
    (remedy,) = error["remedies"]
    assert error["where"].startswith("torn.svg:")
    assert list(remedy["changes"]) == ["weld"]
    found = dropped(client, "torn.svg", text, **remedy["changes"])
    assert np.shape(found.json()["table"]["vertices"]) == (6, 7, 2)
    refused(dropped(client, "torn.svg", text, weld=True))
    refused(dropped(client, "torn.svg", text, weld=-1))


def test_panels_that_make_no_grid_are_refused_by_place(client: httpx.Client) -> None:
    answer = dropped(client, "bomb.fold", json.dumps(fold_of(waterbomb())))
    assert fits(answer.json(), api.Refusal)
    drawing = answer.json()["drawing"]
    assert len(drawing["lines"]) == len(drawing["letters"]) == len(waterbomb().edges)
    assert {each["what"] for each in drawing["marks"]} == {"a panel of 3 vertices"}
    error = refused(answer)
    assert error["where"].startswith("bomb.fold: at (")
    assert "a panel of 3 vertices" in error["got"]


def test_a_sheet_that_does_not_fold_is_shown_with_its_vertices(client: httpx.Client) -> None:
    pattern = miura()
    drawn = dropped(client, "mine.svg", svg_of(pattern)).json()["table"]
    letters = drawn["row_creases"][1]
    drawn["row_creases"][1] = letters[0] + "VM"[letters[1] == "V"] + letters[2:]
    answer = client.post("/api/design", json={"design": design_of(drawn)})
    assert fits(answer.json(), api.Refusal)
    marks = answer.json()["drawing"]["marks"]
    ends = [drawn["vertices"][2][column] for column in (1, 2)]
    assert [[each["x"], each["y"]] for each in marks] == ends


def test_red_blue_and_black_lines_are_a_pattern(client: httpx.Client) -> None:
    def looks(name: str, text: str) -> bool:
        content = base64.b64encode(text.encode()).decode()
        answer = client.post("/api/look", json={"name": name, "content": content, "unit": "m"})
        assert fits(answer.json(), api.DrawingLook)
        return bool(answer.json()["pattern"])

    assert looks("mine.svg", svg_of(miura()))
    assert looks("mine.dxf", dxf_of(miura()))
    # Our own drawings have a cut for a border.
    asked = {"design": parse_toml(starter_file("pattern")), "format": "svg"}
    assert looks("own.svg", client.post("/api/export", json=asked).text)
    assert not looks("mine.svg", svg_of(miura()).replace("#0000ff", "#ff0000"))
    assert not looks(
        "curve.svg", '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L9 9"/></svg>'
    )
    assert not looks("broken.dxf", "0")


def test_names_of_files_do_no_harm(client: httpx.Client) -> None:
    text = svg_of(miura())
    names = ("", "mine", ".svg", "a.svg\0", f"a.{'x' * 3000}", "a.obj\0", "../a.toml", "a.SVG")
    answers = [dropped(client, name, text) for name in names]
    assert [each.status_code for each in answers] == [422] * 7 + [200]
    for task in ("mesh", "curve"):
        payload = {"name": "a.obj\0", "content": "", "unit": "m"}
        refused(client.post(f"/api/{task}", json=payload))
    assert refused(dropped(client, "a.svg", text, content="é"))["what"].endswith("base64")


def damaged(number: int) -> tuple[str, bytes]:
    """A good file with bytes changed, cut out, or put in twice."""
    rng = np.random.default_rng(number)
    ending = list(TEXTS)[number % 3]
    data = TEXTS[ending](miura(3, 4)).encode()
    begin = int(rng.integers(0, len(data)))
    end = begin + int(rng.integers(1, len(data) // 4))
    if number % 4 == 0:
        return ending, data[:begin]
    if number % 4 == 1:
        return ending, data[:begin] + data[end:]
    if number % 4 == 2:
        return ending, data[:end] + data[begin:end] + data[end:]
    array = np.frombuffer(data, np.uint8).copy()
    at = rng.integers(0, len(array), 3 + len(array) // 100)
    array[at] ^= (1 << rng.integers(0, 8, len(at))).astype(np.uint8)
    return ending, array.tobytes()


def test_hostile_files_are_refused_with_one_message(client: httpx.Client) -> None:
    bad = 0
    for number in range(50):
        ending, data = damaged(number)
        answer = dropped(client, f"bad{ending}", data)
        if answer.status_code != 200:
            bad += 1
            refused(answer)
    assert bad > 25, "otherwise the damage tests nothing"


def all_patterns(names: list[str]) -> list[Any]:
    few = {"not folding", "Miura with a hole", "square twist"}
    return [pytest.param(name, marks=() if name in few else thorough) for name in names]


@pytest.mark.parametrize("name", all_patterns(list(SAMPLES)))
def test_every_pattern_in_every_format_is_shown_or_refused(client: httpx.Client, name: str) -> None:
    sample = SAMPLES[name]
    for change in (CHANGES["shuffled"], lambda pattern: jittered(pattern, 1e-6)):
        pattern = change(sample.make())
        for ending, text in TEXTS.items():
            answer = dropped(client, f"mine{ending}", text(pattern))
            if not sample.grid:
                refused(answer)
                continue
            assert answer.status_code == 200
            design = design_of(answer.json()["table"])
            assert fits(asked(client, "drawing", design=design), api.DrawnSheetFacts)
            view = client.post("/api/design", json={"design": design})
            if not sample.folds:
                refused(view)
            last = client.post("/api/verify", json={"design": design}).text.splitlines()[-1]
            answered = json.loads(last)
            assert "result" in answered or answered["error"]["kind"] != "fault"
