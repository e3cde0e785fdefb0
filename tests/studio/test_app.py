"""The studio's answers over HTTP, as its pages get them."""

from __future__ import annotations

import asyncio
import base64
import io
import json
import socket
import struct
import tempfile
import time
import tomllib
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

from apart import run_apart
from command_line import orishell
from orishell.design_file import starter_file
from orishell.families.registry import FAMILIES
from orishell.studio.app import LIMITS
from orishell.studio.guard import Guard, Key
from orishell.studio.kept import Kept
from samples import led_by, thorough
from studio_server import Studio, descendants, running_studio

Design = dict[str, Any]
EXAMPLES = Path(__file__).parents[2] / "examples"


def starter(family: str = "parallel-repeating") -> Design:
    return tomllib.loads(starter_file(family))


def header(view: bytes) -> dict[str, Any]:
    (length,) = struct.unpack("<I", view[:4])
    content: dict[str, Any] = json.loads(view[4 : 4 + length])
    return content


def array(view: bytes, name: str) -> Any:
    place = header(view)["arrays"][name]
    (length,) = struct.unpack("<I", view[:4])
    count = int(np.prod(place["shape"]))
    begin = 4 + length + place["offset"]
    return np.frombuffer(view, place["type"], count, begin).reshape(place["shape"])


def test_info(client: httpx.Client) -> None:
    info = client.get("/api/info").json()
    assert set(info["families"]) == {*FAMILIES, "auto"}
    assert info["start"] is None
    for family in info["families"].values():
        keys = [each["key"] for each in family["parameters"]]
        # A drawn sheet has its rows and columns.
        assert keys[:2] == ["rows", "columns"] or family["aims"] == ["drawing"]
        assert len(set(keys)) == len(keys)
    for example in info["examples"]:
        assert client.post("/api/parse", json={"text": example["text"]}).status_code == 200


@pytest.mark.parametrize("family", FAMILIES)
def test_design_is_a_view_of_the_states(client: httpx.Client, family: str) -> None:
    answer = client.post("/api/design", json={"design": starter(family), "states": 9})
    assert answer.status_code == 200
    head = header(answer.content)
    rows, columns = head["grid"]
    assert len(head["drives_deg"]) == 9
    positions, flat = array(answer.content, "positions"), array(answer.content, "flat")
    assert positions.shape == (9, len(flat), 3)
    # Strips have vertices of their own where they are joined.
    assert len(flat) == rows * columns + (rows * (columns - 2) if FAMILIES[family].in_strips else 0)
    assert array(answer.content, "faces").shape == ((rows - 1) * (columns - 1), 4)
    # The first state is the flat sheet: the distances in it are those of the crease pattern.
    edges = array(answer.content, "edges")
    for state in positions:
        length = np.linalg.norm(state[edges[:, 1]] - state[edges[:, 0]], axis=1)
        size = float(np.linalg.norm(np.ptp(flat, axis=0)))
        expected = np.linalg.norm(flat[edges[:, 1]] - flat[edges[:, 0]], axis=1)
        np.testing.assert_allclose(length, expected, atol=1e-6 * size)
    for curve in head["curves"].values():
        # A family that follows surfaces begins with a sheet without a target, others with f and g
        # or a drawing.
        assert len(curve) > 50 if "f" in starter(family).get("target", {}) else not curve


def test_verify_reports_progress_and_the_whole_report(client: httpx.Client) -> None:
    design = starter()
    design["pattern"]["xi_deg"] = 39.5  # an answer that another test got is kept: no progress
    with client.stream("POST", "/api/verify", json={"design": design}) as answer:
        lines = [json.loads(line) for line in answer.iter_lines()]
    advances = [line for line in lines[:-1] if "progress" in line]
    assert all(set(line) == {"progress", "what"} for line in advances)
    # What mends its notes is tried when somebody asks.
    mendable = lines[-1]["result"]["mendable"]
    asked = [(each["about"], each["slow"]) for each in mendable]
    assert ("board", False) in asked
    # A third as large, so that its panels fit boards that are sold.
    curves = {name: {**each, "scale": 0.3} for name, each in design["target"].items()}
    small = {**design, "target": curves, "pattern": {**design["pattern"], "flap": 0.09}}
    body = {"design": small, "about": "board"}
    *_, last = client.post("/api/mend", json=body).text.splitlines()
    (changes,) = (json.loads(last)["result"]["mend"]["changes"],)
    assert [*changes] == ["workshop.stock"]
    refused = client.post("/api/mend", json={**body, "about": "weather"}).text.splitlines()[-1]
    assert "no note is about that" in json.loads(refused)["error"]["message"]
    assert len(lines) > 2
    result = lines[-1]["result"]
    assert result["report"]["lock"]["cause"] == "flaps"
    assert result["refusal"] is None
    distance = np.frombuffer(base64.b64decode(result["distance"]), "<f4")
    inner = np.abs(distance[~np.isnan(distance)])
    assert 0 < inner.max() <= result["report"]["deviation"]["surface"]["max"] * (1 + 1e-6)


