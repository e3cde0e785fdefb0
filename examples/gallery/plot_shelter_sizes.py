"""
The shelter in other sizes
==========================

One design file, a table ``[search]`` with two variables, and a page that needs no server:
``orishell search examples/shelter_sizes.toml --write html --out sizes`` makes every variant,
proves it free of contact, and writes ``variants.html``. Move its sliders: the shell, its fold and
its figures are those of the nearest design that works, and where a design does not, the page says
why.

.. live:: shelter_sizes
"""

import matplotlib.pyplot as plt
from drawing import EXAMPLES

from orishell.search import alone, journal_in_memory, read_problem, search_designs

problem = read_problem(EXAMPLES / "shelter_sizes.toml")
with alone() as pool:
    found = search_designs(problem, pool, journal_in_memory())
for each in found.outcomes:
    scale, rows = each.values.values()
    words = each.said or f"{each.figures['mass']:.0f} kg"
    print(f"scale {scale:g}, {rows} rows: {words}")

# %%
# What more rows cost: they come nearer to the arch, and weigh more.

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
for rows in (7, 9, 11):
    made = [
        each for each in found.outcomes if each.values["pattern.rows"] == rows and not each.said
    ]
    scales = [each.values["target.f.scale"] for each in made]
    axes.plot(scales, [each.figures["mass"] for each in made], "o-", label=f"{rows} rows")
axes.set(xlabel="scale of the arch", ylabel="mass (kg)")
axes.legend()
