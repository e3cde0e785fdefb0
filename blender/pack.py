"""Pack the add-on: python blender/pack.py FILE. What orishell's tables say goes with it."""

import json
import re
import sys
import zipfile
from pathlib import Path
from typing import get_args

from orishell.conventions.colours import LIGHT, linear_rgb
from orishell.conventions.table import Knob, Table
from orishell.conventions.version import __version__
from orishell.design_file.tables import FileTable, MotionTable
from orishell.design_file.tasks import TASKS
from orishell.families.registry import FAMILIES

SOURCE = Path(__file__).with_name("orishell_blender")
BEGINNING = (1980, 1, 1, 0, 0, 0)
"""The time of every file in it, so that the same add-on has the same bytes."""


def integers() -> list[str]:
    """Dotted keys of all tables whose values are whole numbers."""
    tables = {f"{name}.": field.annotation for name, field in FileTable.model_fields.items()}
    found = [(name, each) for name, kind in tables.items() for each in (kind, *get_args(kind))]
    found += [("pattern.", family.pattern) for family in FAMILIES.values()]
    return sorted(
        {
            name + key
            for name, table in found
            if isinstance(table, type) and issubclass(table, Table)
            for key, field in table.model_fields.items()
            if Knob("", "").of_type(field.annotation).kind == "integer"
        }
    )


def facts() -> dict[str, object]:
    """Parameters of all families with their ranges, colours by their meaning, and starters."""
    return {
        "frames": MotionTable().frames,
        "integers": integers(),
        "colours": {meaning: linear_rgb(meaning) for meaning in LIGHT},
        "starters": {name: task.what for name, task in TASKS.items()},
        "parameters": {
            name: {
                f"pattern.{key}": {
                    "help": knob.help,
                    **({"range": knob.slider} if knob.slider else {}),
                }
                for key, knob in family.pattern.knobs().items()
            }
            for name, family in FAMILIES.items()
        },
    }


def pack(path: Path) -> None:
    """Write the archive."""
    path.parent.mkdir(parents=True, exist_ok=True)
    files = {each.name: each.read_text(encoding="utf-8") for each in SOURCE.glob("*.[pt][yo]*")}
    manifest = files["blender_manifest.toml"]
    files["blender_manifest.toml"] = re.sub(
        r'(?m)^version = ".*', f'version = "{__version__}"', manifest
    )
    files["facts.json"] = json.dumps(facts())
    files["LICENSE"] = (SOURCE.parents[1] / "LICENSE").read_text(encoding="utf-8")
    with zipfile.ZipFile(path, "w") as archive:
        for name, text in sorted(files.items()):
            archive.writestr(zipfile.ZipInfo(name, BEGINNING), text, zipfile.ZIP_DEFLATED)


if __name__ == "__main__":
    pack(Path(sys.argv[1]))
