"""Pages of one file that need no network: with a program, or to read and to print."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterable
from html import escape
from importlib.resources import files
from importlib.resources.abc import Traversable

from orishell.conventions.colours import DARK, LIGHT
from orishell.conventions.errors import InputError

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

    Raises InputError: With the message ``missing``, if it has not been built.
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
    # Both occur in its strings only.
    program = program.replace("</", "<\\/").replace("<!--", "<\\!--")
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


_STATIC_STYLE = """
:root { color-scheme: light; --bg: #fff; --text: #1d2126; --soft: #5a5f67; --line: #d5d1c8;
  --head: #f1eee7; LIGHT }
@media screen and (prefers-color-scheme: dark) {
  :root { color-scheme: dark; --bg: #14171b; --text: #e6e3dc; --soft: #a9afb8; --line: #343a43;
    --head: #22272e; DARK }
}
body { margin: 0 auto; padding: 12mm 6mm; max-width: 190mm; background: var(--bg);
  color: var(--text); font: 10.5pt/1.45 system-ui, sans-serif; }
h1 { font-size: 18pt; line-height: 1.2; margin: 0 0 2mm; }
h2 { font-size: 13pt; margin: 9mm 0 2mm; border-bottom: 1px solid var(--line); }
h3 { font-size: 11pt; margin: 6mm 0 1mm; }
h1, h2, h3, caption { break-after: avoid; }
p, ul { margin: 1.5mm 0; }
ul { padding-left: 5mm; }
.lead { font-size: 12pt; }
.soft, caption { color: var(--soft); }
p.warns, p.fails, p.holds { border-left: 3px solid var(--sign); padding-left: 3mm; }
.warns { --sign: var(--warns); }
.fails { --sign: var(--fails); }
.holds { --sign: var(--holds); }
tr.warns :nth-child(2), tr.fails :nth-child(2), tr.holds :nth-child(2), p.fails {
  color: var(--sign); font-weight: 600; }
figure { margin: 4mm 0; break-inside: avoid; }
figure img { display: block; width: 100%; background: #fff; border-radius: 2mm; }
table { border-collapse: collapse; width: 100%; margin: 2mm 0 4mm; font-size: 9.5pt;
  font-variant-numeric: tabular-nums; }
caption { text-align: left; padding-bottom: 1mm; }
th, td { text-align: left; vertical-align: top; padding: 0.8mm 2mm; border-bottom: 1px solid
  var(--line); }
thead th { background: var(--head); font-weight: 600; }
tbody th { font-weight: 400; }
.total td, .total th { font-weight: 600; border-top: 1.5px solid var(--soft); }
.number { text-align: right; }
td.number { white-space: nowrap; }
tbody th { min-width: 24mm; }
tr { break-inside: avoid; }
thead { display: table-header-group; }
@media screen and (max-width: 700px) {
  body { padding: 6mm 4mm; } table { display: block; overflow-x: auto; }
  body { overflow-wrap: anywhere; } th, td { overflow-wrap: normal; }
}
@page { size: A4; margin: 15mm 12mm; }
@media print { body { padding: 0; max-width: none; font-size: 9.5pt; } table { font-size: 8.5pt; } }
"""
for _name, _colours in (("LIGHT", LIGHT), ("DARK", DARK)):
    _inks = (f"--{sign}: {_colours[sign]};" for sign in ("fails", "warns", "holds"))
    _STATIC_STYLE = _STATIC_STYLE.replace(f"{_name} }}", f"{' '.join(_inks)} }}")

_STATIC_PAGE = """\
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta http-equiv="Content-Security-Policy" content="{policy}"/>
<title>{title}</title>
<style>{style}</style>
</head>
<body>
{body}
</body>
</html>
"""


def static_page(title: str, parts: Iterable[str]) -> str:
    """A whole page, which is also well-formed XML, of parts in HTML.

    Its title is not escaped yet.
    """
    body = "\n".join(parts)
    policy = (
        f"default-src 'none'; style-src '{content_digest(_STATIC_STYLE)}'; img-src data:; "
        "base-uri 'none'; form-action 'none'"
    )
    return _STATIC_PAGE.format(policy=policy, title=escape(title), style=_STATIC_STYLE, body=body)


def content_digest(text: str) -> str:
    """The hash by which a content security policy allows what stands between two tags."""
    digest = base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest())
    return f"sha256-{digest.decode('ascii')}"
