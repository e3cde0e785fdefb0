"""The shells of the paper's figures, one of every family, as the program writes them."""

from __future__ import annotations

from pathlib import Path

import pytest

from orishell.io import write_fold
from orishell.shell.make import design_shell

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="session", params=["figure1", "figure2", "figure3"])
def shell_files(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A directory with the ``shell.fold`` of a figure, from its design file."""
    directory = tmp_path_factory.mktemp(request.param)
    shell = design_shell(EXAMPLES / f"{request.param}.toml")
    write_fold(directory / "shell.fold", shell.document)
    return directory
