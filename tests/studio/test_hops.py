"""orishell in Grasshopper: what Hops asks and gets, of every component."""

from __future__ import annotations

import json
import re
import stat
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

from hops_client import Document, HopsError, running_hops, sent_as
from hops_pictures import PICTURES, PLACE, draw
from orishell import check_design, make_shell
from orishell.conventions.errors import InputError
from orishell.conventions.toml_file import parse_toml
from orishell.io.rhino_geometry import rhino3dm
from orishell.studio.hops.key import kept_word
from orishell.studio.hops.protocol import GIVEN
from samples import thorough

rhino = rhino3dm()
ROOT = Path(__file__).parents[2]
UNITS = {"Meters": 1.0, "Millimeters": 1000.0}
BOARDS = "xi_deg = 50\n[panel]\nthickness = 0.004\nmembrane = 0.001"


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """Where ``orishell hops`` answers, with the key."""
    with running_hops() as found:
        yield found


@pytest.fixture(scope="module")
def client(address: str) -> Iterator[httpx.Client]:
    """Whoever has the address."""
    with httpx.Client(base_url=f"{address}/", timeout=120) as opened:
        yield opened


@pytest.fixture
def document(client: httpx.Client) -> Document:
    return Document(client)


def at(x: float, y: float, z: float = 0.0) -> Any:
    return rhino.Point3d(x, y, z)


def arch(size: float = 1.0) -> Any:
    """An arc of 1 m to both sides, in x and z."""
    ends = (at(-size, 0, 0), at(0, 0, 0.6 * size), at(size, 0, 0))
    return rhino.ArcCurve.CreateFromArc(rhino.Arc(*ends))


def wave(size: float = 1.0) -> Any:
    """A spline of 9 m in plan."""
    places = [(0, 0), (3, 2), (6, -2), (9, 1)]
    return rhino.NurbsCurve.Create(False, 3, [at(size * x, size * y) for x, y in places])


def roof(size: float = 1.0) -> Any:
    """A vault of 4 x 6 m as a mesh."""
    mesh = rhino.Mesh()
    for x in np.linspace(-2, 2, 13).tolist():
        for y in np.linspace(0, 6, 13).tolist():
            mesh.Vertices.Add(size * x, size * y, size * (1 - x * x / 4))
    for k in (13 * i + j for i in range(12) for j in range(12)):
        mesh.Faces.AddFace(k, k + 13, k + 14, k + 1)
    return mesh


def designed(document: Document, **given: Any) -> str:
    """The design of an arc and a spline."""
    size = UNITS[document.unit]
    found = document.solve("curves", f=arch(size), g=wave(size), **given)
    text: str = found["design"]
    return text


def vertices(mesh: Any) -> Any:
    places = (mesh.Vertices.Point3dAt(k) for k in range(len(mesh.Vertices)))
    return np.array([[each.X, each.Y, each.Z] for each in places])


def test_all_components_are_listed_as_they_are_described(document: Document) -> None:
    listed = document.client.get("").json()
    assert [each["Uri"] for each in listed] == [f"/{name}" for name in GIVEN]
    for each in listed:
        assert document.place(each["Uri"][1:]) == each
        assert "svg" in each["Icon"]
        assert "xmlns" in each["Icon"]  # else Hops takes it for a PNG
        assert all(port["Description"] for port in (*each["Inputs"], *each["Outputs"]))


