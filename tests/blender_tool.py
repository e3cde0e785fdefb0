"""Blender as a module of Python (bpy), in an environment of its own: ``make bpy`` makes it.

It asks for another NumPy than ours, and for a process of its own. Without it a test is skipped, or
fails if the environment has ``ORISHELL_REQUIRE_BLENDER=1``.
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

from node_tools import ROOT, lacking

REQUIRED = "ORISHELL_REQUIRE_BLENDER"
PYTHON = Path(os.environ.get("ORISHELL_BPY", ROOT / "build" / "bpy" / "bin" / "python"))
SESSIONS = Path(__file__).with_name("blender_sessions.py")


def ask_blender(session: str, place: Path, **question: Any) -> Any:
    """What a session of ``blender_sessions`` finds, with the packed add-on installed in ``place``.

    Without Blender the test ends here.
    """
    if not PYTHON.exists():
        lacking("bpy is not installed: make bpy", REQUIRED)
    environment = {
        **os.environ,
        "BLENDER_USER_RESOURCES": str(place / "user"),
        "PYTHONPATH": os.pathsep.join([str(ROOT / "src"), str(SESSIONS.parent)]),
        **question.pop("environment", {}),
    }
    packed = place / "orishell.zip"
    subprocess.run(
        [PYTHON, ROOT / "blender" / "pack.py", packed], check=True, env=environment, timeout=120
    )
    answer = place / "answer.json"
    asked = json.dumps([str(packed), session, str(answer), {**question, "place": str(place)}])
    done = subprocess.run(
        [PYTHON, SESSIONS, asked],
        env=environment,
        capture_output=True,
        encoding="utf-8",
        timeout=600,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads(answer.read_text(encoding="utf-8"))
