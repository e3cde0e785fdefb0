"""What names of layers stand for, as people and programs write them."""

from __future__ import annotations

import pytest

from orishell.io.patterns.line_styles import AUXILIARY, IGNORED, letter_of_layer


@pytest.mark.parametrize(
    ("name", "letter"),
    [
        *((name, "M") for name in ("mountain", "MOUNTAINS", "01_Mountain folds", "mountain-2")),
        # joined, as ORIPA and Oriedita name their layers
        *(("MountainLine", "M"), ("ValleyLine", "V"), ("CutLine", "C"), ("valleyFolds", "V")),
        *((name, IGNORED) for name in ("labels", "TextLayer", "Labels")),
        *((name, AUXILIARY) for name in ("noname", "AuxLine", "Construction lines", "Guides")),
        *((name, None) for name in ("", "Layer 1", "haircuts", "name", "mountaineer")),
    ],
)
def test_words_of_a_layer(name: str, letter: str | None) -> None:
    assert letter_of_layer(name) == letter