@pytest.mark.parametrize("unit", UNITS)
def test_the_shell_is_the_one_of_its_design_file(client: httpx.Client, unit: str) -> None:
    """The text that is handed on is a design file, whose shell stands where Grasshopper has it."""
    document, size = Document(client, unit), UNITS[unit]
    text = designed(document, keys="xi_deg = 50")
    tables = parse_toml(text)
    radii = re.findall(r"A([\d.]+) ([\d.]+) ", tables["target"]["f"]["path"])
    assert np.array(radii, float) == pytest.approx(size * 3.4 / 3, abs=1e-12 * size)  # the arc
    shell = make_shell(check_design(tables, Path("shell.toml"), files=False))
    assert shell.file.unit == {"Meters": "m", "Millimeters": "mm"}[unit]
    target = shell.design.mechanism.target_drive
    for share in (0.0, 0.37, 1.0):
        found = document.solve("state", design=text, drive=share)
        ours = shell.positions(share * target).reshape(-1, 3)
        assert np.abs(vertices(found["mesh"]) - ours).max() < 1e-12 * size
        counts = len(found["mountains"]), len(found["valleys"])
        assert counts == (shell.report.assignment.mountain, shell.report.assignment.valley)
        lengths = [
            np.linalg.norm([line["To"][k] - line["From"][k] for k in "XYZ"])
            for line in found["mountains"] + found["valleys"]
        ]
        if share == 0.0:
            flat = sorted(lengths)
        assert sorted(lengths) == pytest.approx(flat, abs=1e-11 * size)  # none stretches
    assert min(point["Z"] for point in found["feet"]) == pytest.approx(0, abs=1e-12 * size)


def test_a_design_in_metres_in_a_document_in_millimetres(client: httpx.Client) -> None:
    metres = designed(Document(client), keys=BOARDS)
    document = Document(client, "Millimeters")
    text = designed(document, keys=BOARDS, unit="m")
    for name, output in (("state", "mesh"), ("boards", "boards")):
        theirs, ours = (
            each.solve(name, design=design, drive=0.5)[output]
            for each, design in ((Document(client), metres), (document, text))
        )
        first, second = (
            vertices(each[0] if isinstance(each, list) else each) for each in (theirs, ours)
        )
        assert np.abs(1000 * first - second).max() < 1e-8


def test_panels_boards_and_pattern(document: Document) -> None:
    text = designed(document, keys=BOARDS)
    panels = document.solve("panels", design=text, drive=1.0)
    assert len(panels["outlines"]) == len(panels["planes"]) == 10 * 12
    for outline, plane in zip(panels["outlines"], panels["planes"], strict=True):
        normal, origin = (np.array([plane[name][k] for k in "XYZ"]) for name in ("ZAxis", "Origin"))
        corners = [outline.Point(k) for k in range(outline.PointCount)]
        off = np.array([[each.X, each.Y, each.Z] for each in corners]) - origin
        assert np.abs(off @ normal).max() < 1e-9
    boards = document.solve("boards", design=text, drive=0.5)
    assert len(boards["boards"]) == len(boards["names"]) == 2 * len(panels["outlines"])
    assert all(mesh.IsClosed for mesh in boards["boards"])
    pattern = document.solve("pattern", design=text)
    assert pattern["outlines"].IsClosed
    state = document.solve("state", design=text, drive=0.0)
    assert len(pattern["mountains"]) == len(state["mountains"])


def test_a_surface_as_mesh_and_as_nurbs(document: Document) -> None:
    vault = rhino.NurbsSurface.CreateRuledSurface(
        rhino.NurbsCurve.Create(False, 2, [at(-2, 0, 0), at(0, 0, 2), at(2, 0, 0)]),
        rhino.NurbsCurve.Create(False, 2, [at(-2, 6, 0), at(0, 6, 2), at(2, 6, 0)]),
    )
    given = {"rows": 7, "columns": 9, "flap": "0"}
    drawn = document.solve("surface", surface=roof(), **given)
    assert document.warnings == []
    exact = document.solve("surface", surface=rhino.Brep.CreateFromSurface(vault), **given)
    (warning,) = document.warnings
    assert "became a mesh" in warning
    first, second = (
        vertices(document.solve("state", design=each["design"])["mesh"]) for each in (drawn, exact)
    )
    assert np.abs(np.ptp(first, axis=0) - np.ptp(second, axis=0)).max() < 0.1


