"""What pyproject.toml asks for, as ``pip install -r`` takes it; ``.ci/least`` calls it.

``python tests/least_versions.py least studio ...`` prints the least versions of what the package
and some of its extras need, ``newest`` any that are allowed, and ``pythons`` the versions of Python
that it is said to run with. Nothing of the package is needed for it.
"""

from __future__ import annotations

import re
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
NEEDED = re.compile(r"(?P<name>[\w.-]+)(?:\[(?P<extras>[\w,-]+)\])?(?:>=(?P<least>[\d.]+))?")
PYTHON = "Programming Language :: Python :: "


def project() -> dict[str, Any]:
    """The table [project] of pyproject.toml."""
    found: dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    return found


def needed(extras: list[str], *, least: bool) -> Iterator[str]:
    """A line for each package that the project and some of its extras need."""
    about = project()
    optional = about["optional-dependencies"]
    left = [*about["dependencies"], *(each for extra in extras for each in optional[extra])]
    for text in left:  # which grows
        found = NEEDED.fullmatch(text)
        if found is None:
            raise SystemExit(f"pyproject.toml: {text!r} has no least version that is understood")
        if found["name"] == about["name"]:
            left += [each for extra in found["extras"].split(",") for each in optional[extra]]
        elif least and found["least"]:
            yield f"{found['name']}=={found['least']}"
        else:
            yield text


def pythons() -> list[str]:
    """Versions of Python, the oldest first, as the classifiers say them."""
    return [
        each.removeprefix(PYTHON) for each in project()["classifiers"] if each.startswith(PYTHON)
    ]


def main() -> None:
    """Print what is asked for, a line each."""
    asked, *extras = sys.argv[1:]
    lines = pythons() if asked == "pythons" else needed(extras, least=asked == "least")
    sys.stdout.write("".join(f"{line}\n" for line in dict.fromkeys(lines)))


if __name__ == "__main__":
    main()
