"""What is imported, and when: waiting for a library is most of the time of a short command."""

from __future__ import annotations

import ast
import importlib
import inspect
import subprocess
import sys
from pathlib import Path

import pytest

import orishell
from orishell.cli import check, files
from orishell.io.formats import ALL, all_formats
from orishell.verification import LENGTH_TOLERANCE

ROOT = Path(__file__).parents[2]

FORMATS_AND_PICTURES = {
    *("anywidget", "ezdxf", "igl", "matplotlib", "meshio", "orjson", "PIL", "pygltflib", "trimesh"),
    *("reportlab", "rhino3dm", "scipy", "shapely"),
    *("fastapi", "starlette", "tomli_w", "uvicorn"),
    *("http.client", "urllib.request", "xml.sax"),
}
HEAVY = {"numpy", "pydantic", *FORMATS_AND_PICTURES}

LISTED = """
import atexit, sys
atexit.register(lambda: print("MODULES", *sys.modules))
"""


def imported(program: str, *arguments: str) -> set[str]:
    """Every module that a program has imported when it ends."""
    done = subprocess.run(
        [sys.executable, "-c", LISTED + program, *arguments],
        capture_output=True,
        text=True,
        check=True,
        timeout=120,
    )
    assert done.stdout.count("MODULES") == 1
    return set(done.stdout.split("MODULES")[1].split())


RUN = "from orishell.cli.main import run; run()"


def test_help_imports_nothing_heavy() -> None:
    modules = imported(RUN, "--help")
    assert "orishell.cli.design" in modules
    assert not modules & HEAVY


@pytest.mark.parametrize(
    "command",
    ["new", "design", "structure", "search", "solve", "check", "convert", "studio", "hops"],
)
def test_help_of_a_command_imports_nothing_heavy(command: str) -> None:
    found = imported(RUN, command, "--help") & HEAVY
    assert found <= {"pydantic"}  # typer looks at types with it where it is installed


def test_the_version_imports_nothing_heavy() -> None:
    assert not imported(RUN, "--version") & {*HEAVY, "rich"}


def test_the_package_imports_nothing_heavy() -> None:
    assert not imported("import orishell; orishell.InputError") & HEAVY


def test_a_design_waits_for_no_format_and_no_picture() -> None:
    modules = imported(
        "from orishell import design_shell, write_shell; "
        "from orishell.io.formats import all_formats; all_formats()"
    )
    assert "orishell.families.longitudinal_linear_repeating.equation.solutions" in modules
    assert "orishell.io.formats.rhino" in modules
    assert not modules & FORMATS_AND_PICTURES


def test_the_package_has_what_it_lists() -> None:
    """What type checkers and editors see, what `__all__` says and what is there: one list."""
    tree = ast.parse((ROOT / "src" / "orishell" / "__init__.py").read_text())
    seen = {
        alias.name: node.module
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and str(node.module).startswith("orishell.")
        for alias in node.names
        if alias.name != "import_on_demand"
    }
    assert sorted(seen) == sorted(orishell.__all__)
    for name, home in seen.items():
        assert getattr(orishell, name) is getattr(importlib.import_module(str(home)), name)
    assert set(orishell.__all__) <= set(dir(orishell))
    with pytest.raises(AttributeError, match="has no attribute 'design_everything'"):
        orishell.design_everything  # noqa: B018


def test_help_says_what_it_does_not_import() -> None:
    names = [each.name for each in all_formats()]
    assert files.WRITE_HELP.endswith(f": {', '.join(names)}; or {ALL}.")
    assert inspect.signature(check.check).parameters["tolerance"].default == LENGTH_TOLERANCE
