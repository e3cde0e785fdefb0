"""Errors as the studio's pages are told of them."""

from __future__ import annotations

from typing import Any

from orishell.conventions.errors import DesignError, InputError, OrishellError
from orishell.studio.api import NAME, FaultKind, Refusal


class RefusalError(OrishellError):
    """A request is refused; ``body`` is the answer to send."""

    def __init__(self, body: Refusal) -> None:
        super().__init__(body["error"]["message"])
        self.body = body


def make_refusal(kind: FaultKind, what: str, **more: Any) -> Refusal:
    """The answer to a request that failed; fields that are not given are empty."""
    names = ("where", "got", "expected", "remedy", "detail", "place", "size", "limit")
    said = {"kind": kind, "message": what, "what": what, "keys": [], "remedies": [], **more}
    fault: Any = {**dict.fromkeys(names, ""), **said}
    return {"error": fault}


def describe_error(error: OrishellError) -> Refusal:
    """The answer to a request that raised an error."""
    match error:
        case RefusalError():
            return error.body
        case DesignError():
            remedies = [
                {"text": str(remedy), "changes": dict(remedy.changes)} for remedy in error.remedies
            ]
            facts = _facts(error, "place", "size", "limit")
            return make_refusal("design", error.condition, remedies=remedies, **facts)
        case InputError():
            if error.file == f"{NAME}.toml":  # it has no name that anybody gave it
                error.file = ""
            facts = _facts(error, "where", "got", "expected", "remedy", "detail")
            tried = [{"text": error.remedy, "changes": error.changes}] if error.changes else []
            return make_refusal("input", error.what, remedies=tried, **facts)
        case _:
            return make_refusal("fault", str(error))


def _facts(error: DesignError | InputError, *names: str) -> dict[str, Any]:
    facts = {name: getattr(error, name) for name in names}
    return {**facts, "message": str(error), "keys": list(error.keys)}
