"""What was meant by a name that there is not: the nearest of those that there are."""

from __future__ import annotations

import difflib
import re
from collections.abc import Collection, Iterable, Iterator
from typing import Any, Final

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES, conversion

LEAST = 2
"""Letters of a name that is looked for within others, at least."""
CUTOFF = 0.6
"""Names as alike as this are taken for slips, in difflib's ratio."""
LONGEST = 60
"""Characters of a name that is looked at, and shown."""
MOST = 5000
"""Names that it is compared with, at most."""

ALIASES: Final[dict[str, tuple[str, ...]]] = {
    # units
    "metre": ("m",),
    "metres": ("m",),
    "meter": ("m",),
    "meters": ("m",),
    "millimetre": ("mm",),
    "millimetres": ("mm",),
    "millimeter": ("mm",),
    "millimeters": ("mm",),
    "centimetre": ("cm",),
    "centimetres": ("cm",),
    "centimeter": ("cm",),
    "centimeters": ("cm",),
    "inch": ("in",),
    "inches": ("in",),
    "foot": ("ft", "feet"),
    "feet": ("ft",),
    # tables of the design file
    "curve": ("target.f", "f"),
    "profile": ("target.f", "f"),
    "section": ("target.f", "f"),
    "targetf": ("target.f",),
    "spine": ("target.g", "g"),
    "path": ("target.g", "g"),
    "targetg": ("target.g",),
    "mesh": ("target.surface",),
    "size": ("target.fit",),
    "sizes": ("target.fit",),
    "load": ("load_case", "ground", "force"),
    "loads": ("load_case",),
    "boards": ("panel",),
    "gusset": ("gussets", "stiffeners"),
    "optimise": ("search",),
    "optimize": ("search",),
    "laser": ("workshop",),
    # families, materials and what holds shells
    "miura": ("flat-foldable",),
    "miuraori": ("flat-foldable",),
    "alu": ("aluminium",),
    "aluminum": ("aluminium",),
    "wood": ("birch plywood",),
    "pp": ("twin-wall polypropylene",),
    "textile": ("coated fabric",),
    "hinged": ("pinned",),
    "clamped": ("fixed",),
    "roller": ("sliding",),
    "eurocode": ("EN 1990",),
    # states and languages
    "deployed": ("target",),
    "open": ("target",),
    "folded": ("target",),
    "stowed": ("pack",),
    "english": ("en",),
    "german": ("de",),
    "deutsch": ("de",),
    # keys
    "breadth": ("width",),
    "velocity": ("speed",),
    "angle": ("xi_deg", "heading_deg", "fold_deg"),
    # formats, by programs that read them
    "gltf": ("glb",),
    "rhino": ("3dm",),
    "dwg": ("dxf",),
    "iges": ("step",),
    "abaqus": ("inp",),
    "calculix": ("inp",),
    "paraview": ("vtu",),
    # functions
    "ln": ("log",),
    "arcsin": ("asin",),
    "arccos": ("acos",),
    "arctan": ("atan",),
    "sen": ("sin",),
    "tg": ("tan",),
}
"""Words that people write for ours, without blanks, dots, dashes and capitals."""


def meant(word: str, known: Iterable[str]) -> tuple[str, ...]:
    """What may have been meant by a word, among known names: one of them, or several, or none.

    One that differs by capitals, dashes or blanks; one that is called otherwise elsewhere; those
    that begin with the word, or it with them; those that have it as a part; or one that is spelt
    nearly so.
    """
    names = tuple(dict.fromkeys(known))[:MOST]
    return plainly_meant(word, names) or spelt_nearly(word, names)