def test_what_was_answered_is_kept(client: httpx.Client) -> None:
    designs = [starter(), starter()]
    designs[1]["pattern"]["xi_deg"] = 39.25
    first, other, again = (
        client.post("/api/verify", json={"design": each}).text.splitlines()
        for each in (*designs, designs[0])
    )
    assert again == first[-1:]
    assert other[-1] != again[0]
    views = [
        client.post("/api/design", json={"design": each}).content for each in (*designs, designs[0])
    ]
    assert views[0] == views[2] != views[1]


def test_the_oldest_answers_make_room() -> None:
    kept = Kept(most=100)
    for body in (b"1", b"2", b"3"):
        kept.keep("verify", body, 40 * body)
    kept.keep("verify", b"3", b"once more")
    assert [kept.find("verify", body) for body in (b"1", b"2", b"3")] == [
        None,
        40 * b"2",
        b"once more",
    ]
    assert kept.find("design", b"3") is None
    kept.keep("design", b"3", bytes(101))  # larger than all there is room for
    assert kept.find("design", b"3") is None


def test_a_clash_is_named_and_shown(client: httpx.Client) -> None:
    design = starter()  # a closed ring, whose ends meet (tests/planted.py)
    design["target"] = {
        "f": {"formula": "-0.3*x**2", "range": [-1, 1]},
        "g": {"formula": ["4*cos(t)", "4*sin(t)"], "range": [0, 2 * np.pi]},
    }
    design["pattern"] |= {"rows": 3, "columns": 30, "xi_deg": 90}
    lines = client.post("/api/verify", json={"design": design}).text.splitlines()
    result = json.loads(lines[-1])["result"]
    assert "meet before" in result["refusal"]["what"]
    assert len(result["contact"]["panels"]) == 2


def test_ranges_hold_what_works_and_say_why_not_beyond(client: httpx.Client) -> None:
    design = starter()
    ranges = client.post("/api/ranges", json={"design": design}).json()["ranges"]
    ((low, high),) = ranges["xi_deg"]["intervals"]
    # geometry.md: xi below 180 degrees less the spread of f's tangents, 2 atan 2.
    assert high == pytest.approx(180 - 2 * np.rad2deg(np.arctan(2)), abs=0.3)
    assert 0 < low < 1  # its slider begins at 1
    assert ranges["xi_deg"]["beyond"] == [False, False]
    assert "too large" in ranges["xi_deg"]["above"]
    for degrees, status in ((high - 0.5, 200), (high + 0.5, 422)):
        design["pattern"]["xi_deg"] = degrees
        assert client.post("/api/design", json={"design": design}).status_code == status
    # Of what may be as large as one likes, no end is named.
    assert ranges["flap"]["beyond"] == [False, True]
    design["pattern"] |= {"xi_deg": high - 0.5, "flap": 4 * ranges["flap"]["intervals"][0][1]}
    assert client.post("/api/design", json={"design": design}).status_code == 200


def test_text_and_tables(client: httpx.Client) -> None:
    design = starter("orthodiagonal")
    text = client.post("/api/format", json={"design": design}).json()["text"]
    assert tomllib.loads(text) == design
    assert client.post("/api/parse", json={"text": text}).json()["design"] == design
    wrong = client.post("/api/parse", json={"text": "[shell"})
    assert wrong.status_code == 422
    assert "not TOML" in wrong.json()["error"]["message"]
    for number in ("0x" + "f" * 9000, "9" * 9000):
        wrong = client.post("/api/parse", json={"text": f"[pattern]\nrows = {number}"})
        assert wrong.status_code == 422
        assert "too large" in wrong.json()["error"]["message"]


