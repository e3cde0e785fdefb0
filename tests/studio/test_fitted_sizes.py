"""Sizes of the built shell in the studio: its file keeps them, and its verdict says them."""

from __future__ import annotations

from typing import Any

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