def test_a_design_file_is_read_with_the_files_that_it_names(
    document: Document, tmp_path: Path
) -> None:
    text = designed(document, keys="xi_deg = 50")
    tables = parse_toml(text)
    points: list[list[float]] = [[-1, 0], [-0.5, 0.5], [0.5, 0.5], [1, 0]]
    (tmp_path / "f.csv").write_text("x,y\n" + "".join(f"{x},{y}\n" for x, y in points))
    import tomli_w

    tables["target"]["f"] = {"points": "f.csv", "smooth": False}
    path = tmp_path / "shell.toml"
    path.write_text(tomli_w.dumps(tables))
    found = document.solve("file", path=str(path))
    assert parse_toml(found["design"])["target"]["f"]["points"] == points
    path.write_text(tomli_w.dumps(tables | {"pattern": {**tables["pattern"], "rows": 5}}))
    assert document.solve("file", path=str(path)) == found  # Hops keeps what it got
    again = document.solve("file", path=str(path), again=1)
    assert parse_toml(again["design"])["pattern"]["rows"] == 5


def test_verdict_and_files(document: Document, tmp_path: Path) -> None:
    text = designed(document, keys="xi_deg = 50")
    found = document.solve("verdict", design=text)
    assert found["feasible"] is True
    assert any("proved" in row for row in found["rows"])
    folder = tmp_path / "kit"
    assert document.solve("files", design=text, folder=str(folder))["files"] == []
    assert not folder.exists()
    written = document.solve("files", design=text, folder=str(folder), write=True)["files"]
    assert all(Path(each).is_file() for each in written)
    mine = tmp_path / "mine" / "README.md"
    mine.parent.mkdir()
    mine.write_text("mine")
    with pytest.raises(HopsError, match=r"README\.md"):
        document.solve("files", design=text, folder=str(mine.parent), write=True)
    assert mine.read_text() == "mine"


def test_a_refusal_has_a_remedy_that_works(document: Document) -> None:
    with pytest.raises(HopsError, match="Nearest found that works: xi_deg = ") as refused:
        designed(document, keys="xi_deg = 140")
    (remedy,) = re.findall(r"xi_deg = ([\d.]+)\.", str(refused.value))
    assert document.solve("verdict", design=designed(document, keys=f"xi_deg = {remedy}"))


