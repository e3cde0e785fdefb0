"""Pages know what the server sends: their types are written from its own, which it keeps."""

from __future__ import annotations

import json
import os
import struct
import tomllib
from pathlib import Path
from typing import Any

import httpx
import pytest

from orishell.design_file import starter_file
from orishell.families.registry import FAMILIES
from orishell.io.view import Header
from orishell.search.page import FrontPage
from orishell.search.variants import VariantsPage
from orishell.studio import api, info
from orishell.studio.refusals import make_refusal
from samples import led_by
from typescript import declarations, fits

SHARED = Path(__file__).parents[2] / "frontend" / "src" / "shared"
TYPES = SHARED / "api-types.ts"
HEAD = """\
// What the server sends and pages have in them, from orishell.studio.api and orishell.studio.info,
// orishell.io.view, orishell.search.page and orishell.search.variants. Do not edit:
// ORISHELL_WRITE_GOLDEN=1 python -m pytest tests/studio/test_api.py writes it anew.

"""
MESSAGES: tuple[Any, ...] = (
    Header,
    FrontPage,
    VariantsPage,
    info.Info,
    api.Ranges,
    api.Parsed,
    api.Written,
    api.DroppedCurve,
    api.DrawnSurface,
    api.DroppedTarget,
    api.DrawnSheetFacts,
    api.DrawingLook,
    api.FamiliesFound,
    api.FamiliesResult,
    api.VerifiedSoFar,
    api.FitFound,
    api.FitResult,
    api.Advance,
    api.MendResult,
    api.Result,
    api.TradeoffResult,
    api.SheetsResult,
    api.BookletResult,
    api.SearchFound,
    api.SearchAnswer,
    api.CarryFound,
    api.CarryResult,
    api.Refusal,
)


def test_pages_have_the_servers_types() -> None:
    text = HEAD + declarations(*MESSAGES)
    if os.environ.get("ORISHELL_WRITE_GOLDEN"):
        TYPES.write_text(text)
    assert TYPES.read_text() == text


def test_what_the_page_asks_for_first(client: httpx.Client) -> None:
    assert fits(client.get("/api/info").json(), info.Info)


THICK = "[panel]\nthickness = 0.02\nmembrane = 0.001\n"
CLIPPED = '[deployment]\nflap_attachment = "clipped"\n'


@pytest.mark.parametrize(
    ("family", "more"),
    led_by(
        [("parallel-repeating", CLIPPED + THICK), ("orthodiagonal", "")]
        + [(each, "") for each in FAMILIES if each != "orthodiagonal"]
        + [("parallel-repeating", THICK)],
        2,
    ),
)
def test_answers_about_a_design(client: httpx.Client, family: str, more: str) -> None:
    text = f"{starter_file(family)}\n{more}"
    design = tomllib.loads(text)
    assert fits(client.post("/api/parse", json={"text": text}).json(), api.Parsed)
    if more:
        design["pattern"] |= {"rows": 5, "columns": 5}
    assert fits(client.post("/api/format", json={"design": design}).json(), api.Written)
    assert fits(client.post("/api/ranges", json={"design": design}).json(), api.Ranges)
    lines = client.post("/api/verify", json={"design": design}).text
    *said, result = map(json.loads, lines.splitlines())
    # What is known before loads are looked at is told where there are any.
    assert all(fits(each, api.Advance) for each in said)
    assert fits(result, api.Result)
    pattern = design["pattern"]
    sized = "columns" in pattern
    values = (
        {"pattern.columns": [pattern["columns"], 3]} if sized else {"pattern.fold_deg": [90, 60]}
    )
    search = {
        "variables": values,
        "minimise": ["panels"],
        "subject_to": {"cut_length": {"least": 0}},
    }
    lines = client.post("/api/search", json={"design": {**design, "search": search}}).text
    *said, result = map(json.loads, lines.splitlines())
    assert all(fits(each, api.Advance if "progress" in each else api.SearchFound) for each in said)
    assert fits(result, api.SearchAnswer)
    assert result["result"]["made"] == 2
    view = client.post("/api/design", json={"design": design}).content
    header = json.loads(view[4 : 4 + struct.unpack("<I", view[:4])[0]])
    assert fits(header, Header)
    assert set(header["curves"]) == {"f", "g"}


def test_a_dropped_curve(client: httpx.Client) -> None:
    request = {"name": "p.csv", "content": "MCwwCjEsMQo=", "unit": "m"}
    assert fits(client.post("/api/curve", json=request).json(), api.DroppedCurve)


@pytest.mark.parametrize(
    ("path", "body", "keys"),
    [
        ("design", {"design": {"pattern": {"xi_deg": 170}}}, ["pattern.xi_deg"]),
        ("design", {"design": {"pattern": {"rows": 8}}}, ["pattern.rows"]),
        ("design", {"design": {"pattern": {"rows": 999, "columns": 999}}},
         ["pattern.rows", "pattern.columns"]),
        ("design", {"design": {"target": {"f": {"formula": "x +", "range": [0, 1]}}}},
         ["target.f.formula"]),
        ("parse", {"text": "[shell"}, []),
        ("nothing", {}, []),
    ],
)  # fmt: skip
def test_refusals_name_the_keys_that_they_are_about(
    client: httpx.Client, path: str, body: dict[str, Any], keys: list[str]
) -> None:
    if "design" in body:
        design = tomllib.loads(starter_file("parallel-repeating"))
        for table, values in body["design"].items():
            design[table] |= values
        body = {"design": design}
    refusal = client.post(f"/api/{path}", json=body).json()
    assert fits(refusal, api.Refusal)
    assert refusal["error"]["keys"] == keys


def test_a_message_of_another_type_does_not_fit() -> None:
    refusal = make_refusal("input", "no")
    assert fits(refusal, api.Refusal)
    assert not fits({**refusal, "more": 1}, api.Refusal)
    assert not fits({}, api.Refusal)
    assert not fits({"error": {**refusal["error"], "kind": "other"}}, api.Refusal)
    assert not fits({"error": {**refusal["error"], "keys": [1]}}, api.Refusal)
