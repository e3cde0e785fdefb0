"""The picture in docs/architecture.md is of the program as it is."""

from __future__ import annotations

import os
import re

from architecture_picture import (
    PACKAGE,
    PICTURE,
    ROOT,
    draw_architecture,
    read_imports,
    read_layers,
    read_packages,
    upward,
)

MOST_PACKAGES = 23
"""Nobody keeps more than these in mind.

How a shell travels and what holds it, ``deployment``, what its panels are as boards, ``solids``,
and whether it stands, ``structure``, are subjects of their own. They ask the motion, and nothing
of families, proof or files. So is ``search``, which of a design's variants is best: it asks shells.
"""


def test_the_picture_is_of_the_program_as_it_is() -> None:
    drawn = draw_architecture()
    if os.environ.get("ORISHELL_WRITE_GOLDEN"):
        PICTURE.write_text(drawn, encoding="utf-8")
    assert PICTURE.read_text(encoding="utf-8") == drawn


def test_every_package_has_a_layer_and_every_arrow_leads_down() -> None:
    layers = read_layers()
    packages = [package for row in layers for package in row]
    assert sorted(packages) == sorted(read_packages())
    assert len(packages) <= MOST_PACKAGES
    assert not upward(layers, read_imports())


def test_what_the_page_names_exists() -> None:
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    for name in re.findall(r"`(?!tests|frontend|docs|blender)(\w+/[\w/]*)`", text):
        place = PACKAGE / name
        assert place.exists() or place.with_suffix(".py").exists(), name
    for name in re.findall(r"`((?:tests|frontend|docs|blender)/[\w/.-]+)`", text):
        assert (ROOT / name).exists(), name
