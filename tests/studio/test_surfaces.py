"""A surface as the target in the studio: drawn at once, fitted with progress, dropped as a mesh."""

from __future__ import annotations

import base64
import json
from typing import Any

import httpx
import numpy as np
import pytest

from orishell import InputError
from orishell.conventions.memory import Memory, key_of
from orishell.studio import api, surfaces
from samples import thorough
from surface_files import obj
from typescript import fits

DOME: dict[str, Any] = {
    "shell": {"family": "flat-foldable", "unit": "m"},
    "target": {"surface": {"formula": "sqrt(64 - x**2 - y**2)", "x": [-4, 4], "y": [-3, 3]}},
    "pattern": {"rows": 5, "columns": 5, "direction_deg": 0, "fold_deg": 90},
}


def of_surface(**table: Any) -> dict[str, Any]:
    return {**DOME, "target": {"surface": table}}


def numbers(text: str, kind: str = "<f4") -> Any:
    return np.frombuffer(base64.b64decode(text), kind)


def asked(client: httpx.Client, task: str, **payload: Any) -> Any:
    return client.post(f"/api/{task}", json=payload).json()


def test_a_surface_is_drawn_before_any_shell_is_fitted(client: httpx.Client) -> None:
    drawn = asked(client, "surface", design=DOME)
    assert fits(drawn, api.DrawnSurface)
    points = numbers(drawn["points"]).reshape(*drawn["lattice"], 3)
    x, y, z = np.moveaxis(points, -1, 0)
    assert np.allclose(z, np.sqrt(64 - x**2 - y**2), atol=1e-5)  # single precision
    rim = numbers(drawn["rim"]).reshape(-1, 3)
    assert rim.min(axis=0)[:2] == pytest.approx([-4, -3])
    assert drawn["patch"] == {"centre": [0, 0], "size": [8, 6], "turn_deg": 0}


def test_a_fit_tells_how_far_it_is_and_the_proof_does_not_fit_again(client: httpx.Client) -> None:
    design = {**DOME, "pattern": {**DOME["pattern"], "rows": 9, "columns": 9}}
    lines = client.post("/api/fit", json={"design": design}).text.splitlines()
    *said, last = map(json.loads, lines)
    assert fits(last, api.FitResult)
    coarse = [each for each in said if "found" in each]
    assert len(coarse) == 1
    assert fits(coarse[0], api.FitFound)
    shares = [each["progress"] for each in said if "progress" in each]
    assert shares == sorted(shares)
    assert len(shares) > 5
    lines = client.post("/api/verify", json={"design": design}).text.splitlines()
    *said, last = map(json.loads, lines)
    assert not [each for each in said if "fitting" in each.get("what", "")]
    assert fits(last, api.Result)
    deviation = last["result"]["report"]["deviation"]
    assert 0 < max(deviation[name]["max"] for name in ("crests", "valleys")) < 0.1
    assert asked(client, "ranges", design=design) == {"ranges": {}}


def test_saved_and_opened_it_is_the_same(client: httpx.Client) -> None:
    text = asked(client, "format", design=DOME)["text"]
    assert asked(client, "parse", text=text) == {"design": DOME}


def test_what_is_wrong_with_a_surface_names_its_key(client: httpx.Client) -> None:
    for table, key in (
        ({"formula": "sqrt(1 - x**2)", "x": [-2, 2], "y": [0, 1]}, "target.surface.formula"),
        ({"formula": "x*y", "x": [1, 0], "y": [0, 1]}, "target.surface.x"),
        ({"mesh": "roof.obj"}, "target.surface.mesh"),
    ):
        error = asked(client, "surface", design=of_surface(**table))["error"]
        assert error["kind"] == "input"
        assert key in error["keys"]


def dropped(client: httpx.Client, text: str, unit: str = "m") -> Any:
    content = base64.b64encode(text.encode()).decode()
    return asked(client, "mesh", name="roof.obj", content=content, unit=unit)


