"""Sixty mistakes of people who begin: what they wrote, and what the first message has to name."""

from __future__ import annotations

from dataclasses import dataclass, field

SHELL = """
[shell]
family = "parallel-repeating"
unit = "m"

[target.f]
formula = "-x**2"
range = [-1, 1]

[target.g]
formula = "5*sin(pi*x/10)"
range = [0, 20]

[pattern]
rows = 5
columns = 5
flap = 0.3
xi_deg = 50
"""
LOADED = """
[panel]
thickness = 0.01
membrane = 0.001

[structure]
material = "birch plywood"
line_strength = { kind = "piano hinge" }
supports = [{ at = "feet", kind = "pinned" }]

[[load_case]]
name = "winter"
snow = { ground = 500 }

[workshop]
row_hinge = "piano hinge"
paper = "A3"
"""
DESIGN = ("design", "shell.toml", "--out", "out")
Words = tuple[str, ...]


@dataclass(frozen=True)
class Mistake:
    """What somebody wrote, and what the first message names: what, where, and what to do."""

    says: Words
    old: str = ""  # what of the file is written otherwise
    new: str = ""
    command: Words = DESIGN
    status: int = 2
    encoding: str = "utf-8"
    beside: dict[str, str] = field(default_factory=dict)  # other files, by their names

    @property
    def text(self) -> str:
        """The design file."""
        text = SHELL + LOADED
        assert self.old in text
        return text.replace(self.old, self.new) if self.old else text + self.new


def _f(new: str, *says: str) -> Mistake:
    return Mistake(("[target.f]", *says), 'formula = "-x**2"', new)


def _asks(old: str, new: str, where: str, *meant: str) -> Mistake:
    return Mistake((where, f"Did you mean {' or '.join(meant)}?"), old, new)


def _line(old: str, new: str, says: str, line: int = 0) -> Mistake:
    return Mistake((f"line {line}: this is not TOML" if line else "not TOML", says), old, new)


def _called(*command: str, says: Words) -> Mistake:
    return Mistake(says, command=command)


OURS = {
    "half a key": _asks("xi_deg", "xi", "[pattern] xi: unknown key", "xi_deg"),
    "a shorter key": _asks("columns", "col", "[pattern] col: unknown key", "columns"),
    "a dash": _asks("xi_deg", "xi-deg", "[pattern] xi-deg: unknown key", "xi_deg"),
    "a table of another name": _asks("target.f", "curve", "[curve]: unknown key", "[target.f]"),
    "a table within of another name": _asks("target.f", "target.curve", "curve]", "[target.f]"),
    "several of a table": _asks("[panel]", "[panels]", "[panels]: unknown key", "[panel]"),
    "loads": _asks("[[load_case]]", "[[loads]]", "[loads]: unknown key", "[[load_case]]"),
    "a curve that is a text": Mistake(
        ("[target.f]: this value", "expected a table", 'formula = "-x**2"', "range = [-1, 1]"),
        '[target.f]\nformula = "-x**2"\nrange = [-1, 1]\n',
        '[target]\nf = "-x**2"\n',
    ),
    "half a family": _asks('"parallel-repeating"', '"parallel"', "family", "parallel-repeating"),
    "half a task": _called("new", "dom", says=("TASK", "no such task", "Did you mean dome?")),
    "a command's slip": _called("desing", says=("No such command 'desing'", "'design'")),
    "an option's slip": _called("design", "shell.toml", "--ot", "o", says=("--ot", "--out")),
    "a format's slip": _called(*DESIGN, "--write", "dfx", says=("--write", "Did you mean dxf?")),
    "half a material": _asks("birch ", "", "[structure] material", '"birch plywood"'),
    "half a hinge": _asks("piano hinge", "piano", "line_strength kind", '"piano hinge"'),
    "one gusset": _asks("", '[stiffeners]\nkind = "gusset"', "[stiffeners] kind", '"gussets"'),
    "no unit": Mistake(
        ("[shell] unit: this key is missing", "expected mm, cm, m, in or ft", 'add unit = "m"'),
        'unit = "m"\n',
    ),
    "a unit in words": _asks('"m"', '"metres"', "[shell] unit", '"m"'),
    "typographic quotes": _line('"-x**2"', "“-x**2”", 'quotes: formula = "-x**2"', 7),
    "a decimal comma": _line("flap = 0.3", "flap = 0,3", "write 0.3"),
    "a decimal comma in a formula": _f('formula = "-0,5*x"', "not a comma", "write 0.5"),
    "a colon": _line("rows = 5", "rows: 5", "write rows = 5"),
    "true in capitals": _line("[-1, 1]", "[-1, 1]\nreverse = True", "write true", 9),
    "Latin 1": Mistake(
        ("line 2: ", "not in UTF-8", "in Latin 1 ü", "save it with the encoding UTF-8"),
        "\n[shell]",
        "\n# für Zürich\n[shell]",
        encoding="latin-1",
    ),
    "a path of Windows": Mistake(
        ("line 7: ", "backslash", "'C:\\Users\\me\\p.svg'", "C:/Users/me/p.svg"),
        'formula = "-x**2"\nrange = [-1, 1]',
        'svg = "C:\\Users\\me\\p.svg"',
    ),
    "a path of Windows that is TOML": Mistake(
        ("[target.f]", "does not exist", "backslash in double quotes", "single quotes"),
        'formula = "-x**2"\nrange = [-1, 1]',
        'points = "C:\\temp\\new.csv"',
    ),
    "degrees": Mistake(
        ("formulas take radians", "sin(18*x)", "If degrees were meant", "sin(18*x*pi/180)"),
        "5*sin(pi*x/10)",
        "5*sin(18*x)",
        status=1,
    ),
    "a range in degrees": Mistake(
        ("[target.g] range", "radians", '"180*pi/180"'),
        '"5*sin(pi*x/10)"\nrange = [0, 20]',
        '["5*cos(t)", "5*sin(t)"]\nrange = [0, 180]',
    ),
    "millimetres in metres": _asks(
        "thickness = 0.01", "thickness = 10", "[panel]", "10 mm, which is thickness = 0.01"
    ),
    "a tolerance that nothing meets": Mistake(
        ("within 1e-05", "the nearest found", "works: surface = ", "in [tolerance]"),
        "rows = 5\ncolumns = 5\n" + LOADED[:0] + "flap = 0.3\nxi_deg = 50\n" + LOADED,
        "flap = 0.3\nxi_deg = 50\n\n[tolerance]\nsurface = 1e-5\n",
        status=1,
    ),
}
"""Thirty that were reported, or made by us."""

