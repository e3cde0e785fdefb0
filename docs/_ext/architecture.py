"""Pages that are read off the program: what is inside a package, the commands and their options."""

from __future__ import annotations

import ast
import importlib
import inspect
import itertools
import pkgutil
import re
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

import typer
from docutils.parsers.rst import directives
from field_notes import field_notes
from sphinx.util.docutils import SphinxDirective
from sphinx.util.inspect import TypeAliasForwardRef
from sphinx.util.nodes import make_refnode

from orishell.cli.main import app as command_line

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

    from docutils import nodes
    from sphinx.addnodes import pending_xref
    from sphinx.application import Sphinx
    from sphinx.environment import BuildEnvironment


# Within unions and tuples Sphinx shows an alias by its representation.
TypeAliasForwardRef.__repr__ = lambda self: self.name  # type: ignore[method-assign]


class Package(SphinxDirective):
    """A package: what it offers, and module by module where things stand in it.

    A package that lists its names in ``__all__`` keeps the rest to itself: of its modules only the
    texts, the constants, and the classes that `:show:` names are here. `:open:` names modules that
    it leaves to those who ask for them.
    """

    required_arguments = 1
    option_spec: ClassVar[dict[str, Callable[[str], Any]] | None] = {
        "show": directives.unchanged,
        "open": directives.unchanged,
    }

    def run(self) -> list[nodes.Node]:
        """Make the page's part."""
        self.shown, self.opened = (
            set(self.options.get(name, "").split()) for name in ("show", "open")
        )
        text = "\n".join(self._pages(self.arguments[0], listed=False))
        return self.parse_text_to_nodes(
            text, offset=self.content_offset, allow_section_headings=True
        )

    def _pages(self, name: str, *, listed: bool) -> Iterator[str]:
        """The text of a module and of those inside; `listed`: a package above lists its names."""
        module = importlib.import_module(name)
        if name in self.opened:
            listed = False
        constants = _constants(inspect.getsource(module))
        paths = [each for each in constants if isinstance(getattr(module, each), Path)]
        options = ":members:"
        if listed:
            shown = [each for each in constants if each not in paths]
            shown += [each for each in sorted(self.shown) if _is_defined(module, each)]
            options = f":members: {', '.join(shown)}" if shown else ""
        elif paths:  # they would name this machine
            options += f"\n   :exclude-members: {', '.join(paths)}"
        if name != self.arguments[0]:
            yield f"## {name.removeprefix(self.arguments[0] + '.')}\n"
        yield f"```{{eval-rst}}\n.. automodule:: {name}"
        yield (f"   {options}\n" if options else "") + "```\n"
        for found in sorted(
            pkgutil.iter_modules(getattr(module, "__path__", ())), key=lambda each: each.name
        ):
            inner = f"{name}.{found.name}"
            yield from self._pages(inner, listed=listed or hasattr(module, "__all__"))


def _is_defined(module: object, name: str) -> bool:
    thing = getattr(module, name, None)
    return getattr(thing, "__module__", None) == getattr(module, "__name__", None)


def _constants(source: str) -> list[str]:
    """Names in capitals that are given a value and, below it, a text."""
    body = ast.parse(source).body
    return [
        target.id
        for given, below in itertools.pairwise(body)
        if isinstance(given, ast.Assign | ast.AnnAssign)
        and isinstance(below, ast.Expr)
        and isinstance(below.value, ast.Constant)
        for target in (given.targets if isinstance(given, ast.Assign) else [given.target])
        if isinstance(target, ast.Name) and target.id.isupper() and not target.id.startswith("_")
    ]


