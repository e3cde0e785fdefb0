"""Words, field, colour and exit status of an analysis say one thing."""

from __future__ import annotations

import pytest
import typer

from orishell.cli.files import require_carried
from orishell.cli.structure import summarize_structure
from orishell.conventions.record import as_table
from orishell.conventions.row import MARKS
from orishell.structure.pages.files import VERDICTS, structure_page
from orishell.structure.results import Analysis


def one_verdict(found: Analysis) -> bool | None:
    """Whether it carries, as all doors say it."""
    carries: bool | None = found.carries
    begins = {True: "all cases: ", False: "no: ", None: "not known: "}[carries]
    assert found.in_words().startswith(begins)
    assert {"holds": True, "fails": False, "warns": None}[found.sign] is carries
    worst = found.ranked[0]
    assert worst.carries is carries
    assert as_table(found)["carries"] is carries
    assert as_table(found)["cases"][found.cases.index(worst)]["carries"] is carries
    line = next(summarize_structure(found, found.model.site.unit, []))
    assert line.startswith(f"{MARKS[found.sign]} stands    {begins}")
    page = structure_page(found, title="", unit=found.model.site.unit, png=b"")
    assert f"Does it carry its loads? {begins.capitalize()}" in page.replace("&#x27;", "'")
    assert ("not known" in VERDICTS[found.sign]) is (carries is None)
    assert found.loaded().cases[found.cases.index(worst)].sign == found.sign
    if carries:
        require_carried(found, check=True)
    else:
        with pytest.raises(typer.Exit) as ended:
            require_carried(found, check=True)
        assert ended.value.exit_code == 1
    return None if carries is None else bool(carries)
