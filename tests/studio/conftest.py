"""A studio and a browser for the tests of its page."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from node_tools import lacking
from orishell.studio.app import PAGES
from studio_pages import opened
from studio_server import running_studio
from viewer_pages import running_browser

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    if not (PAGES / "index.html").is_file():
        lacking("the studio's pages have not been built: make pages")
    with running_studio() as studio:
        yield studio.address


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with running_browser() as found:
        yield found


@pytest.fixture(scope="module")
def page(browser: Browser, address: str) -> Iterator[Page]:
    """A page that tests use one after the other, each beginning with an example."""
    with opened(browser, address) as shared:
        yield shared
