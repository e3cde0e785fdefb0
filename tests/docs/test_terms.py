"""One thing has one name: the words of docs/notation.md, and the code that it points to."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
import typer

import orishell
from orishell.clash import ProofRecord
from orishell.cli.main import app
from orishell.conventions.record import written_fields
from orishell.deployment import Deployment, OwnWeight, Pack, Tie
from orishell.deployment.report import DeploymentReport
from orishell.design import HingeSpec, PanelSpec, Setback
from orishell.design_file import read_design_file, starter_file
from orishell.design_file.search import Search
from orishell.families.registry import FAMILIES
from orishell.locking.report import (
    HingedReport,
    JointReport,
    MeetingReport,
    PanelReport,
    PieceReport,
)
from orishell.search.figures import NAMES
from orishell.shell.designed import design_of
from orishell.solids.hinged.play import Play
from orishell.structure.case import CaseResult
from orishell.structure.crease_forces import AtCrease, CreaseForces
from orishell.structure.envelopes import Governing
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.hinge_lines import LineStrength
from orishell.structure.largest import CreaseMoment, Displacement, PairForce, Reaction, Stress
from orishell.structure.load_settings import LoadCase, Person, Snow, Wind
from orishell.structure.loads import Load
from orishell.structure.model import Model
from orishell.structure.rail import AtRail
from orishell.structure.rail_settings import BaseRail
from orishell.structure.results import Analysis
from orishell.structure.sandwich import Sandwich
from orishell.structure.settings import StructureTable, Support
from orishell.structure.utilisation import Utilisation
from public_names import public_objects

ROOT = Path(__file__).parents[2]
SOURCES = ROOT / "src" / "orishell"

BANNED = {
    # A word that names something else, or nothing, and what to say.
    r"facets?": "panel",
    r"fold(ing)? lines?": "crease",
    r"hinge lines?": "crease",
    r"dihedral( angles?)?": "fold angle",
    r"folding angles?": "fold angle",
    r"folding parameters?": "drive",
    r"flat foldable": "flat-foldable",
    r"rigid(ly)? foldable": "rigid-foldable",
    r"self[- ]lock(s|ed|ing)?": "lock",
    r"staircases? polyline": "staircase",
    # One spelling, the British one, in what people read; other people's names are code.
    r"colors?|colored|coloring": "colour",
    r"centers?|centered": "centre",
    r"(milli|centi)?meters?": "metre",
    r"neighbors?|neighboring": "neighbour",
    r"behaviors?": "behaviour",
    r"gray": "grey",
    r"labeled|labeling": "labelled",
    r"modeled|modeling": "modelled",
    r"e\.g\.|i\.e\.|etc\.": "plain words",
}
PATTERN = re.compile(r"\b(" + "|".join(f"(?:{each})" for each in BANNED) + r")(?![\w])", re.I)
ALLOWED = {
    # The page that says what not to say.
    "docs/notation.md": {
        "facet", "fold line", "hinge line", "dihedral angle", "folding angle",
        "folding parameter", "self-lock", "flat foldable", "rigidly foldable",
    },
}  # fmt: skip


def prose_of_markdown(text: str) -> str:
    """Text without code, formulas, addresses and directives."""
    text = re.sub(r"^(```+|~~~+|:::+).*?^\1", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"\$\$.*?\$\$|\$[^$\n]*\$", "", text, flags=re.DOTALL)
    text = re.sub(r"`[^`]*`", "", text)
    return re.sub(r"\]\([^)]*\)|<?https?://\S+", "", text)


def pages() -> list[Path]:
    """All pages that people write, not those that the gallery makes of scripts."""
    own = [page for page in (ROOT / "docs").rglob("*.md") if "gallery" not in page.parts[-2:-1]]
    return sorted(
        [*own, *(ROOT / f"{name}.md" for name in ("README", "CHANGELOG", "CONTRIBUTING"))]
    )


@pytest.mark.parametrize("page", pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_pages_use_the_terms(page: Path) -> None:
    name = str(page.relative_to(ROOT))
    assert not list(strays(prose_of_markdown(page.read_text(encoding="utf-8")), name))


def strays(text: str, name: str) -> Iterator[str]:
    """Words that are not to be used, each with what to say instead."""
    for match in PATTERN.finditer(text):
        word = match.group(0).lower()
        if word not in ALLOWED.get(name, set()):
            say = next(say for bad, say in BANNED.items() if re.fullmatch(bad, word, re.I))
            yield f"{name}: “{match.group(0)}”: say {say}"


def test_a_wrong_word_is_seen() -> None:
    # The test of the test: every entry of the list is found in a sentence.
    for word in ("facet", "Fold lines", "dihedral angle", "color", "centered", "flat foldable"):
        assert list(strays(f"This {word} is wrong.", "page"))
    assert not list(strays("A crease of a panel, its colour, a parameter and a perimeter.", "page"))
    assert not list(strays(prose_of_markdown("`color` $facet$ [x](facet.md)"), "page"))


@cache
def docstrings() -> dict[str, str]:
    """Docstrings of every module, class and function, public or not, by file and line."""
    found = {}
    for path in sorted(SOURCES.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
                text = ast.get_docstring(node)
                if text:
                    line = getattr(node, "lineno", 1)
                    found[f"{path.relative_to(ROOT)}:{line}"] = text
    return found


NO_PROSE = re.compile(r"``[^`]*``|:\w+:`[^`]*`|^(\w+, )*\w+\n(?=    \w)", re.MULTILINE)
"""Code in docstrings, and names that entries are of."""


def test_docstrings_use_the_terms() -> None:
    assert len(docstrings()) > 500
    found = [
        stray
        for place, text in docstrings().items()
        for stray in strays(re.sub(NO_PROSE, "", text), place)
    ]
    assert not found, "\n".join(found)


def test_the_command_line_uses_the_terms() -> None:
    for name, command in typer.main.get_group(app).commands.items():
        texts = [command.help or "", *(getattr(each, "help", "") or "" for each in command.params)]
        assert texts[0]
        assert not list(strays("\n".join(texts), name))


def test_starters_use_the_terms() -> None:
    for family in FAMILIES:
        comments = "\n".join(re.findall(r"#(.*)", starter_file(family)))
        assert not list(strays(comments, family))


def code_entries() -> list[str]:
    """What the last column of the notation's tables names."""
    text = (ROOT / "docs" / "notation.md").read_text(encoding="utf-8")
    text = text[: text.index("## Words")]
    rows = [line.split("|") for line in text.splitlines() if line.startswith("| ")]
    return sorted({each for row in rows for each in re.findall(r"`([^`]+)`", row[-2])})


