"""Formulas as people write them, turned into what the parser reads: signs, and "y =" in front.

Only what has one meaning is taken: everything else is refused by the parser, with what to write.
"""

from __future__ import annotations

import re
from typing import Final

from orishell.conventions.meant import meant, question
from orishell.conventions.record import record

SIGNS: Final = {
    **dict.fromkeys("×·⋅∙∗", "*"),
    **dict.fromkeys("−–", "-"),
    "÷": "/",
    "π": "pi",
    "^": "**",
}
"""Signs, and what they stand for."""
_RAISED: Final = {raised: str(digit) for digit, raised in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")} | {"⁻": "-"}
ALLOWED: Final = frozenset({*SIGNS, *_RAISED, *" .+-*/(),_"})
"""What may stand in a formula beside letters and digits."""
HEAD = re.compile(r"\s*([A-Za-z])\s*(?:\(([A-Za-z\s,]{1,9})\))?\s*=(?!=)")
DECIMAL_COMMA = re.compile(r"\d+(,)\d+")
_SAID: Final = tuple(
    (re.compile(pattern), said)
    for pattern, said in (
        (
            r"\b(a?sin|a?cos|a?tan)\s*(?:\^|\*\*|(?=[⁰¹²³⁴⁵⁶⁷⁸⁹]))",
            "write powers behind the argument, as in {0}(x)**2",
        ),
        (r"\b(?:math|np|numpy|Math)\.(\w+)", "write {0}, without what stands before it"),
        (
            r"\b(a?sin|a?cos|a?tan|sinh|cosh|tanh|exp|log|sqrt|abs)\s+([A-Za-zπ\d]\w*)",
            "write {0}({1})",
        ),
        (r"\|", "write abs(x) for the size of x"),
        (r"√", "write sqrt(x) for the root of x"),
        (
            r"(?<![A-Za-z\d.])(\d+\.?\d*)\s*([A-Za-zπ]\w*|\()|(\))\s*([A-Za-zπ\d]\w*|\()",
            "write products with *: {0}*{1}",
        ),
    )
)
"""What formulas have that are none, and what to write instead, the first that fits."""


@record
class Plain:
    """A formula in the signs that the parser reads."""

    text: str
    columns: tuple[int, ...]  # where each of its characters stands in what was written
    head: str  # what it is said to give, as "y" of "y = x**2"; empty if nothing is said
    of: tuple[str, ...]  # the variables that are named with it, as "x" of "f(x) ="

    def column(self, place: int) -> int:
        """Where a place of the text stands in what was written."""
        end = self.columns[-1] + 1 if self.columns else 0
        return self.columns[place] if 0 <= place < len(self.columns) else end


def plainly(text: str) -> Plain:
    """A formula with other signs for what is written otherwise, and without what it gives."""
    found = HEAD.match(text)
    begin = 0 if found is None else found.end()
    written: list[str] = []
    columns: list[int] = []
    raised = False
    for column in range(begin, len(text)):
        sign = text[column]
        said = SIGNS.get(sign, sign)
        if sign in _RAISED:
            said = _RAISED[sign] if raised else f"**{_RAISED[sign]}"
        raised = sign in _RAISED
        written.append(said)
        columns += [column] * len(said)
    head = "" if found is None else found[1]
    of = tuple(re.findall(r"[A-Za-z]", found[2] or "")) if found is not None else ()
    return Plain("".join(written), tuple(columns), head, of)


def mended(text: str) -> tuple[str, int | None]:
    """What to write in place of a formula that is none, and the place that it is about."""
    for pattern, said in _SAID:
        if found := pattern.search(text):
            words = said.format(*(each for each in found.groups() if each is not None))
            return words, found.start()
    return "write products with *, as in 2*x, and arguments in parentheses, as in sin(x)", None


def name_meant(name: str, names: tuple[str, ...]) -> str:
    """What to ask where a name is not known: x2 is x squared, or twice x."""
    found = re.fullmatch(r"([A-Za-z])(\d+)", name)
    if found is not None:
        return question((f"{found[1]}**{found[2]}", f"{found[2]}*{found[1]}"))
    if name in ("log10", "lg"):
        return "write log(x)/log(10): log is the natural logarithm"
    return question(meant(name, names))
