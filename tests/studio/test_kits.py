"""The kit in the studio: its booklet as pictures, and all of it in one archive."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from pypdf import PdfReader

from orishell.conventions.errors import InputError
from orishell.conventions.progress import no_progress
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import check_design, starter_file
from orishell.shell import make_shell, write_kit
from orishell.studio import tasks
from orishell.studio.tasks import answer
from orishell.workshop import tiling


def asked(task: str, workshop: dict[str, Any] | None = None, **more: Any) -> Any:
    """What is answered for a small sheet."""
    return answer(task, {"design": tables(workshop), "name": "awning", **more}, no_progress)


def tables(workshop: dict[str, Any] | None = None) -> dict[str, Any]:
    design = parse_toml(starter_file("orthodiagonal"))
    design["pattern"] |= {"rows": 5, "columns": 5}
    return {**design, "workshop": workshop or {}}


def words_of(picture: str) -> list[str]:
    root = ElementTree.fromstring(picture)
    return [text.text or "" for text in root.iter("{http://www.w3.org/2000/svg}text")]


def files_in(archive: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(archive)) as packed:
        return {name: packed.read(name) for name in packed.namelist()}


@pytest.mark.parametrize("name", ["kit", "card"])
def test_an_archive_has_the_files_of_the_command_line_and_the_booklet_that_is_shown(
    name: str, tmp_path: Path
) -> None:
    title, archive = asked("export", format=name)
    assert title == f"awning-{name}.zip"
    shell = make_shell(check_design(tables(), Path("awning.toml")))
    kit = write_kit(shell, tmp_path, paper=name == "card")
    written = {path.relative_to(tmp_path).as_posix(): path.read_bytes() for path in kit.files}
    assert files_in(archive) == written
    # Nothing in it tells when it was made, so that the same design has the same bytes.
    assert asked("export", format=name)[1] == archive
    with zipfile.ZipFile(io.BytesIO(archive)) as packed:
        assert {each.date_time for each in packed.infolist()} == {(1980, 1, 1, 0, 0, 0)}
    shown = asked("booklet", format=name)["pages"]
    booklet = PdfReader(io.BytesIO(written["booklet/booklet.pdf"])).pages
    assert [sorted(page.extract_text().split()) for page in booklet] == [
        sorted(" ".join(words_of(page["svg"])).split()) for page in shown
    ]
    assert shown[0]["title"] == "awning"


def test_another_language_or_paper_takes_no_second_proof(monkeypatch: pytest.MonkeyPatch) -> None:
    english = asked("booklet")
    monkeypatch.delattr(tasks, "make_shell")  # whoever asks for another shell fails
    german = asked("booklet", {"language": "de"})
    assert len(german["pages"]) == len(english["pages"])
    assert [page["title"] for page in german["pages"][1:]] != [
        page["title"] for page in english["pages"][1:]
    ]
    for scale in (0.02, 0.04):
        card = asked("booklet", {"paper_scale": scale}, format="card")["pages"][0]
        assert f"Card model, 1:{1 / scale:g} of the shell" in words_of(card["svg"])


def test_a_card_model_of_too_many_pages_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tiling, "MOST_PAGES", 10)
    for task in ("booklet", "export"):
        with pytest.raises(InputError, match="needs more than 10 pages") as caught:
            asked(task, {"paper_scale": 1.0}, format="card")
        assert caught.value.keys == ("workshop.paper_scale",)


def test_the_booklet_that_is_shown_alone_is_the_one_that_is_written_alone() -> None:
    title, content = asked("export", format="booklet")
    assert title == "awning-booklet.pdf"
    pages = PdfReader(io.BytesIO(content)).pages
    shown = asked("booklet", format="booklet")["pages"]
    assert [sorted(page.extract_text().split()) for page in pages] == [
        sorted(" ".join(words_of(page["svg"])).split()) for page in shown
    ]
