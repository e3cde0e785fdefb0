"""What the page of limits says is what the modules say of themselves, and nothing else.

A limit stands where it has its cause: a paragraph "Limit: ..." of a module's docstring. Whoever
takes the cause away sees the sentence there, and this test asks that the page loses it, too.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from docs.test_terms import pages
from orishell.structure.settings import StructureTable

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def plain(text: str) -> str:
    """A sentence without marks and links, as it is within a line."""
    text = re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"\s+", " ", text.replace("`", "")).strip()
    return text[0].lower() + text[1:]


def limits_of_modules() -> dict[str, str]:
    """Every limit, with the module that has it."""
    found = {}
    for path in sorted((ROOT / "src" / "orishell").rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        if "Limit: " not in text:
            continue
        for paragraph in (ast.get_docstring(ast.parse(text)) or "").split("\n\n"):
            if paragraph.startswith("Limit: "):
                found[plain(paragraph.removeprefix("Limit: "))] = str(path.relative_to(ROOT))
    return found


def limits_of_page() -> set[str]:
    section = (ROOT / "docs" / "limits.md").read_text(encoding="utf-8").split("\n\n")[-1]
    return {plain(each) for each in re.split(r"^- ", section, flags=re.MULTILINE)[1:]}


def test_limits_of_the_page_are_those_of_the_modules() -> None:
    ours = limits_of_modules()
    assert len(ours) > 5
    assert not (gone := limits_of_page() - ours.keys()), f"no module says so: {gone}"
    missing = {module: text for text, module in ours.items() if text not in limits_of_page()}
    assert not missing, f"docs/limits.md does not say so: {missing}"


@pytest.mark.parametrize("page", pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_no_page_installs_a_package_that_is_not_published(page: Path) -> None:
    """orishell is in no index: it is installed from a clone, or from a wheel that one has."""
    text = page.read_text(encoding="utf-8")
    if page.name != "CHANGELOG.md":
        assert not re.findall(r"""pip install (?:-\S+ )*["']?orishell(?![\w.-]*\.whl)(?!-)""", text)


def test_what_is_linear_is_asked_for() -> None:
    """README says of structures what the keys of their table can do."""
    assert {"nonlinear", "combinations"} <= set(StructureTable.model_fields)
    assert "EN 1990" in README
    assert "large displacements" in README
