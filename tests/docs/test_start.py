"""The pages under "Start" are true: what they call is called here, and answers what they print."""

from __future__ import annotations

import doctest
import re
import shlex
import shutil
import tomllib
from pathlib import Path

import pytest

from command_line import orishell
from orishell.design_file import starter_file

ROOT = Path(__file__).parents[2]
START = ROOT / "docs" / "start"


def blocks(page: str, language: str) -> list[str]:
    """Fenced blocks of a page."""
    text = (START / page).read_text(encoding="utf-8")
    found = re.findall(rf"^```{re.escape(language)}\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    assert found, f"no {language} in {page}"
    return found


def calls(page: str) -> list[tuple[list[str], str]]:
    """Commands of a page, each with what it is said to print."""
    found = []
    for block in blocks(page, "console"):
        command, _, printed = block.partition("\n")
        assert command.startswith("$ orishell ")
        found.append((shlex.split(command)[2:], printed))
    return found


def assert_answers(call: tuple[list[str], str], where: Path) -> None:
    """A call prints what the page says, "..." standing for anything within a line."""
    words, printed = call
    ran = orishell(*words, cwd=where)
    got = ran.stdout if ran.returncode == 0 else ran.stderr
    pattern = re.escape(printed.strip()).replace(re.escape("..."), "[^\n]*")
    if printed:
        assert re.fullmatch(pattern, got.strip()), got
    assert ran.returncode == (1 if printed.startswith("orishell:") else 0), ran.stderr


def test_the_first_file_is_the_starter() -> None:
    shown = tomllib.loads(blocks("first-shell.md", "toml")[0])
    starter = tomllib.loads(starter_file("parallel-repeating"))
    for table in ("shell", "target"):
        assert starter[table] == shown[table]
    for key, value in shown["pattern"].items():
        assert starter["pattern"][key] == value


@pytest.mark.slow
def test_first_shell(tmp_path: Path) -> None:
    made, designed, chosen, refused = calls("first-shell.md")
    assert_answers(made, tmp_path)
    assert_answers(designed, tmp_path)
    assert {"overview.png", "deviation.png", "shell.fold", "report.json", ".orishell.json"} == {
        each.name for each in (tmp_path / "shell").iterdir()
    }
    file = tmp_path / "shell.toml"
    text = file.read_text(encoding="utf-8")
    file.write_text(re.sub(r"(?m)^xi_deg = 50", "xi_deg = 60", text), encoding="utf-8")
    assert_answers(refused, tmp_path)
    text = re.sub(r"(?m)^(rows|columns|xi_deg) =.*\n", "", text)
    file.write_text(f"{text}\n{blocks('first-shell.md', 'toml')[1]}", encoding="utf-8")
    assert_answers(chosen, tmp_path)
    assert (tmp_path / "shell" / "tradeoff.png").exists()


@pytest.mark.slow
def test_from_profile_to_laser(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copy(ROOT / "examples" / "profile.dxf", tmp_path)
    [text] = blocks("profile-to-laser.md", "toml")
    (tmp_path / "tunnel.toml").write_text(text, encoding="utf-8")
    designed, converted = calls("profile-to-laser.md")
    assert_answers(designed, tmp_path)
    assert_answers(converted, tmp_path)
    assert (tmp_path / "sheet-2.dxf").exists()
    # The picture on the page is the file that the page's design file gives.
    shown = ROOT / "docs" / "images" / "workshop-1.svg"
    assert (tmp_path / "tunnel" / "pattern-1.svg").read_bytes() == shown.read_bytes()
    figures = "\n".join(blocks("profile-to-laser.md", "python"))
    monkeypatch.chdir(tmp_path)
    test = doctest.DocTestParser().get_doctest(figures, {}, "figures", None, 0)
    runner = doctest.DocTestRunner(verbose=False)
    runner.run(test)
    assert runner.tries == 6
    assert runner.failures == 0
