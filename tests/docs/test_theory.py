"""Pages: their code runs; what those of the theory and the guide point at is there."""

import doctest
import importlib.util
import re
from pathlib import Path
from types import ModuleType

import pytest

from samples import thorough

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = sorted([*(DOCS / "theory").glob("*.md"), *(DOCS / "guide").glob("*.md")])
CODED = sorted(
    page
    for page in DOCS.rglob("*.md")
    if page in PAGES or "```{doctest}" in page.read_text(encoding="utf-8")
)
PICTURES = DOCS / "images" / "guide"
LINKED = {
    "families/shared/sheets.py": "vertex",
    "clash/__init__.py": "locking-and-clash",
    "solids/__init__.py": "thickness",
    "structure/__init__.py": "structure",
    "deviation/__init__.py": "deviation",
    "families/parallel_repeating/__init__.py": "parallel-repeating",
    "families/orthodiagonal/__init__.py": "orthodiagonal",
    "families/longitudinal_linear_repeating/__init__.py": "longitudinal-linear-repeating",
    "families/flat_foldable/__init__.py": "flat-foldable",
    "families/drawn/__init__.py": "vertex",
    "motion/following/__init__.py": "following",
}


def code(page: Path) -> str:
    """The page with everything but its blocks of Python left blank, so that line numbers stay."""
    lines, inside = [], False
    for line in page.read_text(encoding="utf-8").split("\n"):
        if line.startswith("```"):
            inside = not inside and re.match(r"```(\{doctest\}|python)$", line) is not None
            lines.append("")
        else:
            lines.append(line if inside else "")
    return "\n".join(lines)


def prose(page: Path) -> str:
    """The page without its blocks of code."""
    text = page.read_text(encoding="utf-8")
    return re.sub(r"^```(?!\{toctree\}).*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)


def named(page: Path) -> str:
    return f"{page.parent.name}/{page.stem}"


DEAR = {"guide/any-family"}
"""It fits a flat-foldable sheet, which is seconds; so does ``guide/surfaces``, to less."""


@pytest.mark.parametrize(
    "page",
    [pytest.param(page, marks=[thorough] * (named(page) in DEAR)) for page in CODED],
    ids=named,
)
def test_the_code_on_a_page_runs(page: Path) -> None:
    test = doctest.DocTestParser().get_doctest(code(page), {}, named(page), str(page), 0)
    said: list[str] = []
    result = doctest.DocTestRunner().run(test, out=said.append)
    assert result.failed == 0, "".join(said)


CHECKED = {
    "guide/blender": "test_blender.py",
    "guide/grasshopper": "studio/test_hops.py",
    "guide/notebooks": "test_guide_notebooks.py",
}
"""Pages about other programs, and the tests that do what they say."""


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_every_theory_page_and_family_page_has_a_check(page: Path) -> None:
    if named(page) in CHECKED:
        assert (ROOT / "tests" / CHECKED[named(page)]).is_file()
    elif page.parent.name == "theory" or page.stem != "index":
        assert ">>>" in code(page)


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_a_page_has_one_title_and_its_links_lead_somewhere(page: Path) -> None:
    text = prose(page)
    assert len(re.findall(r"^# ", text, flags=re.MULTILINE)) == 1
    assert text.startswith("# ")
    for target in re.findall(r"\]\((?!https://)([^)#\s]+)[^)]*\)", text):
        assert (page.parent / target).is_file(), target
    for target in re.findall(r"\{doc\}`([^`]+)`", text):
        assert (page.parent / f"{target}.md").is_file(), target
    for module in re.findall(r"\{py:mod\}`([^`]+)`", text):
        assert importlib.util.find_spec(module) is not None, module


def test_numbers_in_fractions_have_braces() -> None:
    r"""Formulas become MathML by a converter that reads the 12 of \tfrac12 as one number."""
    pages = [*PAGES, *(ROOT / "src").rglob("*.py")]
    bare = re.compile(r"\\[dt]?frac\s*\d")
    assert not [page for page in pages if bare.search(page.read_text(encoding="utf-8"))]


@pytest.mark.parametrize("folder", ["theory", "guide"])
def test_the_index_lists_every_page(folder: str) -> None:
    text = (DOCS / folder / "index.md").read_text(encoding="utf-8")
    block = re.search(r"```\{toctree\}\n(.*?)```", text, flags=re.DOTALL)
    assert block is not None
    listed = {line for line in block[1].splitlines() if line and not line.startswith(":")}
    assert listed == {page.stem for page in (DOCS / folder).glob("*.md")} - {"index"}


@pytest.mark.parametrize(("module", "page"), LINKED.items())
def test_modules_and_theory_pages_name_each_other(module: str, page: str) -> None:
    source = ROOT / "src" / "orishell" / module
    assert f"Derived in docs/theory/{page}.md." in source.read_text(encoding="utf-8")
    name = module.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
    text = (DOCS / "theory" / f"{page}.md").read_text(encoding="utf-8")
    assert f"{{py:mod}}`orishell.{name}`" in text


def guide_pictures() -> ModuleType:
    path = ROOT / "examples" / "guide_pictures.py"
    spec = importlib.util.spec_from_file_location("guide_pictures", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_pictures_are_those_of_the_script_and_are_shown() -> None:
    names = {*guide_pictures().PICTURES, "blender.png"}  # that by tests/blender_pictures.py
    assert {path.name for path in PICTURES.glob("*.png")} == names
    shown = "".join(prose(page) for page in PAGES)
    assert set(re.findall(r"\.\./images/guide/([\w-]+\.png)", shown)) == names


def test_a_picture_is_the_same_every_time(tmp_path: Path) -> None:
    draw = guide_pictures().PICTURES["parallel-plane.png"]
    for name in ("one.png", "two.png"):
        draw(tmp_path / name)
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()
