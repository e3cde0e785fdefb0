"""The guide's page of notebooks: what stands there runs, in Jupyter's widgets and in marimo."""

from __future__ import annotations

import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from viewer_pages import require_viewer

PAGE = Path(__file__).parents[1] / "docs" / "guide" / "notebooks.md"


def blocks() -> list[str]:
    return re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), flags=re.DOTALL)


def test_sliders_of_jupyter_change_what_is_shown() -> None:
    """A slider brings another shell into the same widget; a refusal leaves it, and says why."""
    require_viewer()
    names: dict[str, Any] = {}
    exec(compile(blocks()[0], PAGE, "exec"), names)
    viewer, first = names["viewer"], names["viewer"].view
    names["rows"].value = 11
    second = viewer.view
    assert len(second) > len(first)
    names["xi"].value = 60
    assert viewer.view == second
    assert "xi_deg must stay below" in names["said"].value
    names["xi"].value = 50
    names["rows"].value = 9
    assert (viewer.view, names["said"].value) == (first, "")


def test_the_notebook_of_marimo_runs(tmp_path: Path) -> None:
    """As a script, in a process of its own: its last cell shows the widget."""
    if find_spec("marimo") is None:
        pytest.skip("marimo is not installed: pip install marimo")
    require_viewer()
    (tmp_path / "shell.py").write_text(blocks()[1], encoding="utf-8")
    asked = "import shell; _, names = shell.app.run(); print(len(names['shown'].widget.view))"
    done = subprocess.run(
        [sys.executable, "-c", asked],
        cwd=tmp_path,
        capture_output=True,
        encoding="utf-8",
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert int(done.stdout.split()[-1]) > 1000