def test_parts_of_curves_are_kept_as_they_are_typed(client: httpx.Client) -> None:
    """A range of constants and the part of a drawing go through text and back, and are drawn."""
    design = starter("orthodiagonal")
    points = [[x / 10, -((x / 10) ** 2)] for x in range(-15, 16)]
    design["target"]["f"] = {"points": points, "part": [0.7, "pi"]}
    design["target"]["g"]["range"] = [0, "5*pi/4"]
    text = client.post("/api/format", json={"design": design}).json()["text"]
    assert tomllib.loads(text) == design
    assert client.post("/api/parse", json={"text": text}).json()["design"] == design
    design["target"]["g"]["range"] = [0, "x"]
    error = client.post("/api/design", json={"design": design}).json()["error"]
    assert "[target.g] range" in error["where"]


def test_refusals_are_said_field_by_field_with_the_curves(client: httpx.Client) -> None:
    design = starter()
    design["pattern"]["xi_deg"] = 170
    answer = client.post("/api/design", json={"design": design})
    assert answer.status_code == 422
    error = answer.json()["error"]
    assert error["kind"] == "design"
    assert "too large" in error["what"]
    assert "must stay below" in error["size"]
    assert len(answer.json()["curves"]["f"]) > 50
    # What works is found by trying it, which takes longer than a page waits for a design.
    assert error["remedies"] == []
    lines = client.post("/api/verify", json={"design": design}).text.splitlines()
    first, *_ = json.loads(lines[-1])["error"]["remedies"]
    assert first["text"] == f"xi_deg = {first['changes']['pattern.xi_deg']}"
    design["pattern"].update(xi_deg=first["changes"]["pattern.xi_deg"])
    assert client.post("/api/design", json={"design": design}).status_code == 200
    design["pattern"]["rows"] = 8
    error = client.post("/api/design", json={"design": design}).json()["error"]
    assert error["kind"] == "input"
    assert "[pattern] rows" in error["where"]


@pytest.mark.parametrize("task", ["design", "ranges", "format"])
def test_a_design_without_a_target_is_refused(client: httpx.Client, task: str) -> None:
    design = starter("longitudinal-linear-repeating")
    del design["target"]
    answer = client.post(f"/api/{task}", json={"design": design})
    assert answer.status_code == 422
    error = answer.json()["error"]
    assert error["message"].startswith("[target]: there is no target. Remedy: add [target.f] and")


@pytest.mark.parametrize("key", ["points", "svg", "dxf"])
def test_no_path_of_a_request_is_opened(client: httpx.Client, key: str) -> None:
    design = starter()
    design["target"]["f"] = {key: "/etc/passwd"}
    answer = client.post("/api/design", json={"design": design})
    assert answer.status_code == 422
    assert "files are not opened" in answer.json()["error"]["message"]
    palette = {**starter(), "workshop": {"palette": "/etc/passwd.toml"}}
    answer = client.post("/api/design", json={"design": palette})
    assert "files are not opened" in answer.json()["error"]["message"]