@pytest.mark.parametrize("entry", code_entries())
def test_the_notation_names_code_that_exists(entry: str) -> None:
    if entry.startswith("["):
        table, _, key = entry.removeprefix("[").partition("]")
        assert_key(table, key.strip())
        return
    path, _, parameter = entry.partition("(")
    thing = find(path)
    if parameter:
        assert callable(thing)
        assert parameter.rstrip(")=") in inspect.signature(thing).parameters


def find(path: str) -> object:
    """A public name, a module, or an attribute of either."""
    head, *tail = path.split(".")
    by_name = {name.rsplit(".", 1)[-1]: thing for name, thing in public_objects().items()}
    thing = by_name.get(head) or getattr(orishell, head, None)
    assert thing is not None, f"no {head}"
    for name in tail:
        fields = {
            **getattr(thing, "__dataclass_fields__", {}),
            **getattr(thing, "model_fields", {}),
        }
        assert name in fields or hasattr(thing, name), f"no {name} in {path}"
        thing = getattr(thing, name, None)
    return thing


def assert_key(table: str, key: str) -> None:
    """A table and a key that some family's starter file has, be it in a comment."""
    texts = [starter_file(family) for family in FAMILIES]
    assert any(f"[{table}]" in text for text in texts), f"no [{table}]"
    assert not key or any(re.search(rf"(?m)^(# )?{key} =", text) for text in texts), f"no {key}"


