"""Sizes of the built shell in the studio: its file keeps them, and its verdict says them."""

from __future__ import annotations

from typing import Any

import pytest
import tomli_w

from orishell.conventions.progress import no_progress
from orishell.studio.tasks import answer
from sized_shells import DESIGNS


def test_a_file_with_sizes_keeps_them_and_its_verdict_says_them() -> None:
    tables = DESIGNS["parallel"]
    fit = {"width": 4.5, "height": 2.2, "of": "outside"}
    asked: dict[str, Any] = {**tables, "target": {**tables["target"], "fit": fit}}
    opened = answer("parse", {"text": tomli_w.dumps(asked)}, no_progress)["design"]
    assert opened == asked
    text = answer("format", {"design": opened}, no_progress)["text"]
    assert answer("parse", {"text": text}, no_progress)["design"] == asked
    assert answer("design", {"design": opened}, no_progress)
    report = answer("verify", {"design": opened}, no_progress)["report"]
    assert report["fitted"]["asked"] == {"width": 4.5, "height": 2.2}
    (said,) = [row["finding"] for row in report["verdict"] if row["subject"] == "sizes"]
    assert said.startswith(
        "width 4.5, height 2.2 m outside, boards and flaps included; scaled: f by "
    )


def test_the_sizes_of_a_shell_are_told_with_its_proof_whether_or_not_they_are_asked_for() -> None:
    tables = DESIGNS["parallel"]
    verified = answer("verify", {"design": tables}, no_progress)
    box = verified["report"]["deployed"]
    assert verified["sizes"]["outside"] == pytest.approx(box, rel=1e-12)
    assert verified["sizes"]["head_height"] == 2.0
    # With these as the sizes that are asked for, the target stays as it is.
    inside = {key: size for key, size in verified["sizes"]["inside"].items() if size}
    fit = {**inside, "of": "inside"}
    asked = {**tables, "target": {**tables["target"], "fit": fit}}
    again = answer("verify", {"design": asked}, no_progress)
    found = again["report"]["fitted"]["found"]
    assert found == pytest.approx(inside, abs=1e-3)
    assert again["sizes"]["inside"] | found == again["sizes"]["inside"]
    # Values of parameters work with a target of one size: none is known to work with all.
    assert answer("ranges", {"design": asked}, no_progress) == {"ranges": {}}
