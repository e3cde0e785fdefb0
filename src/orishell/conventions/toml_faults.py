"""What is wrong with a text that is no TOML, and what its author meant."""

from __future__ import annotations

import re
from collections.abc import Iterator

from orishell.conventions.errors import InputError
from orishell.conventions.meant import number_meant

LONGEST = 500
"""Characters of a line that is looked at for what was meant."""
WIDTH = 80
"""Characters of a line that a message shows."""
LOOKS_LIKE = {
    "{": "JSON: orishell check, fold and convert read FOLD files",
    "<": "HTML, XML or SVG: a design file is plain text, and names drawings",
    "PK": "an archive, or a file of an office program: a design file is plain text",
}
"""What is no TOML by how it begins."""
_PLACE = re.compile(r"\s*\(at line (\d+), column (\d+)\)")
_QUOTES = str.maketrans(dict.fromkeys("“”„‟«»", '"') | dict.fromkeys("‘’‚‛", "'"))
_KEY = r"[A-Za-z_][\w.-]*"
_LINE = re.compile(rf"\s*({_KEY})\s*(=|:=|==|:|\s)\s*(.*?)\s*$")
_HEADING = re.compile(rf"\s*(\[*)\s*({_KEY}(?:\s*[\s:/\\]\s*{_KEY})*)\s*(\]*)\s*:?\s*$")
_COMMENT = re.compile(r"\s*(?:#|//|--).*$")
_DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+")
_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_BARE_POINT = re.compile(r"([+-]?)(\d*)\.(\d*)")
_SPACED = re.compile(rf"\[\s*({_NUMBER}(?:\s+{_NUMBER})+)\s*\]")
_OPEN = re.compile(rf"({_NUMBER}(?:\s*(?:,\s|;|\.\.+|\bto\b)\s*{_NUMBER})+)")
_ROUND = re.compile(rf"\(\s*({_NUMBER}\s*,\s*{_NUMBER}(?:\s*,\s*{_NUMBER})*)\s*\)")
_WORD = re.compile(r"[A-Za-z][\w./-]*")
_FORMULA = re.compile(r"[\w\s.+*/^()\-]*[A-Za-z)][\w\s.+*/^()\-]*")
_YES = {
    "true": "true",
    "yes": "true",
    "on": "true",
    "false": "false",
    "no": "false",
    "off": "false",
}


def no_toml(text: str, said: str) -> InputError:
    """The error about a text that is no TOML, with the line that it is about.

    said: What the parser said.
    """
    place = _PLACE.search(said)
    message = _PLACE.sub("", said)
    message = message[:1].lower() + message[1:]
    head = text[:LONGEST].lstrip()
    looks = next((said for begin, said in LOOKS_LIKE.items() if head.startswith(begin)), "")
    if looks:
        return InputError("this is not TOML", remedy=f"this looks like {looks}")
    if place is None:
        remedy = "a bracket or a quote is opened and never closed" if "end of" in said else ""
        return InputError("this is not TOML", got=message, remedy=remedy)
    number, column = int(place[1]), int(place[2]) - 1
    line = text.split("\n")[number - 1].rstrip()
    remedy = ""
    if len(line) <= LONGEST:
        unit = re.search(r'(?m)^\s*unit\s*=\s*"(\w+)"', text)
        remedy = next(_remedies(line, message, unit[1] if unit else ""), "")
    begin = max(0, column - WIDTH // 2)
    shown = "".join(each if each.isprintable() else " " for each in line[begin : begin + WIDTH])
    return InputError(
        "this is not TOML",
        where=f"line {number}",
        got="" if remedy else message,
        remedy=remedy,
        detail=f"    {shown}\n    {' ' * (column - begin)}^",
    )


def _remedies(line: str, said: str, unit: str) -> Iterator[str]:
    """What may be meant by a line, the likeliest first."""
    straight = line.translate(_QUOTES)
    if straight != line:
        yield f"write straight quotes: {straight.strip()}"
    if "\\" in line and '"' in line:
        path = re.search(r'"([^"]*\\[^"]*)"?', line)
        if path is not None:
            yield (
                "a backslash in double quotes has a meaning of its own: write "
                f"'{path[1]}' in single quotes, or {path[1].replace(chr(92), '/')}"
            )
    heading = _HEADING.match(line)
    if heading is not None and (heading[1] or line.rstrip().endswith(":")):
        name = re.sub(r"[\s:/\\]+", ".", heading[2])
        yield f"write {f'[[{name}]]' if len(heading[1]) > 1 else f'[{name}]'}"
    found = _LINE.match(line)
    if found is None:
        return
    key, sign, value = found[1], found[2].strip(), found[3]
    if "overwrite" in said:
        yield f"{key} is given twice in this table, or is a table already: keep one of them"
    bare = _COMMENT.sub("", value).rstrip() if '"' not in value and "'" not in value else value
    if bare != value and "#" not in value:
        yield f"comments begin with #: {key} = {bare}  #{value[len(bare) :].strip(' /-')}"
    if sign != "=" and value:
        word, equals, rest = value.partition("=")
        if sign or not re.search(r"\s", value):
            yield f"write {key} = {value}"
        elif equals:
            yield f"a key is one word: {key}_{word.strip()} = {rest.strip()}"
        return
    yield from _of_value(key, bare, unit)


def _of_value(key: str, value: str, unit: str) -> Iterator[str]:
    """What may be meant by a value."""
    if not value:
        yield f"a value is missing: write it behind {key} ="
    if value.endswith((";", ",")):
        yield f"write {key} = {value.rstrip(';, ')}, without what follows it"
    if _DECIMAL_COMMA.fullmatch(value):
        yield f"numbers have a decimal point: write {value.replace(',', '.')}"
    if point := _BARE_POINT.fullmatch(value):
        yield f"write {point[1]}{point[2] or 0}.{point[3] or 0}"
    listed = _SPACED.fullmatch(value) or _ROUND.fullmatch(value) or _OPEN.fullmatch(value)
    if listed is not None:
        numbers = re.findall(_NUMBER, re.sub(r"\.\.+|,|;|\bto\b", " ", listed[1]))
        yield f"lists have square brackets, and commas between entries: [{', '.join(numbers)}]"
    if value.casefold() in _YES and value not in _YES.values():
        yield f"write {_YES[value.casefold()]}"
    if said := number_meant(value, key, unit):
        yield said.replace(" without quotes", ", without a unit").replace(",:", ":")
    if value.count('"') % 2:
        yield "close the quotes"
    if _WORD.fullmatch(value) or _FORMULA.fullmatch(value):
        yield f'put texts in quotes: "{value}"'
