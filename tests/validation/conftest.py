"""The shells of the paper's figures, one of every family, as the program writes them."""

from __future__ import annotations

from pathlib import Path

import pytest

from orishell.design_file import read_design_file
from orishell.io import write_fold
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="session", params=["figure1", "figure2", "figure3"])
def shell_files(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A directory with the ``shell.fold`` of a figure, from its design file."""
    directory = tmp_path_factory.mktemp(request.param)
    file = read_design_file(EXAMPLES / f"{request.param}.toml")
    shell = make_shell(file, skip=(*MEASURES, "verification", "stock"))
    write_fold(directory / "shell.fold", shell.document)
    return directory
