"""Without node a test is skipped and says what to install; where node is required it fails."""

from __future__ import annotations

from pathlib import Path

import pytest

import node_tools


def test_without_node_a_test_is_skipped(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv(node_tools.REQUIRED, raising=False)
    with pytest.raises(pytest.skip.Exception, match="apt-get install nodejs npm; then make node"):
        node_tools.ask_node("find_faces.cjs", {})


def test_where_node_is_required_its_absence_is_a_failure(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setenv(node_tools.REQUIRED, "1")
    with pytest.raises(pytest.fail.Exception, match="ORISHELL_REQUIRE_NODE=1, but node is not"):
        node_tools.ask_node("find_faces.cjs", {})


def test_a_package_of_another_version_counts_as_missing(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    program = tmp_path / "node"
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv(node_tools.REQUIRED, raising=False)
    monkeypatch.setattr(node_tools, "PACKAGES", tmp_path)
    for name, version in {**node_tools._pinned(), "rabbit-ear": "0.0.1"}.items():
        (tmp_path / name).mkdir(exist_ok=True)
        (tmp_path / name / "package.json").write_text(f'{{"version": "{version}"}}')
    with pytest.raises(pytest.skip.Exception, match=r"^rabbit-ear: not installed as "):
        node_tools.ask_node("find_faces.cjs", {})
