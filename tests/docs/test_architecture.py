"""The picture in docs/architecture.md is of the house as it is."""

from __future__ import annotations

import os
import re

from house_picture import (
    PACKAGE,
    PICTURE,
    ROOT,
    draw_house,
    read_floors,
    read_imports,
    read_rooms,
    upward,
)

MOST_ROOMS = 23
"""More than these nobody keeps in mind.

How a shell travels and what holds it, ``deployment``, what its panels are as boards, ``solids``,
and whether it stands, ``structure``, are subjects of their own. They ask the motion, and nothing
of families, proof or files. So is ``search``, which of a design's variants is best: it asks shells.
"""


def test_the_picture_is_of_the_house_as_it_is() -> None:
    drawn = draw_house()
    if os.environ.get("ORISHELL_WRITE_GOLDEN"):
        PICTURE.write_text(drawn, encoding="utf-8")
    assert PICTURE.read_text(encoding="utf-8") == drawn


def test_every_room_has_a_floor_and_every_arrow_leads_down() -> None:
    floors = read_floors()
    rooms = [room for row in floors for room in row]
    assert sorted(rooms) == sorted(read_rooms())
    assert len(rooms) <= MOST_ROOMS
    assert not upward(floors, read_imports())


def test_what_the_page_names_exists() -> None:
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    for name in re.findall(r"`(?!tests|frontend|docs)(\w+/[\w/]*)`", text):
        place = PACKAGE / name
        assert place.exists() or place.with_suffix(".py").exists(), name
    for name in re.findall(r"`((?:tests|frontend|docs)/[\w/.-]+)`", text):
        assert (ROOT / name).exists(), name
