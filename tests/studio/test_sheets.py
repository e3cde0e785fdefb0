"""The studio's answers on sheets for the workshop and on what fewer panels cost."""

from __future__ import annotations

import io
import re
import zipfile
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from orishell.conventions.errors import InputError, OrishellError
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import check_design, starter_file
from orishell.design_file.tables import with_values
from orishell.shell import tradeoff
from orishell.shell.board_limits import as_cut
from orishell.shell.designed import designed
from orishell.studio.processes import MAX_VERTICES
from orishell.studio.refusals import describe_error
from orishell.studio.tasks import answer
from orishell.workshop import tiling
from orishell.workshop.layout import require_stock
from orishell.workshop.palettes import load_palette

STOCK = {"stock": [2.5, 2.5], "margin": 0.05, "palette": "shop"}


def asked(task: str, workshop: dict[str, Any] | None = None, **more: Any) -> Any:
    design = {**parse_toml(starter_file("orthodiagonal")), "workshop": workshop or {}}
    payload = {"design": design, "name": "awning", **more}
    return answer(task, payload, lambda _share, _what: None)


def require_pages(sheets: dict[str, Any]) -> None:
    """The paper model's picture has the number of every page that its words count."""
    found = re.search(r", (\d+) pages? of A[34]$", sheets["paper"]["says"])
    assert found
    root = ElementTree.fromstring(sheets["paper"]["svg"])
    numbers = [each.text for each in root.iter("{http://www.w3.org/2000/svg}text")]
    assert sorted(map(str, range(1, int(found[1]) + 1))) == sorted(map(str, numbers))


def test_sheets_are_those_that_are_exported() -> None:
    sheets = asked("sheets", STOCK)
    names = [sheet["file"] for sheet in sheets["sheets"]]
    assert names == ["awning", "awning-1", "awning-2", "awning-3", "awning-4"]
    _, content = asked("export", STOCK, format="svg")
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        assert sorted(archive.namelist()) == sorted(f"{name}.svg" for name in names)
    assert sheets["stock"].sheets == 4
    assert sheets["boards"] is None
    require_pages(sheets)
    assert sheets["paper"]["says"].endswith("of A4")
    # The colours of the palette, wide enough to be seen; layers that it leaves out are not there.
    pens = load_palette("shop").pens
    shown = {each["layer"]: each["colour"] for each in sheets["layers"]}
    assert shown == {layer: pens[layer].colour for layer in shown}
    assert "LABEL" not in shown
    for sheet in sheets["sheets"][1:]:
        assert 'viewBox="0 0 2.5 2.5"' in sheet["svg"]
        widths = [float(width) for width in re.findall(r'stroke-width="([^"]+)"', sheet["svg"])]
        assert min(widths) > 2.5 / 2000


def test_boards_have_sheets_of_their_own() -> None:
    design = parse_toml(starter_file("orthodiagonal"))
    design["pattern"] |= {"rows": 5, "columns": 7}
    design |= {"workshop": {"stock": [3.0, 3.0]}, "panel": {"thickness": 0.002, "membrane": 0.0002}}
    sheets = asked("sheets", design=design)
    assert sheets["boards"] >= 1
    assert any("-boards-1" in sheet["file"] for sheet in sheets["sheets"])


def test_stock_that_no_panel_fits_is_refused_with_what_would_do() -> None:
    with pytest.raises(InputError, match="do not fit the stock") as caught:
        asked("sheets", {"stock": [0.3, 0.3]})
    assert "at least" in caught.value.expected
    assert "larger stock" in caught.value.remedy
    # Its button has rows and columns whose panels fit.
    (mend,) = describe_error(caught.value)["error"]["remedies"]
    assert {*mend["changes"]} == {"pattern.rows", "pattern.columns"}
    tables = {**parse_toml(starter_file("orthodiagonal")), "workshop": {"stock": [0.3, 0.3]}}
    file = check_design(with_values(tables, mend["changes"]), Path("awning.toml"))
    require_stock(as_cut(file, designed(file)), file.workshop)


def test_a_paper_model_of_too_many_pages_is_said_and_the_rest_drawn(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(tiling, "MOST_PAGES", 100)
    sheets = asked("sheets", {"paper_scale": 1.0})
    assert "needs more than 100 pages" in sheets["paper"]["says"]
    assert sheets["paper"]["svg"] == ""
    assert len(sheets["sheets"]) == 1


def test_the_size_on_the_screen_is_tried_where_none_is_in_the_file(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(tradeoff, "MOST_PANELS", 10)
    design = parse_toml(starter_file("orthodiagonal"))
    for key in ("rows", "columns"):
        del design["pattern"][key]
    design["tolerance"] = {"surface": 1.0}
    found = asked("tradeoff", design=design, size={"rows": 5, "columns": 7})
    assert (5, 7) in {(trial.rows, trial.columns) for trial in found.tried}
    side = int(MAX_VERTICES**0.5) // 2 * 2 + 1
    for size in ({"rows": side, "columns": side}, {"rows": 5}, {"rows": -1, "columns": 7}):
        with pytest.raises(OrishellError):
            asked("tradeoff", design=design, size=size)
