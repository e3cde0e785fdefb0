"""What is built from a fresh clone, and what it does in an environment of its own."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from collections.abc import Mapping
from pathlib import Path

import httpx
import pytest

from node_tools import lacking
from samples import THOROUGH, thorough
from studio_server import running_studio

ROOT = Path(__file__).parents[1]
ROOMS = ("orishell/io/pages/", "orishell/studio/static/")
PAGES = {
    *("orishell/io/pages/viewer.js", "orishell/io/pages/front.js"),
    "orishell/io/pages/three-licence.txt",
    *("orishell/studio/static/index.html", "orishell/studio/static/three-licence.txt"),
}
NONE: Mapping[str, str] = {}
QUICKLY = () if THOROUGH else ("--no-clash-test",)
HAVING_TOOLS = ("--no-build-isolation", "--check-build-dependencies")
SHOW = """
import numpy as np
import orishell
f = orishell.curve_from_formulas(None, orishell.parse_formula("-x**2"), -1, 1)
g = orishell.curve_from_formulas(None, orishell.parse_formula("0.1*x"), 0, 2)
design = orishell.design_parallel_repeating(
    f, g, orishell.ParallelRepeatingPattern(rows=3, columns=2, xi_deg=50, flap=0.3)
)
try:
    print(type(orishell.show(design)).__name__)
except orishell.InputError as error:
    print(error)
"""


def clone(place: Path) -> Path:
    """The files of the work tree that are, or are to be, under version control."""
    if not (ROOT / ".git").exists():
        lacking("this is no clone of the repository")
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    for name in filter(None, listed.split("\0")):
        if (ROOT / name).is_file():
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, place / name)
    assert not any((place / "src" / room).exists() for room in ROOMS)
    assert not (place / "frontend" / "node_modules").exists()
    return place


def lend_pages(place: Path) -> None:
    """Copy pages that are built into a clone; where they are older than it, it builds its own."""
    for room in ROOMS:
        if (ROOT / "src" / room).exists():
            shutil.copytree(ROOT / "src" / room, place / "src" / room)


def plain(more: Mapping[str, str]) -> dict[str, str]:
    """The environment's variables without those that lead back to the work tree."""
    unset = {"PYTHONPATH", "VIRTUAL_ENV", "ORISHELL_WITHOUT_PAGES", "PYTHONDONTWRITEBYTECODE"}
    return {name: value for name, value in os.environ.items() if name not in unset} | dict(more)


def ran(
    *command: str | Path, where: Path, status: int = 0, variables: Mapping[str, str] = NONE
) -> str:
    """What a command prints, on standard error too, that knows nothing of this environment."""
    done = subprocess.run(
        list(map(str, command)), cwd=where, env=plain(variables),
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, timeout=1200,
    )  # fmt: skip
    assert done.returncode == status, done.stdout
    assert "Traceback" not in done.stdout
    return done.stdout