class Commands(SphinxDirective):
    """Every command with its arguments and options, as `--help` has them."""

    def run(self) -> list[nodes.Node]:
        """Make the page's part."""
        text: list[str] = []
        for name, command in typer.main.get_group(command_line).commands.items():
            text += [f"## orishell {name}", "", inspect.cleandoc(command.help or ""), ""]
            for each in command.params:
                if each.name == "help":
                    continue
                flags = ", ".join([*each.opts, *each.secondary_opts])
                is_option = flags.startswith("-")
                call = f"`{flags}`" if is_option else f"`{each.name.upper()}`"
                text += [f"{call}", f": {getattr(each, 'help', None) or ''}", ""]
        return self.parse_text_to_nodes(
            "\n".join(text), offset=self.content_offset, allow_section_headings=True
        )


def find_constant(
    app: Sphinx, env: BuildEnvironment, node: pending_xref, shown: nodes.TextElement
) -> nodes.reference | None:
    """A constant by its bare name, as docstrings of its module call it, if one only has it."""
    target = node.get("reftarget", "")
    if node.get("reftype") not in {"data", "func", "class"} or "." in target:
        return None
    found = sorted(
        (entry.docname, entry.node_id)
        for name, entry in env.domaindata["py"]["objects"].items()
        if name.endswith(f".{target}") and not entry.aliased
    )
    package = f"{node.get('py:module')}."
    near = [each for each in found if each[1].startswith(package)]
    found = near if len(near) == 1 else found
    if len(found) != 1:
        return None
    return make_refnode(app.builder, node["refdoc"], *found[0], shown, target)


def keep_text(_app: Sphinx, what: str, *rest: object) -> None:
    """Keep napoleon from reading "Columns 1 ... n: those that ..." as a type and a text.

    And make links of the pages that modules name.
    """
    lines = rest[-1]
    assert isinstance(lines, list)
    lines[:] = [re.sub(r"\bdocs/(theory/[\w-]+)\.md\b", r":doc:`/\1`", line) for line in lines]
    if what in {"attribute", "data", "property"}:
        lines[:0] = ["..", ""]  # an empty comment: it ends what napoleon takes for a type


def list_fields(
    _app: Sphinx, what: str, _name: str, thing: object, _options: object, lines: list[str]
) -> None:
    """Show what comments say of the fields of a class as its parameters."""
    if what != "class" or not isinstance(thing, type):
        return
    notes = field_notes(thing)
    if notes:
        entries = [line for name, note in notes.items() for line in (name, f"    {note}")]
        lines[:] = [*lines, "", "Parameters", "----------", *entries, ""]


def mend_links(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.Node | None
) -> None:
    """Make links from a source lead to where the reference has what it defines.

    viewcode takes it that all of a module is documented under one name; here a package documents
    what it lists, and the module the rest.
    """
    del template, doctree
    if not page.startswith("_modules/orishell"):
        return
    module = page.removeprefix("_modules/").replace("/", ".")
    objects = app.env.domaindata["py"]["objects"]
    places = {entry.node_id for entry in objects.values()}

    def mended(match: re.Match[str]) -> str:
        parts = match[1].split(".")
        tails = [".".join(parts[k:]) for k in range(1, len(parts))]
        own = (
            f"{package}.{tail}"
            for package in (module, module.rpartition(".")[0])
            for tail in tails
            if f"{package}.{tail}" in objects
        )
        return match[0] if match[1] in places else f'#{objects[next(own)].node_id}"'

    context["body"] = re.sub(r'#(orishell[\w.]+)"', mended, context["body"])


def own_module(_app: Sphinx, module: str, name: str) -> str | None:
    """Where a type such as ``Annotated[float, ...]`` is defined: viewcode takes it for float's."""
    thing = getattr(importlib.import_module(module), name.partition(".")[0], None)
    return module if getattr(thing, "__module__", "") == "builtins" else None


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives and the search for bare names."""
    app.add_directive("package", Package)
    app.add_directive("commands", Commands)
    app.connect("missing-reference", find_constant)
    app.connect("autodoc-process-docstring", list_fields, priority=300)
    app.connect("autodoc-process-docstring", keep_text, priority=400)
    app.connect("html-page-context", mend_links)
    app.connect("viewcode-follow-imported", own_module)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
