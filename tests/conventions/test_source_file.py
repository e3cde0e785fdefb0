"""What is no file is refused by every reader, before it is opened: some would never end."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from orishell.conventions.errors import InputError
from orishell.conventions.source_file import read_source_file
from orishell.conventions.toml_file import read_toml
from orishell.curves import read_dxf, read_points, read_svg
from orishell.design.mesh_files import ENDINGS, read_mesh
from orishell.io import read_fold
from orishell.io.patterns.read import read_pattern

READERS: dict[str, tuple[Callable[[Any], Any], tuple[str, ...]]] = {
    "pattern": (read_pattern, (".fold", ".svg", ".dxf", ".cp")),
    "mesh": (read_mesh, ENDINGS),
    "shell": (read_fold, (".fold",)),
    "tables": (read_toml, (".toml",)),
    "points": (read_points, (".csv",)),
    "drawing": (partial(read_svg, into="m"), (".svg",)),
    "cad": (partial(read_dxf, into="m"), (".dxf",)),
}
CASES = [(name, ending) for name, (_, endings) in READERS.items() for ending in endings]


def _pipe(path: Path) -> None:
    os.mkfifo(path)


def _device(path: Path) -> None:
    path.symlink_to("/dev/zero")


def _piped(path: Path) -> None:
    os.mkfifo(path.with_name("pipe"))
    path.symlink_to("pipe")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes among files")
@pytest.mark.parametrize(
    ("make", "kind"),
    [(Path.mkdir, "a directory"), (_pipe, "a pipe"), (_piped, "a pipe"), (_device, "a device")],
)
@pytest.mark.parametrize(("name", "ending"), CASES)
def test_what_is_no_file_is_refused(
    name: str, ending: str, make: Callable[[Path], None], kind: str, tmp_path: Path
) -> None:
    path = tmp_path / f"given{ending}"
    make(path)
    with pytest.raises(InputError) as refused:
        READERS[name][0](path)
    assert refused.value.what == "this is not a file"
    assert refused.value.got == kind
    assert "given" in str(refused.value)


@pytest.mark.parametrize(("name", "ending"), CASES)
def test_names_that_no_file_can_have_are_refused(name: str, ending: str) -> None:
    with pytest.raises(InputError) as refused:
        READERS[name][0](Path(f"a\0b{ending}"))
    assert "embedded null" in str(refused.value) or "a\\x00b" in refused.value.got


def test_a_file_may_be_as_large_as_is_said_and_no_larger(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"12345")
    assert read_source_file(tmp_path / "file", "thing", 5) == b"12345"
    with pytest.raises(InputError, match="too large; got 5 bytes, expected at most 4"):
        read_source_file(tmp_path / "file", "thing", 4)
    with pytest.raises(InputError, match=r"does not exist\. Remedy: look elsewhere"):
        read_source_file(tmp_path / "none", "thing", 4, "look elsewhere")