def build_wheel(
    source: Path, place: Path, variables: Mapping[str, str] = NONE, *options: str
) -> Path:
    pip = (sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", place)
    ran(*pip, *options, source, where=place.parent, variables=variables)
    (wheel,) = place.glob("*.whl")
    return wheel


def wheel_of_clone(tree: Path, tools: Path, place: Path) -> Path:
    """Built as by anyone; else with pages that are lent, and tools that are installed already."""
    if THOROUGH:
        return build_wheel(tree, place)
    lend_pages(tree)
    return build_wheel(tree, place, {"PYTHONPATH": str(tools)}, *HAVING_TOOLS)


def pages_in(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as files:
        return {name for name in files.namelist() if name.startswith(ROOMS)}


@pytest.mark.slow
def test_a_clone_becomes_a_wheel_that_works_anywhere(tmp_path: Path) -> None:
    if shutil.which("npm") is None:
        lacking("npm is not installed: on Debian, apt-get install nodejs npm")
    nowhere = tmp_path / "empty"
    nowhere.mkdir()
    tree = clone(tmp_path / "clone")
    tools = tmp_path / "tools"
    pip = (sys.executable, "-m", "pip", "install", "--quiet", "--no-compile")
    ran(*pip, "--target", tools, "hatchling", where=nowhere)
    wheel = wheel_of_clone(tree, tools, tmp_path / "wheel")
    assert pages_in(wheel) > PAGES

    # A source distribution holds the pages, so its wheel needs no npm.
    hatch = (sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-d", tmp_path / "sdist")
    bare = {"PYTHONPATH": str(tools), "PATH": str(nowhere)}
    ran(*hatch, where=tree, variables=bare)
    (source,) = (tmp_path / "sdist").iterdir()
    again = build_wheel(source, tmp_path / "again", bare, "--no-build-isolation")
    assert again.read_bytes() == wheel.read_bytes()
    shutil.rmtree(tree)

    ran(sys.executable, "-m", "venv", "--without-pip", tmp_path / "environment", where=nowhere)
    python = tmp_path / "environment" / "bin" / "python"
    command = python.with_name("orishell")
    quickly = ("install", "--quiet", "--no-compile", "-c", ROOT / "constraints.txt")
    install = (sys.executable, "-m", "pip", "--python", python, *quickly)
    if THOROUGH:
        ran(*install, f"{wheel}[studio]", where=nowhere)
    else:  # what it needs is lent by this environment, which is longer in the making
        ran(*install, "--no-deps", wheel, where=nowhere)
        (packages,) = (tmp_path / "environment").glob("lib/*/site-packages")
        (packages / "lent.pth").write_text(sysconfig.get_path("purelib"))

    ran(command, "new", "arch", "shell.toml", where=nowhere)
    ran(command, "design", "shell.toml", "--out", "out", "--write", "html", *QUICKLY, where=nowhere)
    assert (nowhere / "out" / "viewer.html").stat().st_size > 500_000

    with running_studio(nowhere / "shell.toml", python=python, environment=plain(NONE)) as studio:
        page = httpx.get(studio.address, cookies=studio.cookies)
        assert page.status_code == 200
        parts = re.findall(r'(?:src|href)="\./(assets/[^"]+)"', page.text)
        assert len(parts) >= 2
        for part in parts:
            found = httpx.get(f"{studio.address}/{part}", cookies=studio.cookies)
            assert found.status_code == 200
        if not THOROUGH:  # nor another studio beside it, which test_studio.py starts
            return
        port = studio.address.rpartition(":")[2]
        said = ran(command, "studio", "--port", port, where=nowhere, status=2)
        assert said.startswith("orishell: --port: another program listens on this port already")

    missing = ran(python, "-c", SHOW, where=nowhere)
    assert 'Remedy: pip install "orishell[notebook]"' in missing
    ran(*install, f"{wheel}[notebook]", where=nowhere)
    assert ran(python, "-c", SHOW, where=nowhere) == "Viewer\n"


@thorough
@pytest.mark.slow
def test_a_build_without_npm_says_so_and_what_it_lacks_says_so(tmp_path: Path) -> None:
    nowhere = tmp_path / "empty"
    nowhere.mkdir()
    bare, tree = {"PATH": str(nowhere)}, clone(tmp_path / "clone")
    pip = (sys.executable, "-m", "pip", "wheel", "--no-deps", "--wheel-dir", tmp_path / "wheel")
    said = ran(*pip, tree, where=nowhere, status=1, variables=bare)
    assert "are built with Node.js 18 or newer and npm, which is not there" in said
    assert "ORISHELL_WITHOUT_PAGES=1 builds orishell without them" in said

    # An install that points to the sources needs none either.
    editable = (sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--editable", tree)
    ran(*editable, "--target", tmp_path / "editable", where=nowhere, variables=bare)

    wheel = build_wheel(tree, tmp_path / "wheel", {**bare, "ORISHELL_WITHOUT_PAGES": "1"})
    assert pages_in(wheel) == set()
    with zipfile.ZipFile(wheel) as files:
        files.extractall(tmp_path / "installed")
    remedy = "Remedy: install a wheel of orishell that has the pages"
    here = {"PYTHONPATH": str(tmp_path / "installed")}

    def orishell(*words: str | Path, status: int) -> str:
        command = (sys.executable, "-m", "orishell", *words)
        return ran(*command, where=nowhere, status=status, variables=here)

    assert remedy in orishell("studio", status=2)
    orishell("new", "--family", "parallel-repeating", "shell.toml", status=0)
    said = orishell("design", "shell.toml", "--out", "out", "--write", "html", status=2)
    assert f"the viewer has not been built. {remedy}" in said
    assert not (nowhere / "out").exists()
    assert remedy in ran(sys.executable, "-c", SHOW, where=nowhere, variables=here)
