"""Without a program that opens solids a test is skipped and says what is missing; or it fails."""

from __future__ import annotations

from pathlib import Path

import pytest

import cad_tools


def test_what_is_missing_skips_a_test_or_fails_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(cad_tools, "find_spec", lambda name: None)
    file = tmp_path / "a.step"
    for ask, name in (
        (cad_tools.require_build123d, "build123d"),
        (lambda: cad_tools.ask_freecad(file), "freecadcmd"),
        (lambda: cad_tools.ask_prusa_slicer(file), "prusa-slicer"),
    ):
        monkeypatch.delenv(cad_tools.REQUIRED, raising=False)
        with pytest.raises(pytest.skip.Exception, match=f"^{name} is not installed"):
            ask()
        monkeypatch.setenv(cad_tools.REQUIRED, "1")
        with pytest.raises(pytest.fail.Exception, match=f"CAD=1, but {name} is not"):
            ask()


def test_manifold3d_takes_no_open_surface_and_none_turned_inside_out() -> None:
    import numpy as np

    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    triangles = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    assert cad_tools.closed_volume(vertices, triangles) == pytest.approx(1 / 6)
    assert cad_tools.closed_volume(vertices, triangles[:, ::-1]) == pytest.approx(-1 / 6)
    with pytest.raises(AssertionError):
        cad_tools.closed_volume(vertices, triangles[1:])