def test_a_dropped_mesh_becomes_part_of_the_design(client: httpx.Client) -> None:
    found = dropped(client, obj())
    assert fits(found, api.DroppedTarget)
    assert "128 triangles of roof.obj" in found["note"]
    assert len(found["table"]["vertices"]) == 81
    design = of_surface(**found["table"])
    drawn = asked(client, "surface", design=design)
    assert drawn["patch"] is None
    assert drawn["factor"] == [1, 1, 1]
    points = numbers(drawn["points"]).reshape(-1, 3)
    x, y, z = points.T
    # With normals at its vertices a mesh is smooth, and as near the saddle as its rim allows.
    assert abs(z - 0.25 * (x * x - y * y)).max() < 0.005
    text = asked(client, "format", design=design)["text"]
    assert asked(client, "parse", text=text) == {"design": design}
    lines = client.post("/api/fit", json={"design": design}).text.splitlines()
    assert "result" in json.loads(lines[-1])


def test_corners_of_a_mesh_are_in_the_unit_of_its_file(client: httpx.Client) -> None:
    found = dropped(client, obj())["table"]
    corners = [[0, 1, -0.25], [1, 0, 0.25], [0, -1, -0.25], [-1, 0, 0.25]]
    drawn = asked(client, "surface", design=of_surface(**found, unit="cm", corners=corners))
    assert drawn["factor"] == pytest.approx((0.01, 0.01, 0.01))
    rim = numbers(drawn["rim"]).reshape(-1, 3)
    places = rim[drawn["corners"]] / drawn["factor"]
    # Each of them, in another order: the top comes first.
    apart = np.linalg.norm(places[:, None] - np.array(corners), axis=2)
    assert apart.min(axis=0).max() < 1e-5


def test_a_rectangle_may_be_turned(client: httpx.Client) -> None:
    table = {"formula": "x*y/8", "centre": [1, 2], "size": [4, 2], "turn_deg": 30}
    drawn = asked(client, "surface", design=of_surface(**table))
    assert drawn["patch"]["turn_deg"] == pytest.approx(30)
    corners = numbers(drawn["rim"]).reshape(-1, 3)[drawn["corners"], :2]
    assert corners.mean(axis=0) == pytest.approx([1, 2])
    sides = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    assert sides == pytest.approx([4, 2, 4], abs=1e-5)


def test_a_mesh_that_is_no_open_piece_is_refused(client: httpx.Client) -> None:
    error = dropped(client, obj(holes=1))["error"]
    assert error["kind"] == "input"
    assert "hole" in error["what"]
    assert dropped(client, "nothing")["error"]["kind"] == "input"


def test_a_mesh_that_is_too_large_is_refused_with_the_limit(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(surfaces, "MOST_TRIANGLES", 100)
    content = base64.b64encode(obj().encode()).decode()
    with pytest.raises(InputError, match="too many triangles") as error:
        surfaces.read_dropped_mesh("roof.obj", content, "m")
    assert error.value.got == "128 triangles"
    assert error.value.expected == "at most 100"


@pytest.mark.slow
@thorough
def test_a_survey_of_200_000_triangles_becomes_part_of_a_design(client: httpx.Client) -> None:
    count = 316
    x, y = np.meshgrid(*[np.linspace(-1, 1, count + 1)] * 2, indexing="ij")
    place = np.stack([x, y, 0.25 * (x * x + y * y)], axis=-1).reshape(-1, 3)
    number = np.arange((count + 1) ** 2).reshape(count + 1, count + 1) + 1
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    faces = np.stack([a, b, c, d], axis=-1).reshape(-1, 4)
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in place.tolist()]
    lines += [f"f {' '.join(map(str, each))}" for each in faces.tolist()]
    found = dropped(client, "\n".join(lines))
    assert len(found["table"]["triangles"]) == 2 * count**2
    drawn = asked(client, "surface", design=of_surface(**found["table"]))
    assert fits(drawn, api.DrawnSurface)


def test_findings_are_kept_as_long_as_there_is_room() -> None:
    memory = Memory(most=2)
    made: list[str] = []

    def make(name: str) -> str:
        made.append(name)
        return name.upper()

    def find(name: str) -> str:
        return memory.recall(name, lambda: make(name))

    assert [find(name) for name in "abab"] == ["A", "B", "A", "B"]
    assert made == ["a", "b"]
    find("c")
    assert list(memory.all()) == ["b", "c"]
    arrays = np.zeros(3), np.array([0.0, 0.0, 5e-324])
    assert len({key_of("x", arrays=[each]) for each in arrays}) == 2
    assert key_of("x", 1, arrays=[arrays[0]]) == key_of("x", 1, arrays=[arrays[0].copy()])