def plainly_meant(word: str, names: Collection[str]) -> tuple[str, ...]:
    """What is meant by a word as :func:`meant` finds it, slips of the pen left out."""
    sought = _bare(word[:LONGEST])
    bare = {name: _bare(name) for name in names}
    same = [name for name in names if bare[name] == sought]
    if same or not sought:
        return tuple(same[:1])
    heads = {name.partition(".")[0] for name in names}
    for name in ALIASES.get(sought, ()):
        if name in names or ("." in name and name.partition(".")[0] in heads):
            return (name,)
    if len(sought) < LEAST:
        return ()
    begun = [name for name in names if bare[name].startswith(sought)]
    begins = [name for name in names if len(bare[name]) > LEAST and sought.startswith(bare[name])]
    within = [name for name in names if len(sought) > LEAST and sought in bare[name]]
    return tuple((begun or sorted(begins, key=len)[-1:] or within)[:3])


def spelt_nearly(word: str, names: Iterable[str]) -> tuple[str, ...]:
    """The name that is spelt most nearly as a word, or none."""
    sought, bare = _bare(word[:LONGEST]), {_bare(name): name for name in names}
    turned = [each for each in bare if sorted(each) == sorted(sought)]  # letters changed places
    close = turned or difflib.get_close_matches(sought, bare, n=1, cutoff=CUTOFF)
    return tuple(bare[each] for each in close[:1])


def question(names: Collection[str]) -> str:
    """What to ask where these may have been meant; nothing if there is none."""
    *others, last = names or ("",)
    if not last:
        return ""
    return f"did you mean {' or '.join(filter(None, [', '.join(others), last]))}?"


def no_such(what: str, name: str, known: Collection[str], **facts: Any) -> InputError:
    """The error about a name that there is not.

    Parameters
    ----------
    what
        What is wrong, as in "there is no such task".
    name
        The name.
    known
        Those that there are.
    facts
        What else :class:`~orishell.conventions.errors.InputError` takes; with a remedy of its own
        nothing is asked.
    """
    expected = "one of " + ", ".join(known) if known else ""
    said = {
        "got": repr(name[:LONGEST]),
        "expected": expected,
        "remedy": question(meant(name, known)),
    }
    return InputError(what, **{**said, **facts})


_SEPARATORS = re.compile(r"[\s._\-]+")


def _bare(word: str) -> str:
    return _SEPARATORS.sub("", word.casefold())


_QUANTITY = re.compile(
    r"\s*([+-]?\d+(?:[.,]\d+)?)\s*(mm|cm|m|in|ft|\"|'|°|deg|%)\s*", re.IGNORECASE
)
_NUMBER = re.compile(r"[+-]?\d{1,20}(?:[.,]\d{0,20})?")
_RATIO = re.compile(r"\s*(\d+)\s*[:/]\s*(\d+)\s*")
_SIGNS: Final = {'"': "in", "'": "ft", "deg": "°"}


def number_meant(text: str, key: str, unit: str) -> str:
    """What to write for a number that is a text: without quotes, its unit or its decimal comma.

    Parameters
    ----------
    key
        Where it stands; what ends in ``_deg`` is in degrees.
    unit
        The design's unit of length; empty if it is not known.
    """
    if _NUMBER.fullmatch(text):
        return f"write {text.replace(',', '.')} without quotes"
    ratio, found = _RATIO.fullmatch(text), _QUANTITY.fullmatch(text)
    if ratio is not None and float(ratio[2]):
        return f"write {float(ratio[1]) / float(ratio[2]):.6g} without quotes"
    if found is None:
        return ""
    value, sign = float(found[1].replace(",", ".")), found[2].lower()
    sign, of_angle = _SIGNS.get(sign, sign), key.endswith("_deg")
    if sign == "%":
        value /= 100
    elif sign in MILLIMETRES and unit in MILLIMETRES and not of_angle:
        return f"write {value * conversion(sign, unit):.6g} without quotes: lengths are in {unit}"
    elif sign != "°" or not of_angle:
        return ""
    return f"write {value:.6g} without quotes"


def texts_in(expected: Iterable[str]) -> Iterator[str]:
    """The texts that are listed in quotes in what was expected."""
    for each in expected:
        yield from re.findall(r"'([^']+)'", each)
