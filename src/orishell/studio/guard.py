"""The key of a studio: only who has it is let in, and the browser keeps it in a cookie.

Every user of a machine can ask whatever listens on it. So the address that the studio prints holds
a key that is made anew at every start, and that no list of processes shows: the browser is sent to
a file that only its user can read, and from there to that address.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import json
import secrets
import shutil
import subprocess
import tempfile
import webbrowser
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from typing import Any, ClassVar
from urllib.parse import urlsplit

from starlette.types import ASGIApp, Message, Receive, Send

from orishell.conventions.progress import cleaning_up
from orishell.studio.api import FaultKind
from orishell.studio.refusals import make_refusal

LOCKED = "the studio's key is missing: open the address that `orishell studio` printed at its start"
QUERY = "key"
"""What the key is called in the address."""
PAGE = """\
<!doctype html>
<meta charset="utf-8">
<title>orishell studio</title>
<meta name="referrer" content="no-referrer">
<meta http-equiv="refresh" content="0; url={0}">
<p><a href="{0}">To the studio</a></p>
"""


@dataclass(frozen=True, slots=True)
class Key:
    """What lets one in, as an address and as a cookie."""

    LOCKED: ClassVar[str] = LOCKED
    """What is said to who has none."""
    port: int  # browsers keep the cookies of all ports of a machine together
    word: str = field(default_factory=lambda: secrets.token_urlsafe(32), repr=False)

    @property
    def query(self) -> str:
        """The part of an address that holds the key."""
        return f"{QUERY}={self.word}"

    @property
    def cookie(self) -> str:
        """The cookie that holds the key."""
        return f"orishell-{self.port}={self.word}"

    def setting(self) -> bytes:
        """The header ``Set-Cookie`` that makes a browser keep the key until it is closed.

        Not ``Strict``: neither the file that the browser is sent to nor a link in a letter is of
        the same site.
        """
        return f"{self.cookie}; Path=/; HttpOnly; SameSite=Lax".encode()

    def enters(self, scope: Mapping[str, Any]) -> bool:
        """Whether the address of a request holds the key."""
        return _holds(scope["query_string"].split(b"&"), self.query)

    def opens(self, scope: Mapping[str, Any]) -> bool:
        """Whether a request has the key, in its address or as a cookie."""
        cookies = [
            part
            for name, value in scope["headers"]
            if name.lower() == b"cookie"
            for part in value.split(b";")
        ]
        return self.enters(scope) or _holds(cookies, self.cookie)


def _holds(parts: Collection[bytes], wanted: str) -> bool:
    """Whether one of the parts is what is wanted, in a time that does not say how nearly."""
    return any(hmac.compare_digest(part.strip(), wanted.encode()) for part in parts)


@contextmanager
def open_page(address: str) -> Iterator[None]:
    """Send the browser to an address that nobody else shall see.

    Until the end of the context a file in a folder that only this user can read leads there.
    """
    folder = _private_folder()
    with cleaning_up(lambda: shutil.rmtree(folder, ignore_errors=True)):
        page = folder / "studio.html"
        page.touch(mode=0o600)
        page.write_text(PAGE.format(escape(address)), encoding="utf-8")
        opener = shutil.which("xdg-open")
        if opener is None:
            webbrowser.open(page.as_uri())
        else:  # what browsers say is not for the terminal
            quiet = subprocess.DEVNULL
            subprocess.Popen([opener, str(page)], stdin=quiet, stdout=quiet, stderr=quiet)
        yield


def _private_folder() -> Path:
    """A new folder that only this user can read.

    It is in the home folder, under a name that is not hidden: a browser that is installed as a snap
    sees no other files.
    """
    prefix = "orishell-studio-"
    try:
        return Path(tempfile.mkdtemp(prefix=prefix, dir=Path.home()))
    except (OSError, RuntimeError):  # a home that cannot be written, or none
        return Path(tempfile.mkdtemp(prefix=prefix))


AT_ONCE = 150
"""Requests with the key at a time, at most: all together must not take the machine's memory."""
VALUES = 1_000_000
"""Commas in a body, at most: a longer list would keep other requests waiting."""
DISCARDED, GRACE = 20_000_000, 1.0
"""Of a refused body so much is read and thrown away at most, for so long (bytes, seconds)."""
HEADERS = (
    (
        b"content-security-policy",
        b"default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
        b"object-src 'none'; base-uri 'none'; frame-ancestors 'none'",
    ),
    (b"x-content-type-options", b"nosniff"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
)


class Guard:
    """Refuses requests that do not come from the studio's own pages, or are too large."""

    def __init__(
        self, app: ASGIApp, key: Key, hosts: Collection[str] | None, most: int, seconds: float
    ) -> None:
        self.app = app
        self.key = key  # the address ``/`` with it gives the cookie
        self.hosts = hosts  # Host headers that are taken, with their ports; None takes all
        self.most = most  # bytes of a body
        self.seconds = seconds  # that a body may take to come in
        self.under_way = 0  # requests with the key that are being answered

    async def __call__(self, scope: Message, receive: Receive, send: Send) -> None:
        """Answer a request, or refuse it."""
        if scope["type"] != "http":
            if scope["type"] == "lifespan":
                await self.app(scope, receive, send)
            return
        if not self.key.opens(scope):
            await _discard(receive)
            await _turn_away(send, scope["path"], self.key.LOCKED)
            return
        headers = {name.lower(): value for name, value in scope["headers"]}
        refusal = self._refusal(scope["method"], headers)
        if refusal is not None:
            await _discard(receive)
            await _answer(send, *refusal)
            return
        if self.key.enters(scope) and scope["path"] == "/":
            await _let_in(send, self.key)
            return
        self.under_way += 1
        try:
            await self._pass_on(scope, receive, send)
        finally:
            self.under_way -= 1

    async def _pass_on(self, scope: Message, receive: Receive, send: Send) -> None:
        """Let the application answer a request, once all of it is here."""
        try:
            async with asyncio.timeout(self.seconds):
                body = await self._body(receive)
        except TimeoutError:
            await _answer(send, 408, f"the request did not come in within {self.seconds:g} s")
            return
        except ConnectionError:
            return
        if body is None:
            await _answer(send, 413, f"the request is larger than {self.most} bytes")
            return
        if body.count(b",") > VALUES:
            await _answer(send, 413, f"the request has more than {VALUES} values")
            return
        given = False

        async def whole() -> Message:
            nonlocal given
            if given:
                return await receive()
            given = True
            return {"type": "http.request", "body": body, "more_body": False}

        async def guarded(message: Message) -> None:
            if message["type"] == "http.response.start":
                message = {**message, "headers": [*message["headers"], *HEADERS]}
            await send(message)

        await self.app(scope, whole, guarded)

    async def _body(self, receive: Receive) -> bytes | None:
        """The whole body; None if it is too large. Raises ConnectionError if the client left."""
        body = bytearray()
        while True:
            message = await receive()
            if message["type"] == "http.disconnect":
                raise ConnectionError
            body += message.get("body", b"")
            if len(body) > self.most:
                if message.get("more_body"):
                    await _discard(receive)
                return None
            if not message.get("more_body"):
                return bytes(body)

    def _refusal(self, method: str, headers: dict[bytes, bytes]) -> tuple[int, str] | None:
        """HTTP status and reason for refusing a request; None if it is accepted."""
        if self.under_way >= AT_ONCE:
            return 503, "too many requests at a time: try again in a moment"
        host = headers.get(b"host", b"").decode("latin-1").lower()
        if self.hosts is not None and host not in self.hosts:
            return 403, "this host is not served: open the address that the studio printed"
        origin = headers.get(b"origin")
        if origin is not None and _place(origin) != host:
            return 403, "requests from other websites are not answered"
        if method == "POST" and not headers.get(b"content-type", b"").startswith(
            b"application/json"
        ):
            return 415, "the body of a request must be JSON (application/json)"
        length = headers.get(b"content-length", b"0")
        if not length.isdigit() or len(length) > 15 or int(length) > self.most:
            return 413, f"the request is larger than {self.most} bytes"
        return None


def _place(origin: bytes) -> str | None:
    """Host and port of an ``Origin`` header; None if it cannot be read."""
    try:
        return urlsplit(origin.decode("latin-1")).netloc.lower()
    except ValueError:
        return None


async def _discard(receive: Receive) -> None:
    """Read what is left of a body: a client whose sending is cut off may not see the answer."""
    left = DISCARDED
    with contextlib.suppress(TimeoutError):
        async with asyncio.timeout(GRACE):
            while left > 0:
                message = await receive()
                if not message.get("more_body"):  # its end, or the client went away
                    return
                left -= len(message["body"])


async def _answer(send: Send, status: int, message: str, kind: FaultKind = "limit") -> None:
    body = json.dumps(make_refusal(kind, message)).encode()
    await _send(send, status, body, (b"content-type", b"application/json"))


async def _turn_away(send: Send, path: str, locked: str) -> None:
    """Say to who has no key where it is: to a page as JSON, to a person as text."""
    if path.startswith("/api/"):
        await _answer(send, 403, locked, "key")
        return
    text = f"{locked[0].upper()}{locked[1:]}.\n".encode()
    await _send(send, 403, text, (b"content-type", b"text/plain; charset=utf-8"))


async def _let_in(send: Send, key: Key) -> None:
    """Give the browser its cookie, and send it on to the same address without the key."""
    more = ((b"location", b"./"), (b"set-cookie", key.setting()), (b"cache-control", b"no-store"))
    await _send(send, 303, b"", *more)


async def _send(send: Send, status: int, body: bytes, *more: tuple[bytes, bytes]) -> None:
    head = [
        *more,
        (b"content-length", str(len(body)).encode()),
        (b"connection", b"close"),  # what else comes of the body is not read
    ]
    await send({"type": "http.response.start", "status": status, "headers": [*head, *HEADERS]})
    await send({"type": "http.response.body", "body": body})
