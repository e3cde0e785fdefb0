"""
A shelter with gussets
======================

The shelter that fails in snow and in storm (``examples/shelter_structure.toml``), of plywood of
12 mm, with a plane triangle clipped into every fold at every vertex once it stands
(``examples/shelter_gussets.toml``). Hinges turn freely. Sheet, motion and its proof are the same;
without gussets these boards sink by metres.

.. live:: shelter_gussets
"""

from drawing import EXAMPLES, show_loaded

from orishell.cli.structure import summarize_structure
from orishell.design_file import read_design_file
from orishell.shell.make import make_shell

shell = make_shell(read_design_file(EXAMPLES / "shelter_gussets.toml"))
print(f"{len(shell.design.plates)} gussets; at its target: {shell.report.deployed}")

# %%
# Under the case that governs, and under the one that moves it most.

show_loaded(shell)

# %%
# This is what ``orishell structure`` prints. Forces along edges of gussets govern, by what the file
# says that these are held by. Its mesh is coarse: it says by how much figures still change.

report = shell.report.structure
assert report is not None
print("\n".join(summarize_structure(report, "m", [])))
