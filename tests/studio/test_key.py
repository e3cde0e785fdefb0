"""Who may use a studio: who has its key, and nobody else on the machine."""

from __future__ import annotations

import os
import re
import stat
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from http.cookies import SimpleCookie
from pathlib import Path
from typing import Any

import httpx
import pytest

from apart import run_apart
from orishell.studio.guard import LOCKED, Guard, Key
from studio_server import Studio, running_studio
from timing import HANGS

BROWSER = """\
#!/bin/sh
printf '%s' "$1" > "$OPENED.new" && mv "$OPENED.new" "$OPENED"
while [ -e "$1" ]; do sleep 0.2; done
"""
"""A browser that keeps what it was told to open, and is among the processes while that is there."""
ASKED = """
import encodings.idna, http.client, os, sys
place = http.client.HTTPConnection(sys.argv[1])
os.setgroups([])
os.setgid(65534)
os.setuid(65534)  # to whom nothing belongs
place.request("GET", "/api/info")
print(place.getresponse().status)
try:
    open(sys.argv[2])
except PermissionError:
    print("refused")
"""
"""Another user, who asks for an address without its key and reads a file."""


@pytest.fixture(scope="module")
def stranger(studio: Studio) -> Iterator[httpx.Client]:
    """A client that has no key."""
    with httpx.Client(base_url=studio.address, timeout=30) as session:
        yield session


@pytest.mark.parametrize("path", ["/", "/index.html", "/assets/none.js", "/api/info", "/api/none"])
def test_without_the_key_nothing_is_answered(stranger: httpx.Client, path: str) -> None:
    for method in ("GET", "HEAD", "POST", "PUT", "OPTIONS"):
        answer = stranger.request(method, path, json={})
        assert answer.status_code == 403
        assert "set-cookie" not in answer.headers
        if method != "HEAD":
            assert LOCKED[1:] in answer.text
    if path.startswith("/api/"):
        assert stranger.get(path).json()["error"]["kind"] == "key"


def test_a_key_that_is_not_whole_is_none(studio: Studio, stranger: httpx.Client) -> None:
    ((name, word),) = studio.cookies.items()

    def status(path: str, cookie: str = "") -> int:
        return stranger.get(path, headers={"cookie": cookie}).status_code

    for wrong in ("", "x", word[:-1], word + "x", word.swapcase()):
        assert status("/api/info", f"{name}={wrong}") == 403
        assert status("/api/info", f"{name}0={word}") == 403
        assert status(f"/api/info?key={wrong}") == 403
        assert status(f"/api/info?nokey={word}") == 403
        assert status(f"/?key={wrong}") == 403
    assert status("/api/info", f"first=1; {name}={word};last==") == 200
    assert status(f"/api/info?a=b&key={word}") == 200


def test_the_address_gives_a_cookie_and_loses_its_key(studio: Studio) -> None:
    with httpx.Client(timeout=30) as browser:
        first = browser.get(studio.entrance)
        assert first.status_code == 303
        assert first.headers["cache-control"] == "no-store"
        (cookie,) = SimpleCookie(first.headers["set-cookie"]).values()
        assert cookie["httponly"]
        assert (cookie["samesite"], cookie["path"], cookie["domain"]) == ("Lax", "/", "")
        assert studio.address.endswith(cookie.key.removeprefix("orishell-"))
        then = browser.send(first.next_request or pytest.fail("it leads nowhere"))
        assert str(then.url) == f"{studio.address}/"
        assert then.status_code == 200
        assert browser.get(f"{studio.address}/api/info").status_code == 200


def test_the_key_does_not_open_to_other_websites(studio: Studio) -> None:
    origin = {"origin": "http://evil.example"}
    assert httpx.get(studio.entrance, headers=origin).status_code == 403
    assert httpx.get(studio.entrance, headers={"host": "evil.example"}).status_code == 403


def test_every_start_has_a_key_of_its_own() -> None:
    words = [Key(8765).word for _ in range(20)]
    assert len(set(words)) == 20
    assert min(map(len, words)) >= 43  # 256 bits
    assert words[0] not in repr(Key(8765, words[0]))


def test_nothing_is_read_of_a_request_without_the_key() -> None:
    """The application behind is not asked, whatever a request is."""

    async def scene() -> list[int]:
        statuses: list[int] = []

        async def app(scope: Any, receive: Any, send: Any) -> None:
            raise AssertionError

        async def send(message: Any) -> None:
            if message["type"] == "http.response.start":
                statuses.append(message["status"])

        async def receive() -> dict[str, Any]:
            return {"type": "http.request", "body": b"x"}

        guard = Guard(app, Key(8765), None, 1000, 1.0)
        headers = [
            [(b"cookie", cookie)]
            for cookie in (b"", b"orishell-8765", b"orishell-8765=", b";;==\xff", b";" * 9999)
        ]
        for each in ([], *headers):
            scope = {"type": "http", "path": "/", "query_string": b"&key&key=", "method": "GET"}
            await guard({**scope, "headers": each}, receive, send)
        return statuses

    assert run_apart(scene()) == [403] * 6


@dataclass(frozen=True)
class Seen:
    studio: Studio
    page: Path
    """What the browser was told to open."""


@pytest.fixture
def seen(tmp_path: Path) -> Iterator[Seen]:
    """A studio that opens its page in a browser, and what others see of that."""
    browser, opened, home = tmp_path / "xdg-open", tmp_path / "opened", tmp_path / "home"
    browser.write_text(BROWSER)
    browser.chmod(0o755)
    home.mkdir()
    search = f"{tmp_path}:{os.environ['PATH']}"
    environment = {**os.environ, "PATH": search, "OPENED": str(opened), "HOME": str(home)}
    with running_studio("--browse", environment=environment) as studio:
        end = time.monotonic() + HANGS
        while not opened.exists() and time.monotonic() < end:
            time.sleep(0.05)
        yield Seen(studio, Path(opened.read_text()))
    assert not list(home.iterdir())


def _text(path: Path) -> str:
    try:
        return path.read_text(errors="replace")
    except OSError:
        return ""  # it ended meanwhile


@pytest.mark.skipif(sys.platform != "linux", reason="processes are looked up in /proc")
def test_the_browser_is_told_the_key_where_no_other_user_sees_it(seen: Seen) -> None:
    ((_, word),) = seen.studio.cookies.items()
    shown = {path: _text(path) for path in Path("/proc").glob("[0-9]*/cmdline")}
    assert any(str(seen.page) in text for text in shown.values())  # the browser is among them
    assert not [path for path, text in shown.items() if word in text]
    assert stat.S_IMODE(seen.page.stat().st_mode) == 0o600
    assert stat.S_IMODE(seen.page.parent.stat().st_mode) == 0o700
    assert not seen.page.parent.name.startswith(".")
    (target,) = re.findall(r'content="0; url=([^"]+)"', seen.page.read_text())
    assert target == seen.studio.entrance
    if os.geteuid() == 0:  # who else may become another user?
        done = subprocess.run(
            [sys.executable, "-c", ASKED, seen.studio.address[7:], str(seen.page)],
            capture_output=True,
            text=True,
            check=True,
            timeout=60,
        )
        assert done.stdout.split() == ["403", "refused"]
