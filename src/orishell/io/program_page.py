"""Pages with a program: one file that needs no network and no other file."""

from __future__ import annotations

from html import escape
from importlib.resources import files
from importlib.resources.abc import Traversable

from orishell.conventions.errors import InputError
from orishell.io.static_page import content_digest

BUILD_PAGES = (
    "install a wheel of orishell that has the pages; in its sources, `npm run pages` in "
    "frontend/ builds them (Node.js 18 or newer)"
)
"""What to do where the programs of pages are missing."""

_STYLE = """
html, body { margin: 0; height: 100%; background: #f5f3ee; }
@media (prefers-color-scheme: dark) { html, body { background: #14171b; } }
main { height: 100%; }
noscript { display: block; padding: 3em; font: 16px/1.5 system-ui, sans-serif; }
"""

_PAGE = """\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<noscript>{title}: this page draws {what} with JavaScript, which is turned off here.</noscript>
<script type="{kind}" id="{name}">{data}</script>
<script type="module">{program}</script>
</body>
</html>
"""


def place_of(program: str) -> Traversable:
    """Where a page's program lies, by the name of its file, once it is built."""
    return files("orishell.io").joinpath("pages", program)


def read_program(place: Traversable, missing: str) -> str:
    """A page's program, one JavaScript module without imports.

    Raises
    ------
    InputError
        With the message ``missing``, if it has not been built.
    """
    if not place.is_file():
        raise InputError(missing, remedy=BUILD_PAGES)
    return place.read_text(encoding="utf-8")


def program_page(
    program: str, *, title: str, what: str, name: str, data: str, kind: str = "application/json"
) -> str:
    """A whole page: its program, and what that shows.

    Only this program and this style run, and nothing is loaded: the page cannot send anything.
    The title is not escaped yet; ``what`` the page draws is said where JavaScript is off. Under
    ``name`` the program finds its data: JSON, or bytes in base64, of the media type ``kind``.
    """
    program = _inside_script(program)
    policy = (
        f"default-src 'none'; script-src '{content_digest(program)}'; "
        f"style-src '{content_digest(_STYLE)}'; base-uri 'none'; form-action 'none'"
    )
    return _PAGE.format(
        policy=policy,
        title=escape(title),
        what=what,
        style=_STYLE,
        kind=kind,
        name=name,
        data=data.replace("<", "\\u003c"),
        program=program,
    )


def _inside_script(program: str) -> str:
    r"""A program as it may stand in a page: ``</`` and ``<!--`` occur in its strings only."""
    return program.replace("</", "<\\/").replace("<!--", "<\\!--")
