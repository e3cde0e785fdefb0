"""VTU and PVD, read back by meshio and as XML."""

from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import meshio
import numpy as np
import pytest

from documents import FAMILIES, demo_document, flat_only, folded_only, loaded_document
from orishell.conventions.errors import InputError
from orishell.document import Document, DocumentState
from orishell.io.format import Settings
from orishell.io.formats.vtk import write_vtk

DEMO = demo_document()


def series(path: Path) -> list[tuple[float, str]]:
    """Times and files that a PVD file lists."""
    return [
        (float(entry.attrib["timestep"]), entry.attrib["file"])
        for entry in ET.parse(path).getroot().iter("DataSet")
    ]


@pytest.mark.parametrize("family", FAMILIES)
def test_every_state_to_the_bit(family: str, tmp_path: Path) -> None:
    document = demo_document(family)
    write_vtk(tmp_path / "shell.vtu", document, Settings())
    listed = series(tmp_path / "shell.pvd")
    assert [name for _, name in listed] == [
        f"shell-{number:04d}.vtu" for number in range(len(document.states))
    ]
    assert [time for time, _ in listed] == [state.drive_deg for state in document.states]
    for (_, name), state in zip(listed, document.states, strict=True):
        mesh = meshio.read(tmp_path / name)
        np.testing.assert_array_equal(mesh.points, state.positions)
        np.testing.assert_array_equal(mesh.cells_dict["quad"], document.mesh.faces)
        assert mesh.field_data["drive_deg"] == state.drive_deg
    last = (tmp_path / listed[-1][1]).read_bytes()
    assert (tmp_path / "shell.vtu").read_bytes() == last


def test_panels_by_number_row_and_column(tmp_path: Path) -> None:
    write_vtk(tmp_path / "shell.vtu", DEMO, Settings())
    data = meshio.read(tmp_path / "shell.vtu").cell_data
    panels, rows, columns = (data[name][0] for name in ("panel", "row", "column"))
    assert panels.tolist() == list(range(len(DEMO.mesh.faces)))
    assert [f"{row},{column}" for row, column in zip(rows, columns, strict=True)] == [
        DEMO.panel_name(panel) for panel in panels
    ]


@pytest.mark.parametrize(("unit", "metres"), [("mm", 0.001), ("ft", 0.3048), ("m", 1.0)])
def test_unit(unit: str, metres: float, tmp_path: Path) -> None:
    write_vtk(tmp_path / "shell.vtu", replace(DEMO, unit=unit, states=()), Settings())
    assert meshio.read(tmp_path / "shell.vtu").field_data["metres_per_unit"] == metres
    assert f"<!--Unit: {unit}. Up: z.-->" in (tmp_path / "shell.vtu").read_text()
    assert f"<!--Unit: {unit}. Up: z. " in (tmp_path / "shell.pvd").read_text()


def test_unit_unknown(tmp_path: Path) -> None:
    write_vtk(tmp_path / "shell.vtu", replace(DEMO, unit="unit", states=()), Settings())
    assert "metres_per_unit" not in meshio.read(tmp_path / "shell.vtu").field_data


def test_series_only_if_the_series_is_named(tmp_path: Path) -> None:
    write_vtk(tmp_path / "a.b.pvd", flat_only(DEMO), Settings())
    assert sorted(file.name for file in tmp_path.iterdir()) == ["a.b-0000.vtu", "a.b.pvd"]
    points = meshio.read(tmp_path / "a.b-0000.vtu").points
    np.testing.assert_array_equal(points[:, :2], DEMO.flat)


def test_states_are_numbered_where_no_drive_rises(tmp_path: Path) -> None:
    states = tuple(DocumentState(state.positions) for state in DEMO.states)
    document = replace(folded_only(DEMO), states=states, grid_shape=None)
    write_vtk(tmp_path / "a & b.vtu", document, Settings(state=2))
    assert series(tmp_path / "a & b.pvd") == [
        (float(number), f"a & b-{number:04d}.vtu") for number in range(len(states))
    ]
    mesh = meshio.read(tmp_path / "a & b.vtu")
    np.testing.assert_array_equal(mesh.points, states[2].positions)
    assert set(mesh.cell_data) == {"panel"}


def test_no_such_state_leaves_nothing(tmp_path: Path) -> None:
    document: Document = replace(DEMO, title="x")
    with pytest.raises(InputError, match="no such state"):
        write_vtk(tmp_path / "shell.vtu", document, Settings(state=7))
    assert not list(tmp_path.iterdir())


def test_the_structure_beside_the_states(tmp_path: Path) -> None:
    document = loaded_document(cells=2)
    shell = document.loaded
    assert shell is not None
    write_vtk(tmp_path / "shell.vtu", document, Settings())
    mesh = meshio.read(tmp_path / "shell-structure.vtu")
    np.testing.assert_array_equal(mesh.points, shell.points)
    np.testing.assert_array_equal(mesh.cells_dict["triangle"], shell.triangles)
    np.testing.assert_array_equal(mesh.cell_data["panel"][0], shell.panels)
    for case in shell.cases:
        np.testing.assert_array_equal(mesh.point_data[f"load: {case.name}"], case.forces)
        moved = "displacement" if case.balanced else "free motion"
        np.testing.assert_array_equal(mesh.point_data[f"{moved}: {case.name}"], case.displacements)
        stress = f"von Mises: {case.name}"
        assert (stress in mesh.cell_data) == case.balanced
        if case.balanced:
            np.testing.assert_array_equal(mesh.cell_data[stress][0], case.stresses)
    _, (_, mode) = shell.cases[1].buckling
    np.testing.assert_array_equal(mesh.point_data["buckles under 20 times: wind"], mode)
    assert "buckles under 12.35 times: wind" in mesh.point_data
    assert mesh.field_data["metres_per_unit"] == 1.0
    write_vtk(tmp_path / "again.pvd", document, Settings())
    again = (tmp_path / "again-structure.vtu").read_bytes()
    assert again == (tmp_path / "shell-structure.vtu").read_bytes()


def test_names_of_load_cases_are_xml_whatever_they_are(tmp_path: Path) -> None:
    document = loaded_document()
    assert document.loaded is not None
    names = ["wind & snow < 2", "\"=>' ]]> --> &amp;", "é€🙂 </DataArray>"]
    cases = tuple(
        replace(case, name=name) for case, name in zip(document.loaded.cases, names, strict=True)
    )
    document = replace(document, loaded=replace(document.loaded, cases=cases))
    write_vtk(tmp_path / "shell.vtu", document, Settings())
    root = ET.parse(tmp_path / "shell-structure.vtu").getroot()
    found = {each.attrib["Name"] for each in root.iter("DataArray")}
    assert {f"load: {name}" for name in names} <= found
    mesh = meshio.read(tmp_path / "shell-structure.vtu")
    for case in cases:
        np.testing.assert_array_equal(mesh.point_data[f"load: {case.name}"], case.forces)


def test_no_structure_without_an_analysis(tmp_path: Path) -> None:
    write_vtk(tmp_path / "shell.vtu", flat_only(DEMO), Settings())
    assert not (tmp_path / "shell-structure.vtu").exists()
