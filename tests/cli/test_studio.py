"""``orishell studio`` where it cannot start: status 2, one message, and no browser opens."""

from __future__ import annotations

import re
import socket
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from orishell.cli import studio
from orishell.cli.main import run
from orishell.conventions.toml_file import read_toml
from orishell.design_file.tasks import task_file
from orishell.studio import app, guard

ROOT = Path(__file__).parents[2]


@pytest.fixture(autouse=True)
def opened(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """No browser opens."""
    pages: list[str] = []
    monkeypatch.setattr(guard, "open_page", pages.append)
    yield
    assert pages == []


@pytest.fixture
def pages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "index.html").write_text("<!doctype html><title>pages</title>")
    monkeypatch.setattr(app, "PAGES", tmp_path)
    return tmp_path


def refusal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str
) -> str:
    monkeypatch.setattr(sys, "argv", ["orishell", "studio", *arguments])
    with pytest.raises(SystemExit) as ended:
        run()
    said = capsys.readouterr()
    assert (ended.value.code, said.out) == (2, "")
    (line,) = said.err.splitlines()
    return line


@pytest.mark.usefixtures("pages")
def test_a_port_in_use(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        line = refusal(monkeypatch, capsys, "--port", port)
    assert line == (
        f"orishell: --port: another program listens on this port already; got {port}. "
        "Remedy: end that program, or choose another port."
    )


@pytest.mark.usefixtures("pages")
@pytest.mark.parametrize("host", ["203.0.113.7", "nowhere.invalid", "a" * 70 + ".invalid", ""])
def test_an_address_of_another_machine(
    host: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    line = refusal(monkeypatch, capsys, "--host", host)
    assert line.startswith(
        f"orishell: --host: the studio cannot listen on this address; got {host!r} ("
    )
    assert line.endswith("expected an address of this machine.")


def test_without_pages(
    pages: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (pages / "index.html").unlink()
    line = refusal(monkeypatch, capsys)
    assert line.startswith("orishell: the studio has no pages: they have not been built. Remedy:")


def test_nothing_that_is_installed_speaks_of_make() -> None:
    """Who has installed the package has no Makefile."""
    files = [
        *(ROOT / "src").rglob("*.py"),
        *(ROOT / "frontend" / "src").rglob("*.ts"),
        ROOT / "frontend" / "index.html",
    ]
    assert len(files) > 200
    targets = re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text(), re.MULTILINE)
    spoken = re.compile(rf"\bmake ({'|'.join(targets)})\b")
    assert spoken.search("run `make studio`")
    assert not [str(path) for path in files if spoken.search(path.read_text(encoding="utf-8"))]


@pytest.mark.parametrize("curves", [True, False])
def test_a_design_with_sizes_is_opened(tmp_path: Path, *, curves: bool) -> None:
    """Sizes stand beside curves, or alone, and have no file that is drawn in their place."""
    path = tmp_path / "sized.toml"
    text = task_file("screen")
    if curves:
        text = (ROOT / "examples" / "figure1.toml").read_text() + "[target.fit]\nwidth = 20\n"
    path.write_text(text, encoding="utf-8")
    opened = studio._start(path)
    assert opened["design"]["target"]["fit"] == read_toml(path)["target"]["fit"]
