"""
The shelter of whole boards on hinges
=====================================

The :doc:`shelter <plot_shelter>` of 10 mm boards that reach up to their creases
(``examples/shelter_hinged.toml``). Its sheet folds flat, so ordinary hinges can stand beside the
creases, above valleys and below mountains, and all boards still fold together, by the angles of the
sheet without a thickness. It is made in three pieces of four rows of boards, because hinges stand
off the boards on arms that are as long as many rows are thick. That no boards and no arms of a
piece meet is proved, from its pack over the target to the flat sheet.

.. live:: shelter_hinged
"""

import matplotlib.pyplot as plt
import numpy as np
from drawing import EXAMPLES, camera, draw_boards, same_scale

from orishell.deployment import find_pack
from orishell.design_file import read_design_file
from orishell.motion.hinges import Hinges, piece_numbers
from orishell.shell.designed import designed
from orishell.solids import build_panels
from orishell.solids.hinged import board_offsets
from orishell.solids.hinged.pieces import pieces_of

design = designed(read_design_file(EXAMPLES / "shelter_hinged.toml"))
hinges, sheet = design.hinges, design.mechanism
assert isinstance(hinges, Hinges)
assert hinges.joints is not None
boards = build_panels(design, sheet.end_drive).boards
print(f"longest arm: {1000 * hinges.longest_arm:.0f} mm")
print(f"boards are cut back along joints by {1000 * hinges.joints.cuts.max():.1f} mm")

# %%
# Cut: the flat sheet. Along joints, where its pieces meet, boards are cut back.

COLOURS = np.array([[0.93, 0.80, 0.58], [0.72, 0.80, 0.72], [0.80, 0.72, 0.82]])
STEEL = np.array([0.45, 0.47, 0.52])
piece = piece_numbers(boards)
colours = np.where(boards.arms[:, None], STEEL, COLOURS[piece])

figure, axes = plt.subplots(figsize=(8, 7), layout="constrained")
for outline, colour, arm in zip(boards.outlines[:, 0, :, :2], colours, boards.arms, strict=True):
    if not arm:
        axes.fill(*outline.T, facecolor=colour, edgecolor="0.35", linewidth=0.6)
axes.set_aspect("equal")
axes.axis("off")

# %%
# Carried: the pack of each piece.

faces, flat = sheet.grid.faces_vertices(), sheet.positions(0.0).reshape(-1, 3)[:, :2]
view = camera(-62, 22)
figure, frames = plt.subplots(1, 3, figsize=(8, 3.4), layout="constrained")
for number, (own, axes) in enumerate(zip(pieces_of(sheet, boards), frames, strict=True)):
    pack = find_pack(own.sheet, sheet.end_drive, boards=own.boards)
    grid, folded = own.sheet.grid, own.sheet.positions(pack.drive).reshape(-1, 3)
    lying = own.sheet.positions(0.0).reshape(-1, 3)[:, :2]
    corners = own.boards.carried(grid.faces_vertices(), lying, folded)
    # The box stands on its second side, its shortest one to the right.
    across = pack.box.axes[[2, 0, 1]]
    across[2] = np.cross(across[0], across[1])
    draw_boards(axes, corners @ across.T, view, colours[piece == number])
    box = pack.box
    axes.set_title(f"{box.length:.2f} x {box.width:.2f} x {box.height:.2f} m", fontsize=10)
same_scale(list(frames))

# %%
# Unfolded to the target, and joined there. Boards of two pieces meet along their joint, on the face
# on which it closes, because they are cut back: with uncut boards pieces would be 6.9 mm apart.

target = sheet.positions(sheet.target_drive)
corners = boards.carried(faces, flat, target.reshape(-1, 3))
middles = np.stack([corners[piece == k].mean(axis=(0, 1, 2)) for k in range(3)])
apart = 0.35 * (middles - middles.mean(axis=0))[piece]
view = camera(-50, 18)
figure, frames = plt.subplots(1, 2, figsize=(8, 3.6), layout="constrained")
draw_boards(frames[0], corners + apart[:, None, None], view, colours)
draw_boards(frames[1], corners, view, colours)
same_scale(list(frames))

# %%
# A section through a joint, square to its crease, where the first two pieces meet.

row, column = hinges.joints.rows[0], 6
along = target[row + 1, column + 1] - target[row + 1, column]
along /= np.linalg.norm(along)
plates = corners[~boards.arms].reshape(*hinges.levels.shape, *corners.shape[1:])
above, below = plates[row, column], plates[row + 1, column]
up = above.mean(axis=(0, 1)) + below.mean(axis=(0, 1)) - 2 * target[row + 1, column]
up -= (up @ along) * along
up /= np.linalg.norm(up)
side = np.cross(along, up)
crease = target[row + 1, column : column + 2].mean(axis=0)
figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
for board, colour, ends in ((above, COLOURS[0], (1, 2)), (below, COLOURS[1], (0, 3))):
    far = [k for k in range(4) if k not in ends]
    ring = [
        board[level, list(corner)].mean(axis=0)
        for level, corner in ((0, ends), (0, far), (-1, far), (-1, ends))
    ]
    section = 1000 * (np.array(ring) - crease) @ np.stack([side, up], axis=1)
    axes.fill(*section.T, facecolor=colour, edgecolor="0.3")
middle = 1000 * (plates[row, column][:, [1, 2]].mean(axis=(0, 1)) - crease)
axes.set_xlim(-70, 70)
axes.set_ylim(middle @ up - 45, middle @ up + 45)
axes.set(aspect="equal", xlabel="mm", ylabel="mm")

# %%
# Heights of the hinges down the first two columns, over the middle of the boards. Rows lie on the
# faces, 5 mm over it or below it. Columns stand off them, for the boards of all rows of a piece
# fold in between. In one piece they would stand off by up to 110 mm.

figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
rows = 1 + np.arange(hinges.heights.column.shape[0])
for column in (0, 1):
    heights = 1000 * hinges.heights.column[:, column]
    axes.bar(rows + 0.4 * column - 0.2, heights, width=0.4, label=f"column {column + 1}")
axes.axhspan(-5, 5, color="0.8", label="boards")
axes.set(xlabel="row of boards", ylabel="height of the hinge (mm)")
axes.legend()

# %%
# Boards lie beside the sheet without a thickness, farther the more they are folded. In the flat
# sheet they lie on it. So its edges were made longer or shorter, until the boards, not the sheet,
# meet the target: there they lie in the planes of the panels that would meet it.

drives = np.linspace(0.0, np.pi, 60)
offsets = [1000 * board_offsets(hinges, sheet.positions(drive)) for drive in drives]
figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
axes.plot(np.rad2deg(drives), [each.max() for each in offsets], label="largest")
axes.plot(np.rad2deg(drives), [np.sqrt((each**2).mean()) for each in offsets], label="r.m.s.")
axes.axvline(np.rad2deg(sheet.target_drive), color="0.6", linestyle=":", label="target")
axes.set(xlabel="drive (degrees)", ylabel="distance (mm)", ylim=(0, None))
axes.legend()

fitted = sheet.positions(sheet.target_drive)
at_target = 1000 * board_offsets(hinges, fitted, design.meant)
print(f"from the panels at the target: {np.sqrt((at_target**2).mean()):.1f} mm r.m.s.")
