"""The notebook of the examples: its cells run one after the other, as a reader runs them."""

from __future__ import annotations

import contextlib
import io
import json
from pathlib import Path
from typing import Any

import pytest

from viewer_pages import require_viewer

NOTEBOOK = Path(__file__).parents[1] / "examples" / "notebook.ipynb"


def test_cells_run_and_print_what_the_text_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In an empty folder; none has an output, so that the file says nothing that is out of date."""
    require_viewer()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    content = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    assert (content["nbformat"], content["nbformat_minor"]) == (4, 5)
    names: dict[str, Any] = {}
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        for cell in content["cells"]:
            if cell["cell_type"] == "code":
                assert cell["outputs"] == []
                assert cell["execution_count"] is None
                exec(compile("".join(cell["source"]), cell["id"], "exec"), names)
    assert len({cell["id"] for cell in content["cells"]}) == len(content["cells"])
    # Edges keep their lengths, contact is proved, and more rows are nearer.
    assert "edges keep their lengths to " in said.getvalue()
    assert float(said.getvalue().split("lengths to ")[1].split()[0]) < 1e-13
    assert "folds: in one motion: nothing touches" in said.getvalue()
    assert names["away"] == sorted(names["away"], reverse=True)
    assert {path.suffix for path in (tmp_path / "notebook_shell").iterdir()} >= {
        ".fold",
        ".glb",
        ".dxf",
    }
