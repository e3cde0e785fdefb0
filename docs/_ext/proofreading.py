"""Reads what people read: words are spelled, and rows of a table have the cells of its head.

`make docs` begins with it, ``python docs/_ext/proofreading.py``. Words are those of the dictionary
that spylls brings, American English, and of docs/words.txt: names, terms and British spellings.
"""

from __future__ import annotations

import gc
import re
import sys
import warnings
from collections.abc import Collection, Iterator
from pathlib import Path

from spylls.hunspell import Dictionary

ROOT = Path(__file__).parents[2]
WORDS = ROOT / "docs" / "words.txt"
SAID = ("src/orishell/studio/words.toml", "src/orishell/workshop/kit/booklet.en.toml")
"""What the pages of the studio and the booklet say."""
LETTER = "[A-Za-zÀ-ÖØ-öø-ÿ]"
WORD = re.compile(rf"(?<![\w\\]){LETTER}(?:{LETTER}|['’](?={LETTER}))+(?!\w)")
"""Two Latin letters at least, no digit or underscore in it or beside it."""
NO_PROSE = (
    r"(?ms)^(```+|~~~+)[^\n]*\n.*?^\1",  # code
    r"(?s)\$\$.*?\$\$",
    r"\$[^$\n]*\$",
    r"``[^`]*``",
    r"`[^`]*`",
    r"\]\([^)]*\)|<?https?://\S+",  # addresses
    r"(?m)^:::.*$|^\.\. .*$|:\w+:",  # directives
    r"\{[^}\n]*\}",  # roles, and places that are filled in
)

Fault = tuple[int, str]
"""A line, and what is wrong there."""


def english() -> Dictionary:
    """The dictionary; spylls leaves its file to be closed by whoever collects it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResourceWarning)
        found = Dictionary.from_files("en_US")
        gc.collect()
    return found


def pages() -> list[Path]:
    """All pages that people write, not those that the gallery makes of scripts."""
    own = [path for path in (ROOT / "docs").rglob("*.md") if "gallery" not in path.parts]
    return sorted(
        [*own, *(ROOT / f"{name}.md" for name in ("README", "CONTRIBUTING", "CHANGELOG"))]
    )


def prose(path: Path) -> str:
    """What is to be read in a file, on its lines."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".toml":
        lines = (re.findall(r'"((?:[^"\\]|\\.)*)"', line) for line in text.splitlines())
        text = "\n".join(", ".join(each) for each in lines)
    elif path.suffix == ".py":
        text = "\n".join(line.removeprefix("#") for line in comments(text))
    for pattern in NO_PROSE:
        text = re.sub(pattern, lambda match: "\n" * match[0].count("\n") or " ", text)
    return text


def comments(text: str) -> Iterator[str]:
    """The lines of a script of the gallery that its page shows as text; others are empty."""
    inside = False
    for line in text.splitlines():
        edge = line.count('"""') == 1
        yield line if inside or edge or line.startswith("# ") else ""
        inside ^= edge


def unknown(text: str, known: Collection[str], dictionary: Dictionary) -> Iterator[Fault]:
    """Words that nobody knows, and words that stand twice."""
    checked: dict[str, bool] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        for match in WORD.finditer(line):
            word = re.sub(r"['’]s?$", "", match[0].replace("’", "'")).removesuffix("'s")
            if word not in checked:
                checked[word] = word in known or lowered(word) in known or dictionary.lookup(word)
            if not checked[word]:
                yield number, f"“{word}” is no word; if it is one, add it to docs/words.txt"
        if twice := re.search(r"\b([^\W\d_]{2,}) \1\b", line):
            yield number, f"“{twice[1]}” stands twice"


def lowered(word: str) -> str:
    """A word as it is within a sentence."""
    return word[0].lower() + word[1:]


def uneven(text: str) -> Iterator[Fault]:
    """Rows of tables that have more or fewer cells than the first one."""
    head = 0
    for number, line in enumerate(text.splitlines(), start=1):
        row = line.strip()
        cells = len(re.findall(r"(?<!\\)\|", row)) - 1 if row.startswith("|") else 0
        head = (head or cells) if cells else 0
        if cells != head:
            yield number, f"{cells} cells in a table of {head}"


def faults() -> Iterator[str]:
    """What is wrong, each with its file and line."""
    dictionary = english()
    lines = WORDS.read_text(encoding="utf-8").splitlines()
    known = {line for line in lines if line and not line.startswith("#")}
    scripts = sorted((ROOT / "examples" / "gallery").glob("plot_*.py"))
    for path in [*pages(), *scripts, *(ROOT / name for name in SAID)]:
        text = prose(path)
        found = [*unknown(text, known, dictionary)]
        if path.suffix == ".md":
            found += uneven(path.read_text(encoding="utf-8"))
        for number, wrong in sorted(found):
            yield f"{path.relative_to(ROOT)}:{number}: {wrong}"


if __name__ == "__main__":
    sys.exit("\n".join(faults()) or 0)
