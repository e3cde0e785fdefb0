"""The page changes tables as the program does: ``frontend/tests/changes.json`` is for both."""

import json
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from orishell.design_file.tables import with_values

CASES = Path(__file__).parents[2] / "frontend" / "tests" / "changes.json"


@pytest.mark.parametrize("case", json.loads(CASES.read_text()))
def test_tables_are_changed_as_in_the_page(case: dict[str, Any]) -> None:
    kept = deepcopy(case["before"])
    assert with_values(case["before"], case["changes"]) == case["after"]
    assert case["before"] == kept
