"""How pages and answers travel: text compressed, the lines of a proof as they come."""

from __future__ import annotations

import gzip
import json
import re
import tomllib

import httpx

from node_tools import lacking
from orishell.design_file import starter_file
from orishell.studio.app import PAGES

DESIGN = {"design": tomllib.loads(starter_file("parallel-repeating"))}


def test_json_is_compressed_for_those_who_take_it(client: httpx.Client) -> None:
    packed = client.get("/api/info", headers={"accept-encoding": "gzip"})
    plain = client.get("/api/info", headers={"accept-encoding": "identity"})
    assert packed.headers["content-encoding"] == "gzip"
    assert "content-encoding" not in plain.headers
    assert packed.json() == plain.json()
    assert int(packed.headers["content-length"]) < 0.5 * len(plain.content)


def test_views_are_sent_as_they_are(client: httpx.Client) -> None:
    answer = client.post("/api/design", json=DESIGN, headers={"accept-encoding": "gzip"})
    assert answer.status_code == 200
    assert "content-encoding" not in answer.headers


def test_lines_of_a_proof_come_one_by_one(client: httpx.Client) -> None:
    """Of a design that nobody has asked for: an answer that is kept is one line."""
    asked = {"design": {**DESIGN["design"], "motion": {"frames": 17}}}
    taken = {"accept-encoding": "gzip"}
    with client.stream("POST", "/api/verify", json=asked, headers=taken) as answer:
        assert "content-encoding" not in answer.headers
        chunks = list(answer.iter_raw())
    assert set(json.loads(chunks[0])) == {"progress", "what"}
    assert "result" in json.loads(b"".join(chunks).splitlines()[-1])


def test_pages_are_small() -> None:
    """In bytes of all its JavaScript, compressed as it travels: it opens at once on a phone."""
    scripts = sorted(PAGES.glob("assets/*.js"))
    if not scripts:
        lacking("the studio's pages have not been built: make pages")
    assert sum(len(gzip.compress(script.read_bytes())) for script in scripts) < 280_000


def test_files_of_hashed_names_are_kept(client: httpx.Client) -> None:
    if not (PAGES / "index.html").is_file():
        lacking("the studio's pages have not been built: make pages")
    page = client.get("/")
    assert page.headers["cache-control"] == "no-cache"
    again = client.get("/", headers={"if-none-match": page.headers["etag"]})
    assert again.status_code == 304
    files = re.findall(r'"\./(assets/[^"]+)"', page.text)
    assert {name.rpartition(".")[2] for name in files} == {"js", "css"}
    for name in files:
        found = client.get(f"/{name}")
        assert "immutable" in found.headers["cache-control"]
        assert found.headers["content-encoding"] == "gzip"
    assert "immutable" not in client.get("/assets/none.js").headers.get("cache-control", "")
