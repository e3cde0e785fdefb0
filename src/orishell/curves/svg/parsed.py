"""The elements of an SVG file, read so that no file can do harm.

Entities are refused but for plain texts, and nothing outside the file is fetched; size, number and
depth of the elements are bounded.
"""

from __future__ import annotations

from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.curves.files import read_source, require_kind
from orishell.curves.svg.tree import MAX_ELEMENTS, Element

SAVE_AGAIN = "open it in a drawing program, and save it again as plain SVG"
BYTES = 100
"""What a file may have for every element that it may have."""
MAX_DEPTH = 200
MOST_EXPANDED = 1_000_000
"""Characters that references to an entity may stand for in all."""

SVG = "http://www.w3.org/2000/svg"
LINKED = {
    "http://www.w3.org/1999/xlink href": "href",
    "http://www.inkscape.org/namespaces/inkscape label": "label",
}
"""Attributes with a namespace that are read, and what they are called then."""


def read_tree(path: Path, most: int = MAX_ELEMENTS) -> Element:
    """An SVG file's outermost element; it may have so many in all.

    Raises InputError: If the file cannot be read, or is not SVG.
    """
    from xml.parsers import expat

    content = read_source(path, "SVG file", BYTES * most)
    require_kind(content, "SVG")
    parser = expat.ParserCreate(namespace_separator=" ")
    builder = _Builder(most)
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.text
    parser.EntityDeclHandler = _Entities(content).declared
    parser.buffer_text = True
    try:
        parser.Parse(content, True)
    except expat.ExpatError as error:
        raise InputError("this is not XML", got=str(error), remedy=SAVE_AGAIN) from None
    except (ValueError, LookupError) as error:  # an unknown encoding
        raise InputError("the SVG file cannot be read", got=str(error), remedy=SAVE_AGAIN) from None
    if builder.root is None or builder.root.tag != "svg":
        raise InputError(
            "this is not SVG", expected="the outermost element <svg>", remedy=SAVE_AGAIN
        )
    return builder.root


class _Builder:
    """Puts the elements together as the parser meets them."""

    def __init__(self, most: int) -> None:
        self.most = most
        self.root: Element | None = None
        self.open: list[Element] = []
        self.count = 0

    def start(self, name: str, attributes: dict[str, str]) -> None:
        self.count += 1
        if self.count > self.most:
            raise InputError(
                "the file has too many elements",
                expected=f"at most {self.most}",
                remedy="copy what is meant into a file of its own",
            )
        if len(self.open) >= MAX_DEPTH:
            raise InputError(
                "the elements are nested too deeply",
                expected=f"at most {MAX_DEPTH} levels",
                remedy="ungroup them in the drawing program",
            )
        space, _, tag = name.rpartition(" ")
        own = attributes
        if any(" " in key for key in attributes):
            own = {key: value for key, value in attributes.items() if " " not in key}
            for key, known in LINKED.items():
                if key in attributes:
                    own.setdefault(known, attributes[key])
        element = Element(tag if space in {"", SVG} else "", own)
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.root = element
        self.open.append(element)

    def text(self, text: str) -> None:
        if self.open[-1].tag == "style":
            self.open[-1].text += text

    def end(self, _: str) -> None:
        self.open.pop()


class _Entities:
    """Names for plain texts, as Illustrator declares them; all other entities are refused.

    No text holds another's name, so that what all stand for is bounded by how many are used.
    """

    def __init__(self, content: bytes) -> None:
        self.uses = content.count(b"&")

    def declared(self, name: str, is_parameter: bool, text: str | None, *_: object) -> None:
        """Refuse it if it is no such name."""
        short = text is not None and "&" not in text and "%" not in text
        if not short or is_parameter or self.uses * len(text or "") > MOST_EXPANDED:
            raise InputError(
                "the file declares entities",
                got=f"<!ENTITY {name[:40]} ...>",
                remedy="save it as plain SVG (in Illustrator without its editing capabilities)",
            )
