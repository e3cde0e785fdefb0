"""All files or none, and nothing of others touched."""

from pathlib import Path

import pytest

from orishell.conventions.errors import InputError
from orishell.io import OutputDirectory
from orishell.io.manifest import NAME


def test_files_appear_together_and_others_stay(tmp_path: Path) -> None:
    target = tmp_path / "out"
    target.mkdir()
    (target / "mine.txt").write_text("mine")
    with OutputDirectory(target).adding() as draft:
        (draft / "a").write_text("old")
    with OutputDirectory(target).adding() as draft:
        (draft / "a").write_text("new")
        (draft / "b").write_text("new")
        assert (target / "a").read_text() == "old"
    assert {file.name: file.read_text() for file in target.iterdir() if file.name != NAME} == {
        "mine.txt": "mine",
        "a": "new",
        "b": "new",
    }
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


def test_nothing_is_left_after_an_error(tmp_path: Path) -> None:
    def fail() -> None:
        with OutputDirectory(tmp_path / "deep" / "out").adding() as draft:
            (draft / "a").write_text("half")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail()
    assert not list(tmp_path.iterdir())


def test_a_directory_in_the_way_of_a_file_stops_all(tmp_path: Path) -> None:
    (tmp_path / "b").mkdir()

    def fail() -> None:
        with OutputDirectory(tmp_path).adding() as draft:
            (draft / "a").write_text("new")
            (draft / "b").write_text("new")

    with pytest.raises(InputError, match="in the way"):
        fail()
    assert [path.name for path in tmp_path.iterdir()] == ["b"]


def test_a_file_in_the_way_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    for path in (tmp_path / "file", tmp_path / "file" / "below"):
        with pytest.raises(InputError, match="is a file"):
            OutputDirectory(path).require_usable()


def test_a_full_disk_is_one_message(tmp_path: Path) -> None:
    def fail() -> None:
        with OutputDirectory(tmp_path / "out").adding():
            raise OSError(28, "No space left on device")

    with pytest.raises(InputError, match="No space left"):
        fail()
    assert not list(tmp_path.iterdir())
