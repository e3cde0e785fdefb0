"""What ``make quick`` runs is what tests the files that changed."""

from __future__ import annotations

from pathlib import Path

import pytest

import worked_in


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A tree with two rooms, one of them with a room in it, and a module that one of them uses."""
    for name, text in {
        "tests/shell/test_make.py": "from sheets import miura\n",
        "tests/shell/fit/test_turn.py": "import sheets\n",
        "tests/clash/test_path.py": "from sheets_of_card import miura\n",
        "tests/sheets.py": "",
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


@pytest.mark.parametrize(
    ("changed", "tests"),
    [
        (["src/orishell/shell/make.py"], ["tests/shell"]),
        (["src/orishell/shell/fit/turn.py"], ["tests/shell/fit"]),
        (["src/orishell/shell/kit/facts.py"], ["tests/shell"]),
        (["src/orishell/shell/fit/turn.py", "src/orishell/shell/make.py"], ["tests/shell"]),
        (
            ["src/orishell/shell/make.py", "src/orishell/clash/a/b.py"],
            ["tests/clash", "tests/shell"],
        ),
        (["tests/shell/test_make.py"], ["tests/shell/test_make.py"]),
        (["tests/shell/fit/surfaces.py"], ["tests/shell/fit"]),
        (["tests/sheets.py"], ["tests/shell/fit/test_turn.py", "tests/shell/test_make.py"]),
        (["tests/sheets.py", "src/orishell/shell/make.py"], ["tests/shell"]),
        (["examples/dome.toml"], ["tests/test_examples.py"]),
        (["docs/guide/boards.md", "frontend/src/main.ts"], ["tests/docs", "tests/studio"]),
        (["tests/shell/test_gone.py", "README.md", "src/orishell/version.py"], []),
    ],
)
def test_what_changed_has_its_tests(changed: list[str], tests: list[str], root: Path) -> None:
    assert worked_in.tests_of(changed, root) == tests


def test_a_room_is_named_or_found(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert worked_in.main(["locking", "families/drawn"]) == 0
    assert capsys.readouterr().out == "tests/locking tests/families/drawn\n"
    monkeypatch.setattr(worked_in, "changed_files", lambda: ["src/orishell/clash/path.py"])
    assert worked_in.main([]) == 0
    assert capsys.readouterr().out == "tests/clash\n"
    monkeypatch.setattr(worked_in, "changed_files", list)
    assert worked_in.main([]) == 2
    assert capsys.readouterr() == ("", f"{worked_in.NOTHING}\n")
