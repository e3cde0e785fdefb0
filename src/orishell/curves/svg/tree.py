"""The elements of an SVG file, read so that no file can do harm.

Entities are refused and nothing outside the file is fetched; size, number and depth of the elements
are bounded.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.curves.files import read_source

MAX_ELEMENTS = 200_000
MAX_DEPTH = 200

SVG = "http://www.w3.org/2000/svg"
XLINK = "http://www.w3.org/1999/xlink"


@dataclass(slots=True, eq=False)
class Element:
    """An element.

    Parameters
    ----------
    tag
        Its name; empty if it is not of SVG's namespace.
    attributes
        Attributes without a namespace, and ``xlink:href`` as ``href`` if there is no other.
    children
        The elements inside.
    """

    tag: str
    attributes: dict[str, str]
    children: list[Element] = field(default_factory=list)

    def style(self, name: str) -> str:
        """A property, from ``style`` or from the attribute; empty if it is not set."""
        for declaration in self.attributes.get("style", "").split(";"):
            key, _, value = declaration.partition(":")
            if key.strip() == name:
                return value.strip()
        return self.attributes.get(name, "").strip()


def read_tree(path: Path) -> Element:
    """Read an SVG file's outermost element.

    Raises
    ------
    InputError
        If the file is missing, too large, not XML, not SVG, or declares entities.
    """
    from xml.parsers import expat

    content = read_source(path, "SVG file")
    parser = expat.ParserCreate(namespace_separator=" ")
    builder = _Builder()
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.EntityDeclHandler = _refuse_entity
    parser.buffer_text = True
    try:
        parser.Parse(content, True)
    except expat.ExpatError as error:
        raise InputError("this is not XML", got=str(error)) from None
    except (ValueError, LookupError) as error:  # an unknown encoding
        raise InputError("the SVG file cannot be read", got=str(error)) from None
    if builder.root is None or builder.root.tag != "svg":
        raise InputError("this is not SVG", expected="the outermost element <svg>")
    return builder.root


class _Builder:
    """Puts the elements together as the parser meets them."""

    def __init__(self) -> None:
        self.root: Element | None = None
        self.open: list[Element] = []
        self.count = 0

    def start(self, name: str, attributes: dict[str, str]) -> None:
        self.count += 1
        if self.count > MAX_ELEMENTS:
            raise InputError("the file has too many elements", expected=f"at most {MAX_ELEMENTS}")
        if len(self.open) >= MAX_DEPTH:
            raise InputError(
                "the elements are nested too deeply", expected=f"at most {MAX_DEPTH} levels"
            )
        space, _, tag = name.rpartition(" ")
        own = {key: value for key, value in attributes.items() if " " not in key}
        link = attributes.get(f"{XLINK} href")
        if link is not None:
            own.setdefault("href", link)
        element = Element(tag if space in {"", SVG} else "", own)
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.root = element
        self.open.append(element)

    def end(self, _: str) -> None:
        self.open.pop()


def _refuse_entity(name: str, *_: object) -> None:
    raise InputError(
        "the file declares entities",
        got=f"<!ENTITY {name[:40]} ...>",
        remedy="save it as plain SVG",
    )