@pytest.mark.parametrize("family", FAMILIES)
def test_the_guide_explains_every_parameter_of_the_report(family: str, tmp_path: Path) -> None:
    path = tmp_path / "shell.toml"
    path.write_text(starter_file(family), encoding="utf-8")
    file = read_design_file(path)
    page = (ROOT / "docs" / "guide" / f"{family}.md").read_text(encoding="utf-8")
    table = page.partition("## `parameters` in the report")[2]
    explained = {
        name
        for row in re.findall(r"^\| (`.*?) \|", table, flags=re.MULTILINE)
        for name in re.findall(r"`(\w+)`", row)
    }
    assert explained == set(design_of(file, file.pattern).parameters)


def fields_in_table(title: str, name: str = "pack-and-deploy") -> set[str]:
    """What the first column of a table of a page of the guide names."""
    page = (ROOT / "docs" / "guide" / f"{name}.md").read_text(encoding="utf-8")
    table = page.partition(f"\n## {title}\n")[2].partition("\n## ")[0]
    return set(re.findall(r"^\| `([\w.]+)` \|", table, flags=re.MULTILINE))


def test_the_guide_explains_every_key_and_field_of_deployment() -> None:
    keys = {field.alias or name for name, field in Deployment.model_fields.items()}
    assert fields_in_table("[deployment]") >= keys
    assert fields_in_table("`deployment` in the report") == set(written_fields(DeploymentReport))
    page = (ROOT / "docs" / "guide" / "pack-and-deploy.md").read_text(encoding="utf-8")
    for part in (Pack, Tie, OwnWeight):
        for key in written_fields(part):
            assert f"`{key}`" in page, key


def test_the_guide_explains_every_key_and_field_of_panels() -> None:
    keys = set(PanelSpec.model_fields) - {"largest_setback", "hinge"}
    keys |= {f"largest_setback.{name}" for name in Setback.model_fields}
    keys |= {f"hinge.{name}" for name in HingeSpec.model_fields}
    assert fields_in_table("[panel]", "thickness") == keys
    fields = set(written_fields(PanelReport))
    for name, part in (
        ("meeting", MeetingReport),
        ("path", ProofRecord),
        ("hinged", HingedReport),
        ("hinged.pieces", PieceReport),
        ("hinged.joints", JointReport),
        ("hinged.play.target", Play),
    ):
        fields |= {f"{name}.{key}" for key in written_fields(part)}
    assert fields_in_table("`panel` in the report", "thickness") == fields


PARTS_OF_STRUCTURE: tuple[type, ...] = (
    AtCrease, AtRail, CaseResult, CreaseForces, CreaseMoment, Displacement, Equilibrium, Governing,
    Load, Model, PairForce, Reaction, Stress, Support, Utilisation,
)  # fmt: skip


def test_the_guide_explains_every_key_and_field_of_structure() -> None:
    assert fields_in_table("[structure]", "structure") == {
        *StructureTable.model_fields, *Support.model_fields, *LineStrength.model_fields,
        *Sandwich.model_fields, *BaseRail.model_fields,
    }  # fmt: skip
    keys = set(LoadCase.model_fields)
    for table in (Snow, Wind, Person):
        keys |= set(table.model_fields)
    assert fields_in_table("[[load_case]]", "structure") == keys
    page = (ROOT / "docs" / "guide" / "structure.md").read_text(encoding="utf-8")
    for part in (Analysis, *PARTS_OF_STRUCTURE):
        for key in written_fields(part):
            assert f"`{key}`" in page, key


def test_the_guide_explains_every_key_and_figure_of_a_search() -> None:
    assert fields_in_table("[search]", "searching") == {*Search.model_fields, *NAMES}