BAD: dict[str, tuple[str, dict[str, Any], str]] = {
    "no curve": ("curves", {"f": rhino.Mesh()}, "input f: this does not fit; got Mesh"),
    "a text for a curve": ("curves", {"f": "x**2"}, "input f: this does not fit; got System.Str"),
    "a closed curve": (
        "curves",
        {"f": rhino.ArcCurve.CreateFromCircle(rhino.Circle(at(0, 0), 1.0))},
        "the curve is closed",
    ),
    "a broken object": (
        "curves",
        {"f": {"type": "Rhino.Geometry.NurbsCurve", "data": '{"version":10000,"data":"AAAA"}'}},
        "input f: this does not fit",
    ),
    "a curve in space": (
        "curves",
        {"f": rhino.NurbsCurve.Create(False, 2, [at(0, 0, 0), at(1, 1, 1), at(2, 0, 1)])},
        "not flat",
    ),
    "g that climbs": ("curves", {"g": rhino.LineCurve(at(0, 0, 0), at(9, 0, 1))}, "Project"),
    "two curves": ("curves", {"f": [arch(), arch()]}, "input f: one value is expected; got 2"),
    "no value": ("curves", {"f": []}, "input f: one value is expected; got 0"),
    "no family": ("curves", {"family": "paralel-repeating"}, "parallel-repeating"),
    "an even number of rows": ("curves", {"rows": 8}, "an odd number"),
    "half a row": ("curves", {"rows": 8.5}, "input rows: this does not fit"),
    "a sheet too large": ("curves", {"rows": 1001, "columns": 1000}, "too large"),
    "no flap": ("curves", {"flap": "wide"}, "[pattern] flap"),
    "no unit": ("curves", {"unit": "furlong"}, "input unit: the unit of the design is not known"),
    "no TOML": ("curves", {"keys": "xi_deg = = 3"}, "TOML"),
    "no such key": ("curves", {"keys": "xi_dge = 3"}, "xi_deg"),
    "two targets": ("curves", {"keys": '[target.pattern]\nfile = "x.svg"'}, "either f and g"),
    "no surface": ("surface", {"surface": arch()}, "neither a mesh nor a surface"),
    "six faces": (
        "surface",
        {"surface": rhino.Brep.CreateFromBox(rhino.Box(rhino.BoundingBox(0, 0, 0, 1, 2, 3)))},
        "Mesh Brep",
    ),
    "no such file": ("file", {"path": "/nowhere/shell.toml"}, "shell.toml"),
    "half a path": ("file", {"path": "shell.toml"}, "File Path"),
    "no design": ("state", {"design": "a design"}, "TOML"),
    "beyond the motion": ("state", {"drive": 1.5}, "the range 0 to 1"),
    "not a number": ("state", {"drive": "wide"}, "input drive: this does not fit"),
    "no boards": ("boards", {}, "add the table [panel]"),
    "no place": ("files", {"folder": "kit", "write": True}, "a whole path"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_inputs_are_said_on_the_component(document: Document, name: str) -> None:
    component, given, words = BAD[name]
    usual: dict[str, dict[str, Any]] = {
        "curves": {"f": arch(), "g": wave()},
        "state": {"design": ""},
        "boards": {"design": ""},
        "files": {"design": ""},
    }
    inputs = usual.get(component, {}) | given
    if inputs.get("design") == "":
        inputs["design"] = designed(document, keys="xi_deg = 50")
    with pytest.raises(HopsError) as refused:
        document.solve(component, **inputs)
    assert words in str(refused.value)
    assert "fault of the program" not in str(refused.value)


def test_a_shell_in_strips_is_driven_from_where_it_is_open(document: Document) -> None:
    found = document.solve("curves", f=arch(), g=wave(), family="t-hedral", flap="0")
    assert vertices(document.solve("state", design=found["design"], drive=0)["mesh"]).size
    with pytest.raises(HopsError, match="from 0, open, to 1"):
        document.solve("state", design=found["design"], drive=-0.1)


@pytest.mark.parametrize(
    "body",
    [
        "",
        "[]",
        "{}",
        '{"pointer": "none", "values": []}',
        '{"pointer": "state", "values": 5}',
        '{"pointer": "state", "values": [{"ParamName": "design", "InnerTree": {"0": [5]}}]}',
    ],
)
def test_requests_that_hops_never_sends(document: Document, body: str) -> None:
    answer = document.client.post(
        "solve", content=body, headers={"content-type": "application/json"}
    )
    assert answer.status_code == 422
    (message,) = answer.json()["errors"]
    assert "Remedy" in message


def test_who_has_no_key_gets_nothing(address: str) -> None:
    place, _, word = address.rpartition("/")
    wrong = ["", "/", "/curves", "/solve", f"/{word[:-1]}/", f"/{word}x/curves", f"/?key={word}"]
    with httpx.Client(timeout=30) as stranger:
        for path in [*wrong, f"//{word}/curves", f"/x/{word}"]:
            for method in ("GET", "POST"):
                answer = stranger.request(method, f"{place}{path}", json={})
                assert answer.status_code == 403, path
                assert "json" not in answer.headers["content-type"]  # Hops takes it for no server
        for header in ({"host": "evil.example"}, {"origin": "https://evil.example"}):
            assert stranger.get(f"{address}/curves", headers=header).status_code == 403
        plain = stranger.post(f"{address}/solve", content="{}")
        assert plain.status_code == 415


def test_the_key_stays_and_is_for_its_user_only(tmp_path: Path) -> None:
    place = tmp_path / "key"
    word = kept_word(place)
    assert stat.S_IMODE(place.stat().st_mode) == 0o600
    assert kept_word(place) == word
    assert kept_word(place, new=True) != word
    place.chmod(0o644)
    with pytest.raises(InputError, match="others can read"):
        kept_word(place)
    place.chmod(0o600)
    place.write_text("short")
    with pytest.raises(InputError, match=r"no key.*--new-key"):
        kept_word(place)
    with pytest.raises(InputError, match="--new-key"):
        kept_word(tmp_path / "none" / "key")


def test_a_design_is_not_lost_with_its_process(client: httpx.Client) -> None:
    """What was designed before a restart is driven after it: the text has all."""
    text = (ROOT / "examples" / "shelter.toml").read_text()
    tables = parse_toml(text)
    tables["motion"] = {"frames": 3}
    import tomli_w

    found = Document(client).solve("state", design=tomli_w.dumps(tables), drive=0.5)
    assert found["mesh"]


@pytest.mark.slow
def test_a_heavy_design_holds_up_no_drive_of_another_document(client: httpx.Client) -> None:
    """Two documents at once: one designs a fitted shell while the other is driven."""
    first, second = Document(client), Document(client, "Millimeters")
    text = designed(first, keys="xi_deg = 50")
    first.solve("state", design=text, drive=0.1)
    heavy = {"surface": roof(1000), "family": "flat-foldable", "rows": 5, "columns": 6}
    ended: list[float] = []

    def design() -> None:
        second.solve("surface", **heavy)
        ended.append(time.monotonic())

    thread = threading.Thread(target=design)
    thread.start()
    time.sleep(0.3)
    for share in np.linspace(0.2, 0.8, 7).tolist():
        first.solve("state", design=text, drive=share)
    driven = time.monotonic()
    thread.join()
    assert driven < ended[0]


@thorough  # a drive, and another one while a design is made: the tests beside it
def test_a_thousand_drives_of_two_designs(client: httpx.Client) -> None:
    """In a row, by two documents in turns; none gets the other's."""
    documents = [Document(client), Document(client, "Millimeters")]
    texts = [designed(each, keys="xi_deg = 50", rows=5, columns=4) for each in documents]
    bodies = [
        each.body("state", design=text, drive=0.123456)
        for each, text in zip(documents, texts, strict=True)
    ]
    sizes = []
    for turn in range(1000):
        which = turn % 2
        body = json.dumps(bodies[which]).replace("0.123456", repr(turn / 1000))
        answer = client.post("solve", content=body, headers={"content-type": "application/json"})
        assert answer.status_code == 200
        (foot, *_) = answer.json()["values"][5]["InnerTree"]["0"]
        sizes.append(np.linalg.norm([*json.loads(foot["data"]).values()]))
    assert min(sizes[1::2]) > 50 * max(sizes[::2]) > 0


def test_the_guide_names_every_component_and_port() -> None:
    page = (ROOT / "docs" / "guide" / "grasshopper.md").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| \*\*(.+?)\*\* \| (.*)$", page, re.MULTILINE))
    assert list(rows) == [each["name"] for each in GIVEN.values()]
    for component in GIVEN.values():
        ports = {*component["inputs"], *component["outputs"]}
        named = {*re.findall(r"`(\w+)`", rows[component["name"]])}
        if "the rest alike" in rows[component["name"]]:
            named |= ports & {*GIVEN["curves"]["inputs"]}
        assert named == ports


@pytest.mark.parametrize("name", PICTURES)
def test_pictures_of_the_guide_are_of_the_ports_as_they_are(name: str) -> None:
    assert (PLACE / name).read_text(encoding="utf-8") == draw(name)


def test_values_are_sent_as_the_client_says_that_hops_does() -> None:
    assert sent_as(5) == {"type": "System.Int32", "data": "5"}
    kinds = {sent_as(each)["type"] for each in (arch(), roof(), wave(), rhino.PolylineCurve([]))}
    assert kinds == {f"Rhino.Geometry.{each}" for each in ("ArcCurve", "Mesh", "NurbsCurve")} | {
        "Rhino.Geometry.PolylineCurve"
    }
