"""What style sheets in an SVG file say of the look of its elements, as in a browser.

Of rules for media those for screens are read; no sheet outside the file is.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from orishell.conventions.errors import InputError
from orishell.curves.svg.parsed import read_tree
from orishell.curves.svg.tree import (
    MAX_ELEMENTS,
    Declarations,
    Element,
    cascaded,
    declarations,
    nested,
)

if TYPE_CHECKING:
    from cssselect2 import Matcher

MOST_TESTS = 5_000_000
"""How often the selectors of a file may be compared with its elements."""
MOST_SIBLINGS = 500
"""How many elements may stand beside each other where selectors count them."""
SHOWN_MEDIA = frozenset({"", "all", "screen"})
UNPAINTED = frozenset({"", "none", "transparent"})
_COUNTING = re.compile(r"~(?!=)|:(nth|last|only|has)")
_ZERO = re.compile(r"[+-]?(?:0+\.?0*|\.0+)(?:[a-z]+|%)?")


def read_styled(path: Path, most: int = MAX_ELEMENTS) -> Element:
    """An SVG file's outermost element, with what style sheets say of each; it may have so many.

    Raises InputError: If the file cannot be read, is not SVG, or has too many rules.
    """
    from cssselect2 import ElementWrapper

    root = read_tree(path, most)
    try:
        matcher = _matcher(root)
    except RecursionError:
        raise nested().located("<style>") from None
    if matcher is None:
        return root
    known: dict[tuple[int, ...], Declarations] = {}
    wrapped = ElementWrapper.from_xml_root(_plain(root)).iter_subtree()
    for element, wrapper in zip(root.all(), wrapped, strict=True):
        found = [declared for *_, pseudo, declared in matcher.match(wrapper) if pseudo is None]
        if found:
            element.sheet = known.setdefault(tuple(map(id, found)), cascaded(found))
    return root


def _matcher(root: Element) -> Matcher | None:
    """The selectors of style sheets, each with what it declares; None if there are none."""
    import cssselect2
    import tinycss2

    matcher, spent = cssselect2.Matcher(), [0]
    for sheet in root.all():
        if sheet.tag != "style":
            continue
        for rule in _rules(tinycss2.parse_stylesheet(sheet.text, True, True)):
            declared = declarations(rule.content)
            try:
                selectors = cssselect2.compile_selector_list(rule.prelude)
            except cssselect2.SelectorError:  # a browser passes over the rule as well
                continue
            _require_few_siblings(root, tinycss2.serialize(rule.prelude))
            for selector in selectors:
                selector.test = _counted(selector.test, spent)
                matcher.add_selector(selector, declared)
    return matcher if matcher.order else None


def _rules(nodes: Iterable[Any]) -> Iterator[Any]:
    """The rules of a sheet, those for screens as well."""
    import tinycss2

    for node in nodes:
        if node.type == "qualified-rule":
            yield node
            continue
        media = node.type == "at-rule" and node.lower_at_keyword == "media"
        if media and tinycss2.serialize(node.prelude).strip().lower() in SHOWN_MEDIA:
            yield from _rules(tinycss2.parse_rule_list(node.content or [], True, True))


def _require_few_siblings(root: Element, selector: str) -> None:
    if _COUNTING.search(selector) is None:
        return
    most = max(len(each.children) for each in root.all())
    if most > MOST_SIBLINGS:
        raise _too_much(f"{selector.strip()[:40]}, which counts {most} siblings")


def _counted(test: Callable[[Any], bool], spent: list[int]) -> Callable[[Any], bool]:
    def tested(element: Any) -> bool:
        spent[0] += 1
        if spent[0] > MOST_TESTS:
            raise _too_much(f"more than {MOST_TESTS} comparisons of rules with elements")
        return test(element)

    return tested


def _too_much(got: str) -> InputError:
    return InputError(
        "its style sheets take too long to apply",
        where="<style>",
        got=got,
        remedy="save it with presentation attributes in place of a style sheet",
    )


def _plain(root: Element) -> ElementTree.Element:
    """The elements as the library wants them."""
    made = ElementTree.Element(root.tag, root.attributes)
    stack = [(root, made)]
    while stack:
        element, parent = stack.pop()
        stack += [
            (child, ElementTree.SubElement(parent, child.tag, child.attributes))
            for child in element.children
        ]
    return made


def inherited(name: str, line: tuple[Element, ...]) -> str:
    """A property of the last of elements within each other; empty if it is not set.

    If it has none of its own it has that of what it is in.
    """
    values = (element.style(name) for element in reversed(line))
    return next((each for each in values if each not in {"", "inherit"}), "")


def is_painted(kind: str, line: tuple[Element, ...]) -> bool:
    """Whether the last of elements within each other has a stroke, or a fill, that is seen.

    Parameters
    ----------
    kind
        "stroke" or "fill".
    """
    paint = inherited(kind, line) or ("black" if kind == "fill" else "")
    shares = [inherited(f"{kind}-opacity", line), *(each.style("opacity") for each in line)]
    if kind == "stroke":
        shares.append(inherited("stroke-width", line))
    return paint not in UNPAINTED and not any(each and _ZERO.fullmatch(each) for each in shares)