THEIRS = {
    "no file of that name": _called(
        "design", "shel.toml", "--out", "out", says=("shel.toml: ", "Did you mean shell.toml?")
    ),
    "no ending": _called("design", "shell", "--out", "o", says=("exist", "mean shell.toml?")),
    "a mesh for a design": Mistake(
        ("roof.obj: this is no design file", "orishell new canopy --mesh roof.obj"),
        command=("design", "roof.obj", "--out", "out"),
        beside={"roof.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    ),
    "a drawing in other capitals": Mistake(
        ("[target.f]", "does not exist", "Did you mean profile.svg?"),
        'formula = "-x**2"\nrange = [-1, 1]',
        'svg = "Profile.SVG"',
        beside={"profile.svg": "<svg/>"},
    ),
    "a size in words of its own": _called(
        "new", "screen", "6", "x", "3", says=("FILE", "got 6 x 3", "--size 6x3?")
    ),
    "a size of three words": _called(
        "new", "screen", "--size", "6", "x", "3", says=("got 6 x 3", "--size 6x3?")
    ),
    "a size with a comma": _called("new", "screen", "--size", "6,3", says=("--size", "as 6x3")),
    "a diameter alone": _called("new", "dome", "5", says=("FILE", "mean --diameter 5?")),
    "a mesh without its option": _called(
        "new", "canopy", "my/roof.obj", says=("FILE", "mean --mesh my/roof.obj?")
    ),
    "the file before the task": _called(
        "new", "mydome.toml", says=("TASK", "comes before the file", "new dome mydome.toml")
    ),
    "a family for a task": _called(
        "new", "flat-foldable", says=("a family", "orishell new --family flat-foldable")
    ),
    "a state in other words": _called(
        *DESIGN, "--state", "packed", says=("--state", "Did you mean pack?")
    ),
    "another ending": _called("convert", "a.fold", "a.dfx", says=("a.dfx", "mean .dxf?")),
    "a design file to check": _called("check", "shell.toml", says=("shell.toml", ".fold")),
    "a product without its sign": _f('formula = "2x"', "character 1", "write products with *: 2*x"),
    "a square without its sign": _f('formula = "-x2"', "'x2'", "Did you mean x**2 or 2*x?"),
    "a function of another program": _f('formula = "arctan(x)"', "'arctan'", "mean atan?"),
    "a function without parentheses": _f('formula = "sin x"', "not a formula", "write sin(x)"),
    "x for y": _f('formula = "x = t**2"', "to give y", "'x = t**2'"),
    "a formula without quotes": _line('"-x**2"', "-x**2", 'put texts in quotes: "-x**2"', 7),
    "a list without its comma": _line("[-1, 1]", "[-1 1]", "commas between entries: [-1, 1]", 8),
    "round brackets": _line("[-1, 1]", "(-1, 1)", "square brackets", 8),
    "a unit behind a number": _line("flap = 0.3", "flap = 30 cm", "write 0.3, without a unit"),
    "a unit in quotes": Mistake(
        ("[panel] thickness", "'10 mm'", "write 0.01 without quotes: lengths are in m"),
        "thickness = 0.01",
        'thickness = "10 mm"',
    ),
    "a table that is left open": _line("[pattern]", "[pattern", "write [pattern]"),
    "a key twice": _line("rows = 5", "rows = 5\nrows = 7", "rows is given twice"),
    "a key in another table": _asks("flap =", "family =", "[pattern] family", "family in [shell]"),
    "a number for a table": Mistake(
        ("[[load_case]][0] snow", "expected a table", "write snow = { ground = 500 }"),
        "{ ground = 500 }",
        "500",
    ),
    "a text for a list": Mistake(
        ("[structure] supports", 'write supports = [{ at = "feet", kind = "pinned" }]'),
        '[{ at = "feet", kind = "pinned" }]',
        '"feet"',
    ),
    "a scale as on plans": Mistake(
        ("[workshop] paper_scale", "'1 : 50'", "write 0.02 without quotes"),
        'paper = "A3"',
        'paper_scale = "1 : 50"',
    ),
}
"""Thirty more, of architects, makers and researchers."""
