"""The studio's server tries all families, tells of each, and says the same as the command."""

from __future__ import annotations

import json
from typing import Any

import httpx

from orishell.families.registry import TRIED
from orishell.studio import api
from typescript import fits

VAULT: dict[str, Any] = {
    "shell": {"family": "auto", "unit": "m"},
    "target": {
        "f": {"formula": "-0.5*x**2", "range": [-1, 1]},
        "g": {"formula": "0*x", "range": [0, 3]},
    },
    "pattern": {"rows": 3, "columns": 3},
}


def asked(client: httpx.Client, task: str, design: Any) -> list[Any]:
    lines = client.post(f"/api/{task}", json={"design": design}).text.splitlines()
    return [json.loads(each) for each in lines]


def test_each_family_is_told_of_and_the_report_says_the_same(client: httpx.Client) -> None:
    *said, last = asked(client, "families", VAULT)
    assert fits(last, api.FamiliesResult)
    found = [each for each in said if "found" in each]
    assert all(fits(each, api.FamiliesFound) for each in found)
    assert [len(each["found"]) for each in found] == [1 + k for k in range(len(TRIED))]
    shares = [each["progress"] for each in said if "progress" in each]
    assert shares == sorted(shares)
    result = last["result"]
    assert [each["family"] for each in result["tried"]] == list(TRIED)
    assert found[-1]["found"] == result["tried"]
    verified = asked(client, "verify", VAULT)[-1]["result"]["report"]
    assert verified["families"] == result
    assert verified["family"] == result["family"]


def test_a_target_is_needed(client: httpx.Client) -> None:
    (refusal,) = asked(client, "families", {**VAULT, "target": None})
    assert fits(refusal, api.Refusal)
