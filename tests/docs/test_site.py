"""The site builds without a warning, and every link in it leads somewhere."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
import typer

from orishell.cli.main import app
from public_names import public_modules, public_objects

ROOT = Path(__file__).parents[2]
pytestmark = pytest.mark.slow


class Page(HTMLParser):
    """Where a page's links lead, its pictures, and the places that links can lead to."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.places: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note a link or a place."""
        for name, value in attrs:
            if name in {"href", "src"} and value:
                self.targets.append(value)
            elif name in {"id", "name"} and value:
                self.places.add(value)


def dead_links(site: Path) -> Iterator[str]:
    """Links within the site, to pictures too, that lead nowhere; and addresses that are none."""
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    for path, page in pages.items():
        for target in page.targets:
            parts = urlsplit(target)
            if parts.scheme in {"http", "https"}:
                if not re.fullmatch(r"[\w-]+(\.[\w-]+)+(:\d+)?", parts.netloc):
                    yield f"{path.name}: {target}"
                continue
            if parts.scheme in {"data", "mailto"}:
                continue
            assert not parts.scheme, f"{path}: {target}"
            to = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not to.exists() or (
                to in pages and unquote(parts.fragment) not in {"", *pages[to].places}
            ):
                yield f"{path.relative_to(site)}: {target}"


def test_links_lead_somewhere(site: Path) -> None:
    assert len(list(site.rglob("*.html"))) > 40
    assert not (dead := list(dead_links(site))), "\n".join(dead)


def test_a_dead_link_is_seen(tmp_path: Path) -> None:
    (tmp_path / "a.html").write_text('<p id="x"><a href="a.html#x"></a><a href="#y"></a>')
    (tmp_path / "b.html").write_text(
        '<img src="no.png"><a href="a.html#z"></a><a href="https://?">'
    )
    assert list(dead_links(tmp_path)) == [
        "a.html: #y", "b.html: no.png", "b.html: a.html#z", "b.html: https://?",
    ]  # fmt: skip


def test_the_site_asks_nothing_of_the_network(site: Path) -> None:
    # Scripts, styles, pictures and fonts are all in it.
    for path in site.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        for tag in re.findall(r"<(?:script|img|link|iframe)\b[^>]*>", text):
            assert not re.search(r"""(src|href)=["'](https?:)?//""", tag), f"{path}: {tag}"


def test_no_page_names_this_machine(site: Path) -> None:
    # The paths of the sources and of the build.
    for path in site.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        assert str(ROOT) not in text, path
        assert str(site.parent) not in text, path


def test_every_public_name_is_in_the_reference(site: Path) -> None:
    places = {place for path in (site / "api").glob("*.html") for place in Page(path).places}
    missing = [name for name in public_objects() if name not in places]
    assert not missing
    undescribed = [
        module.__name__ for module in public_modules()
        if f"module-{module.__name__}" not in places and module.__name__ not in WITHOUT_PAGE
    ]  # fmt: skip
    assert not undescribed


WITHOUT_PAGE = {
    "orishell": "its names are listed on the first page of the reference",
    "orishell.families": "a shelf",
    "orishell.studio": "a shelf",
}


def test_every_command_is_in_the_reference(site: Path) -> None:
    text = (site / "api" / "cli.html").read_text(encoding="utf-8")
    for name, command in typer.main.get_group(app).commands.items():
        assert f"orishell {name}" in text
        for each in command.params:
            for flag in each.opts:
                if flag.startswith("--") and flag != "--help":
                    assert flag in text, f"{name} {flag}"
