"""The server that Hops asks: descriptions of components, and what they make.

Each design has a process that keeps it, and another makes a new one: what takes long does not hold
up a drive of another design. One that was lost is made again.
"""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import AsyncIterator, Collection
from contextlib import asynccontextmanager
from typing import Any, Final

import orjson
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from orishell.conventions.errors import InputError
from orishell.studio.app import FAILURES, LIMITS, describe_failure, result_while_awaited
from orishell.studio.guard import Guard
from orishell.studio.hops.components import answer
from orishell.studio.hops.designs import digest_of
from orishell.studio.hops.key import PathKey
from orishell.studio.hops.protocol import GIVEN, UNITS, described, plain_value, refused
from orishell.studio.processes import prepared_copies
from orishell.studio.workers import Pool

PROCESSES: Final = 3
"""Designs that are made, or driven, at a time."""
SECONDS: Final = 95.0
"""Time that an answer may take; Hops waits for 100 s unless it is told otherwise."""
MOST_HOMES: Final = 1000
"""Designs of which it is known which process keeps them."""
NOT_KEPT: Final = 422
"""Status of refusals: Hops would keep those of status 200, after what was wrong is mended too."""
LENGTHY: Final = {"curves", "surface", "file", "verdict"}
"""Components that are stopped where nobody waits for them any more."""


class Homes:
    """Processes, and which of them keeps which design."""

    def __init__(self) -> None:
        # the one that was asked longest ago is the first
        self.pools = [Pool(answer, 1, SECONDS) for _ in range(PROCESSES)]
        self._homes: dict[bytes | None, Pool] = {}
        self._asked: Counter[int] = Counter()  # requests under way

    @asynccontextmanager
    async def pool_for(self, design: bytes | None) -> AsyncIterator[Pool]:
        """The process that keeps a design; else an idle one, asked longest ago."""
        idlest = min(self.pools, key=lambda each: self._asked[id(each)])
        pool = self._homes.get(design, idlest)
        self.pools.remove(pool)
        self.pools.append(pool)
        self._asked[id(pool)] += 1
        try:
            yield pool
        finally:
            self._asked[id(pool)] -= 1

    def keep(self, design: bytes, pool: Pool) -> None:
        """Note which process keeps a design."""
        self._homes.pop(design, None)
        self._homes[design] = pool
        while len(self._homes) > MOST_HOMES:
            del self._homes[next(iter(self._homes))]


def make_hops(key: PathKey, hosts: Collection[str] | None = None) -> Guard:
    """The server of the components.

    Parameters
    ----------
    key
        What a path begins with that is answered.
    hosts
        Host headers that are taken; None takes all.
    """
    homes = Homes()

    @asynccontextmanager
    async def life(_: Starlette) -> AsyncIterator[None]:
        with prepared_copies():
            yield
            for pool in homes.pools:
                pool.close()

    async def solve(request: Request) -> Response:
        try:
            return _json(await _solved(request, homes))
        except (*FAILURES, InputError) as error:
            failure = describe_failure(error)[1]["error"]["message"]
            return _json(
                refused(str(error) if isinstance(error, InputError) else failure), NOT_KEPT
            )

    routes = [
        Route("/{key}", _listed),
        Route("/{key}/", _listed),
        Route("/{key}/solve", solve, methods=["POST"]),
        Route("/{key}/{name}", _described),
    ]
    app = Starlette(routes=routes, lifespan=life)
    return Guard(app, key, hosts, LIMITS.bytes, LIMITS.receiving)


def _json(content: bytes, status: int = 200) -> Response:
    return Response(content, status, media_type="application/json; charset=utf-8")


def _listed(_: Request) -> Response:
    return _json(orjson.dumps([described(name) for name in GIVEN]))


def _described(request: Request) -> Response:
    """A component; else what Hops takes for one without ports, whose description says more."""
    name = request.path_params["name"]
    if name in GIVEN:
        return _json(orjson.dumps(described(name)))
    said = f"there is no such component; there are {', '.join(GIVEN)}"
    return _json(orjson.dumps({"Description": said, "Inputs": [], "Outputs": []}), 404)


async def _solved(request: Request, homes: Homes) -> bytes:
    """The answer of the component that a request points to."""
    name, payload, design = await asyncio.to_thread(_asked, await request.body())
    async with homes.pool_for(design) as pool:
        if name in LENGTHY:
            content = await result_while_awaited(pool, name, payload, request)
        else:
            content = await pool.run(name, payload)
    if design is None:
        first = (await asyncio.to_thread(orjson.loads, content))["values"][0]["InnerTree"]
        design = digest_of(first["0"][0]["data"])
    homes.keep(design, pool)
    return bytes(content)


def _asked(body: bytes) -> tuple[str, dict[str, Any], bytes | None]:
    """Component, payload for its process, and the design that it is asked of, if any."""
    try:
        asked = orjson.loads(body)
        name, values = str(asked["pointer"]).strip("/"), asked["values"]
        payload = {"values": values, "modelunits": UNITS.get(str(asked.get("modelunits")), "")}
        trees = [tree["InnerTree"] for tree in values if tree["ParamName"] == "design"]
        texts = [item["data"] for each in trees for items in each.values() for item in items]
        design = digest_of(str(plain_value(texts[0]))) if texts else None
    except (ValueError, KeyError, TypeError, AttributeError):
        what, remedy = "this is no request as Hops sends it", "update Hops"
        raise InputError(what, expected="pointer and values", remedy=remedy) from None
    if name not in GIVEN:
        what, remedy = "there is no such component", "set the component anew by its path"
        expected = f"one of {', '.join(GIVEN)}"
        raise InputError(what, got=repr(name[:40]), expected=expected, remedy=remedy)
    return name, payload, design
