"""The key of a studio: only who has it is let in, and the browser keeps it in a cookie.

Every user of a machine can ask whatever listens on it. So the address that the studio prints holds
a key that is made anew at every start, and that no list of processes shows: the browser is sent to
a file that only its user can read, and from there to that address.
"""

from __future__ import annotations

import hmac
import secrets
import shutil
import subprocess
import tempfile
import webbrowser
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

from orishell.conventions.progress import cleaning_up

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
    """What lets one in, as an address and as a cookie.

    Parameters
    ----------
    port
        Where the studio listens; browsers keep the cookies of all ports of a machine together.
    word
        The key itself, made by chance if it is not given.
    """

    port: int
    word: str = field(default_factory=lambda: secrets.token_urlsafe(32), repr=False)

    @property
    def query(self) -> str:
        """The part of an address that holds the key."""
        return f"{QUERY}={self.word}"

    @property
    def cookie(self) -> str:
        """The cookie that holds the key."""
        return f"orishell-{self.port}={self.word}"

    def is_in_query(self, query: bytes) -> bool:
        """Whether the query of an address holds the key."""
        return _holds(query.split(b"&"), self.query)

    def is_in_cookies(self, header: bytes) -> bool:
        """Whether a header ``Cookie`` holds the key."""
        return _holds((each.strip() for each in header.split(b";")), self.cookie)

    def setting(self) -> bytes:
        """The header ``Set-Cookie`` that makes a browser keep the key until it is closed.

        Not ``Strict``: neither the file that the browser is sent to nor a link in a letter is of
        the same site.
        """
        return f"{self.cookie}; Path=/; HttpOnly; SameSite=Lax".encode()


def _holds(parts: Iterator[bytes] | list[bytes], wanted: str) -> bool:
    """Whether one of the parts is what is wanted, in a time that does not say how nearly."""
    return any(hmac.compare_digest(part, wanted.encode()) for part in parts)


@contextmanager
def open_page(address: str) -> Iterator[None]:
    """Send the browser to an address that nobody else shall see.

    Until the end of the context there is a file that leads there, in a folder that only this user
    can read.

    Parameters
    ----------
    address
        The address, with its key.
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
