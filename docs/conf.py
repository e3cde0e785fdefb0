"""How the site is built: `make docs`, into build/docs."""

from __future__ import annotations

import sys
from pathlib import Path

# autodoc imports modules with TYPE_CHECKING set, which pydantic's models in fastapi do not survive.
import fastapi  # noqa: F401

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_ext"))
import written_records  # noqa: E402, F401
from looks import variables  # noqa: E402

from orishell.conventions.version import __version__  # noqa: E402

project = "orishell"
author = "The orishell authors"
copyright = author  # noqa: A001 # Sphinx's name for it
version = release = __version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx.ext.doctest",  # what it shows is run by pytest
    "sphinx.ext.viewcode",
    "architecture",
    "gallery_pages",
    "lean_pictures",
    "live_shells",
    "mathml",
    "source_pages",
]
exclude_patterns = ["_ext", "**/GALLERY_HEADER.rst"]
templates_path: list[str] = []
nitpicky = True
suppress_warnings = ["config.cache"]  # the gallery's configuration holds functions

# The gallery runs examples/gallery/plot_*.py and writes docs/gallery.
GALLERY = HERE.parent / "examples" / "gallery"
if any(GALLERY.glob("plot_*.py")):
    from live_shells import BRIEFLY, LONG, draw_from_kept, keep_shells
    from plots import set_looks

    extensions.append("sphinx_gallery.gen_gallery")
    sphinx_gallery_conf = {
        "examples_dirs": str(GALLERY),
        "gallery_dirs": "gallery",
        "filename_pattern": rf"/plot_(?!({'|'.join(LONG)})\.py)" if BRIEFLY else "/plot_",
        "ignore_pattern": r"^(?!.*plot_)",
        "run_stale_examples": True,
        "abort_on_example_error": False,
        "capture_repr": (),  # "object at 0x7f..." says nothing, and another thing every time
        "image_scrapers": ("matplotlib", keep_shells),
        "reset_modules": ("matplotlib", set_looks, draw_from_kept),
        "write_computation_times": False,
        "show_memory": False,
        "show_signature": False,
        "download_all_examples": False,
        "min_reported_time": 3600,
        "remove_config_comments": True,
        "backreferences_dir": None,
    }
else:
    suppress_warnings += ["toc.not_readable"]

# Reference: numpydoc docstrings, each object once, under the name by which it is imported.
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
autodoc_class_signature = "mixed"
autosummary_generate = False
autodoc_type_aliases = {
    name: name
    for name in (
        *("Array", "ArrayLike", "Booleans", "Complex", "Integers"),
        *("Jet", "CurveJet", "Piece", "Place", "Run", "Location", "Parameter", "Unit"),
        *("Spacing", "Placement", "FlapSide", "End", "Layer", "Anchor"),
        *("CreaseStyle", "Labels", "Joint", "Paper", "Auto", "Content"),
        *("RowCount", "OddRowCount", "ColumnCount", "Length", "Width"),
        *("Coupling", "RowKind", "Version", "SideChoice", "Cause", "Kind", "Duration"),
        *("Pairs", "Panel", "Block", "Box", "Names", "Progress", "Passing", "Task", "Payload"),
    )
}
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True
napoleon_attr_annotations = False
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88
toc_object_entries_show_parents = "hide"
add_module_names = False

# References that lead nowhere on purpose.
nitpick_ignore_regex = [
    # Other people's libraries: a build asks nothing of the network, so it has no inventories.
    (r"py:.*", r"(np|npt|numpy|NDArray|nptyping)(\..*)?"),
    (
        r"py:.*",
        r"(asyncio|pathlib|collections|typing|types|enum|functools|io|threading|uuid|concurrent)\..*",
    ),
    (r"py:.*", r"multiprocessing\..*"),
    (
        r"py:.*",
        r"PydanticCustomError|(pydantic|pydantic_core|fastapi|starlette|matplotlib|anywidget|shapely|typer)\..*",
    ),
    # Constants whose value is all that there is to say of them: they stand in the sources.
    (r"py:data", r"[A-Z_]+"),
    # Python's own types in annotations.
    (r"py:class", r"NoneType|AnyWidget|Axes|csr_array"),
    # Short names of array and choice types; docs/api/index.md says what they stand for.
    (r"py:class", "|".join(autodoc_type_aliases)),
    # Bounds of the design file's numbers, which pydantic checks.
    (
        r"py:class",
        r"(annotated_types\.)?(Ge|Gt|Le|Lt|MinLen|MaxLen)|FieldInfo|AllowInfNan|[0-9.e-]+",
    ),
    (
        r"py:class",
        r"orishell\.(conventions\.table|structure\.value_types)\..*(_no_trace|unchangeable|_as_range)",
    ),
    # What large displacements are followed by: it stands in the sources.
    (r"py:class", r"orishell\.structure\.mesh\.frames\.SlightlyMoved"),
    # What classes of a family have in common.
    (r"py:class", r"orishell\.families\.[\w.]+\.(Lists|SheetRequest|Row|Profile)"),
    # Type variables.
    (r"py:class", r"(orishell\.[\w.]+\.)?[CFJPRT]"),
    (r"py:.*", r"(Path|Callable|Iterator|Iterable|Sequence|Mapping|Literal|Self|Any|Protocol)"),
]

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath", "amsmath", "fieldlist"]
myst_heading_anchors = 3
math_numfig = True
numfig = True

html_theme = "furo"
html_title = "orishell"
html_favicon = "_static/icon.svg"
html_static_path = ["_static"]
html_css_files = ["orishell.css"]
html_permalinks_icon = "#"
html_math_renderer = "mathml"
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_last_updated_fmt = None
pygments_style = "tango"
pygments_dark_style = "native"
light, dark = variables()
html_theme_options = {
    "navigation_with_keys": True,
    "light_logo": "icon.svg",
    "dark_logo": "icon.svg",
    "light_css_variables": light,
    "dark_css_variables": dark,
}
