"""What tests of shells leave out that they do not look at."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from orishell.shell import export


@pytest.fixture
def unpictured() -> Iterator[None]:
    """No pictures are drawn, which take more time than a small shell does."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(export, "draw_pictures", lambda *_, **__: None)
        yield
