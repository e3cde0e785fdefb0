"""A studio and a browser for the tests of its page."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import httpx
import pytest

from node_tools import lacking
from orishell.studio.app import PAGES
from screenshots import WRITES, keeps_picture
from studio_pages import opened
from studio_server import Studio, running_studio

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """``make screenshots`` runs the tests that keep one, and no others."""
    if WRITES:
        items[:] = [each for each in items if keeps_picture(each)]


@pytest.fixture(scope="session")
def studio() -> Iterator[Studio]:
    """With its pages, or without where they have not been built."""
    with running_studio() as found:
        yield found


@pytest.fixture(scope="session")
def address(studio: Studio) -> str:
    """What it prints, with its key."""
    if not (PAGES / "index.html").is_file():
        lacking("the studio's pages have not been built: make pages")
    return studio.entrance


@pytest.fixture(scope="session")
def client(studio: Studio) -> Iterator[httpx.Client]:
    """What asks without a browser."""
    with httpx.Client(base_url=studio.address, cookies=studio.cookies, timeout=100) as session:
        yield session


@pytest.fixture(scope="module")
def page(browser: Browser, address: str) -> Iterator[Page]:
    """A page that tests use one after the other, each beginning with an example."""
    with opened(browser, address) as shared:
        yield shared