def test_dropped_files(client: httpx.Client) -> None:
    def drop(name: str, content: bytes) -> httpx.Response:
        text = base64.b64encode(content).decode()
        return client.post("/api/curve", json={"name": name, "content": text, "unit": "m"})

    spline = drop("p.csv", b"x [mm], y [mm]\n0,0\n500,200\n1000,0\n").json()
    assert spline["table"] == {"points": [[0, 0], [0.5, 0.2], [1.0, 0]], "smooth": True}
    page = b'width="100mm" height="100mm" viewBox="0 0 100 100"'
    svg = b'<svg xmlns="http://www.w3.org/2000/svg" ' + page + b">%s</svg>"
    corner = drop("p.svg", svg % b'<path d="M0 50 L50 0 L100 50"/>').json()
    assert corner["table"] == {"path": "M0 -0.05 L0.05 0 L0.1 -0.05"}
    arc = drop("p.svg", svg % b'<path d="M0 50 A50 50 0 0 1 100 50"/>').json()
    assert arc["table"] == {"path": "M0 -0.05 A0.05 0.05 0 0 0 0.1 -0.05"}
    assert arc["note"] == "1 piece of a path along p.svg, exactly"
    # Where loose ends make one curve of all they are joined, and it is said.
    for gap, said in ((0.1, "0.1"), (1.5, "1.5")):
        torn = drop("p.svg", svg % f'<path d="M0 50L50 0M{50 + gap} 0L100 50"/>'.encode()).json()
        assert torn["note"] == (
            f"2 pieces of a path along p.svg, exactly; ends up to {said} mm apart were joined"
        )
    t = np.linspace(-1, 1, 200)
    measured = [f"{x},{y}" for x, y in zip(t, np.cos(t), strict=True)]
    few = drop("p.csv", "\n".join(measured).encode()).json()
    assert len(few["table"]["points"]) < 9
    assert "none of these is farther from it than" in few["note"]
    bent = "\n".join(f"{x},{abs(x)}" for x in t).encode()
    assert not drop("p.csv", bent).json()["table"]["smooth"]
    # So many lines of a drawing are a curve that was measured, too.
    lines = " L".join(f"{50 * x + 50:.5f} {50 * np.cos(x):.5f}" for x in t).encode()
    few = drop("p.svg", svg % (b'<path d="M' + lines + b'"/>')).json()
    assert len(few["table"]["points"]) < 9
    for name, content in (
        ("p.exe", b""),
        ("p.svg", b"<svg"),
        ("p.svg", svg % b'<path d="M0 0L1 1"/><path d="M5 5L6 6"/>'),
        ("p.dxf", b"  0\nSECTION\n  2\n\x1b[2J\n  0\nLINE\n 10\n\x1b[2J\n"),
        ("p.csv", b"1,2\n"),
    ):
        answer = drop(name, content)
        assert answer.status_code == 422
        assert name in answer.json()["error"]["message"]
        assert tempfile.gettempdir() not in answer.text
        assert answer.json()["error"]["message"].isprintable()


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command line writes."""
    place = tmp_path_factory.mktemp("mine")
    (place / "mine.toml").write_text(starter_file("orthodiagonal"))
    command = ("design", "mine.toml", "--out", "out", "--write", "dxf,glb,csv")
    assert orishell(*command, cwd=place).returncode == 0
    return place / "out"


@pytest.mark.parametrize("name", ["dxf", "glb", "csv"])
def test_export_is_what_the_command_line_writes(
    client: httpx.Client, name: str, written: Path
) -> None:
    design = starter("orthodiagonal")
    answer = client.post("/api/export", json={"design": design, "format": name, "name": "mine"})
    assert answer.status_code == 200
    called = answer.headers["content-disposition"].split('"')[1]
    assert called == {"csv": "mine-csv.zip"}.get(name, f"mine.{name}")
    if called.endswith(".zip"):
        with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
            found = {each: archive.read(each) for each in archive.namelist()}
    else:
        found = {{"dxf": "pattern.dxf", "glb": "shell.glb"}[name]: answer.content}
    for each, content in found.items():
        assert content == (written / each).read_bytes()
    assert len(found) == (5 if name == "csv" else 1)  # panels, creases, schedule, order, ground


@pytest.mark.parametrize("name", led_by(["dwg", "all", "", None], 2))
def test_an_export_is_of_one_format(client: httpx.Client, name: str | None) -> None:
    answer = client.post("/api/export", json={"design": starter(), "format": name})
    assert answer.status_code == 422
    assert "format" in answer.json()["error"]["message"]


@pytest.mark.parametrize(
    ("headers", "status"),
    [
        ({"host": "evil.example"}, 403),
        ({"origin": "http://evil.example"}, 403),
        ({"origin": "null"}, 403),
        ({"origin": "http://[::1"}, 403),
        ({"origin": "http://[v1.x]y"}, 403),
        ({"content-type": "text/plain"}, 415),
        ({"content-type": "application/json"}, 400),
    ],
)
def test_who_may_ask(client: httpx.Client, headers: dict[str, str], status: int) -> None:
    answer = client.post("/api/design", content=b"x", headers=headers)
    if "content-type" not in headers:
        answer = client.post("/api/design", json={}, headers=headers)
    assert answer.status_code == status
    assert answer.json()["error"]["message"]


def test_sizes_are_limited(client: httpx.Client) -> None:
    design = starter()
    design["pattern"] |= {"rows": 999, "columns": 999}
    answer = client.post("/api/design", json={"design": design})
    assert answer.status_code == 422
    assert "too large for the studio" in answer.json()["error"]["message"]
    body = b'{"design": "' + b"x" * LIMITS.bytes + b'"}'
    headers = {"content-type": "application/json"}
    assert client.post("/api/design", content=body, headers=headers).status_code == 413

    def pieces() -> Iterator[bytes]:
        yield from (body[k : k + 1_000_000] for k in range(0, len(body), 1_000_000))

    assert client.post("/api/design", content=pieces(), headers=headers).status_code == 413


def test_millions_of_values_are_not_read(client: httpx.Client) -> None:
    """Python would hold up everybody for a second while it made 1.5 million lists."""
    body = b'{"design": {"shell": [' + b"[]," * 1_490_000 + b"[]]}}"
    assert 4_400_000 < len(body) < LIMITS.bytes
    for task in ("design", "verify", "parse"):
        answer = client.post(
            f"/api/{task}", content=body, headers={"content-type": "application/json"}
        )
        assert answer.status_code == 413
        assert "values" in answer.json()["error"]["message"]


@pytest.mark.parametrize(
    "body", [b"[]", b"{}", b'{"design": 3}', b'{"design": {"shell": []}}', b"[" * 100_000]
)
def test_malformed_requests_are_answered(client: httpx.Client, body: bytes) -> None:
    for task in ("design", "verify", "ranges", "parse", "format", "curve", "export"):
        answer = client.post(
            f"/api/{task}", content=body, headers={"content-type": "application/json"}
        )
        if task == "verify" and answer.status_code == 200:  # its errors come in the stream
            assert "error" in json.loads(answer.text.splitlines()[-1])
        else:
            assert 400 <= answer.status_code < 500
            assert answer.json()["error"]["message"]


@pytest.mark.parametrize("file", ["profile.svg", "profile.dxf"])
def test_of_a_drawing_with_an_axis_the_longest_part_is_the_curve(
    client: httpx.Client, file: str
) -> None:
    content = base64.b64encode((EXAMPLES / file).read_bytes()).decode()
    answer = client.post("/api/curve", json={"name": file, "content": content, "unit": "m"})
    found = answer.json()
    assert "the longest" in found["note"]
    # The arch of the examples is 2 x 819.615 mm wide; the axis beside it is 0.4 m long.
    words = found["table"]["path"].removeprefix("M").split()
    np.testing.assert_allclose(
        [float(words[0]), float(words[-2])], [-0.819615, 0.819615], atol=1e-6
    )
    assert found["table"]["path"].count("A") == 3


DEEP = b'{"design": ' + b'{"a":' * 100 + b"1" + b"}" * 101


@pytest.mark.parametrize(
    "body",
    [
        b'{"design": NaN}',
        b'{"design": {"a": Infinity}}',
        b'{"design": {"a": 1e999}}',
        b'{"design": {"\\ud800": 1}}',
        b"\xff\xfe{}",
        DEEP,
    ],
)
def test_what_is_no_sound_json_is_refused_at_the_door(client: httpx.Client, body: bytes) -> None:
    for task in ("design", "verify", "export"):
        answer = client.post(
            f"/api/{task}", content=body, headers={"content-type": "application/json"}
        )
        assert answer.status_code == 400
        assert answer.json()["error"]["message"]


@pytest.mark.parametrize("states", [None, "x", [1], {"a": 1}, 1e300, True, 0.5])
def test_states_are_counted_in_whole_numbers(client: httpx.Client, states: Any) -> None:
    answer = client.post("/api/design", json={"design": starter(), "states": states})
    assert answer.status_code == 422
    assert "whole number" in answer.json()["error"]["message"]


@pytest.mark.parametrize(("states", "made"), [(-5, 3), (10**9, 50)])
def test_states_are_few(client: httpx.Client, states: int, made: int) -> None:
    answer = client.post("/api/design", json={"design": starter(), "states": states})
    assert len(header(answer.content)["drives_deg"]) == made


@pytest.mark.parametrize(
    ("key", "value"),
    [("xi_deg", 1e308), ("xi_deg", -5), ("flap", 1e-308), ("rows", 10**15), ("rows", True)],
)
def test_numbers_beyond_measure_are_refused(client: httpx.Client, key: str, value: Any) -> None:
    design = starter()
    design["pattern"][key] = value
    assert client.post("/api/design", json={"design": design}).status_code == 422


@pytest.mark.parametrize(
    ("name", "called"),
    [
        ("../../etc/passwd", 'filename="etc passwd.stl"'),
        ("a/b", 'filename="a b.stl"'),
        ("x\r\nSet-Cookie: a=b", 'filename="x Set-Cookie a b.stl"'),
        ("\0", 'filename="shell.stl"'),
        ("..", 'filename="shell.stl"'),
        ("", 'filename="shell.stl"'),
        ("Zelt \u00fcber 3 \u00d7 6", "filename*=utf-8''Zelt%20%C3%BCber%203%206.stl"),
        ("\u5929\u5e55", "filename*=utf-8''%E5%A4%A9%E5%B9%95.stl"),
    ],
)
def test_a_files_name_is_the_designs_and_leads_nowhere(
    client: httpx.Client, name: str, called: str
) -> None:
    request = {"design": starter("orthodiagonal"), "format": "stl", "name": name}
    answer = client.post("/api/export", json=request)
    assert answer.status_code == 200
    assert answer.headers["content-disposition"] == f"attachment; {called}"
    assert "set-cookie" not in answer.headers


@thorough
def test_hundreds_of_thousands_of_points(client: httpx.Client) -> None:
    design = starter()
    design["target"]["f"] = {"points": [[k, k * k % 7] for k in range(600_000)], "smooth": True}
    answer = client.post("/api/design", json={"design": design})
    assert answer.status_code == 413
    design["target"]["f"]["points"] = design["target"]["f"]["points"][:90_000]
    answer = client.post("/api/design", json={"design": design})
    assert answer.status_code == 422
    assert answer.json()["error"]["message"]


def test_pages_that_are_not_there_and_methods(client: httpx.Client) -> None:
    for method, path, status in (
        ("GET", "/api/nothing", 404),
        ("PUT", "/api/design", 405),
        ("GET", "/%2e%2e/app.py", 404),
        ("GET", "/assets/..%2f..%2fapp.py", 404),
    ):
        answer = client.request(method, path)
        assert answer.status_code == status
        assert answer.json()["error"]["message"]


def test_a_slow_body_is_in_nobodys_way_and_ends() -> None:
    """A body of a byte a tenth of a second is given up; in the meantime others are answered."""

    async def scene() -> list[int]:
        statuses: list[int] = []

        async def app(scope: Any, receive: Any, send: Any) -> None:
            await send({"type": "http.response.start", "status": 200, "headers": []})

        async def send(message: Any) -> None:
            if message["type"] == "http.response.start":
                statuses.append(message["status"])

        async def drip() -> dict[str, Any]:
            await asyncio.sleep(0.1)
            return {"type": "http.request", "body": b"x", "more_body": True}

        async def whole() -> dict[str, Any]:
            return {"type": "http.request", "body": b"{}"}

        key = Key(8765)
        guard = Guard(app, key, None, 1000, 1.0)
        scope = {
            "type": "http",
            "method": "POST",
            "path": "/api/design",
            "query_string": key.query.encode(),
            "headers": [(b"host", b"h"), (b"content-type", b"application/json")],
        }
        slow = asyncio.create_task(guard(scope, drip, send))
        await asyncio.sleep(0.2)
        await guard(scope, whole, send)
        await slow
        return statuses

    assert run_apart(scene()) == [200, 408]


@pytest.mark.parametrize("task", led_by(["verify", "ranges"]))
def test_what_is_given_up_leaves_no_process(client_of_its_own: Studio, task: str) -> None:
    design = starter()
    design["pattern"] |= {"rows": 99, "columns": 99}
    address, cookies = client_of_its_own.address, client_of_its_own.cookies
    (cookie,) = cookies.items()
    host, port = address.removeprefix("http://").split(":")
    body = json.dumps({"design": design}).encode()
    request = (
        b"POST /api/%b HTTP/1.1\r\nHost: %b\r\nContent-Type: application/json\r\n"
        b"Cookie: %b\r\nContent-Length: %d\r\n\r\n%b"
        % (task.encode(), address[7:].encode(), "=".join(cookie).encode(), len(body), body)
    )
    for _ in range(5):
        calls = [socket.create_connection((host, int(port))) for _ in range(10)]
        for call in calls:
            call.sendall(request)
        time.sleep(0.2)  # some are under way, others wait in the line
        for call in calls:
            call.close()
    with httpx.Client(base_url=address, cookies=cookies, timeout=100) as session:
        text = session.post("/api/verify", json={"design": starter()}).text
        assert "result" in json.loads(text.splitlines()[-1])
    # Both of a kind at most, the one that they are copies of, and Python's that tracks resources.
    assert 3 <= len(descendants(client_of_its_own.process)) <= 6


@pytest.fixture
def client_of_its_own() -> Iterator[Studio]:
    with running_studio() as studio:
        yield studio


def test_formulas_are_parsed_never_evaluated(client: httpx.Client) -> None:
    for formula in ("__import__('os').system('true')", "9**9**9**9", "x.__class__", "(" * 9000):
        design = starter()
        design["target"]["f"]["formula"] = formula
        answer = client.post("/api/design", json={"design": design})
        assert answer.status_code == 422
