"""Lines on panels along which box girders hang: where they are, and on which boards."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from kits import BOXED, BOXED_ON_MEMBRANE, SKINNED, shell_of
from orishell.design.hung import HungLines
from orishell.motion.quads import unit_normals
from orishell.workshop import Workshop
from orishell.workshop.board_sheets import board_parts
from orishell.workshop.kit.card_model import make_card_model
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.parts import kit_parts
from orishell.workshop.kit.steps import kit_steps
from orishell.workshop.kit.words import load_words
from orishell.workshop.palettes import Text
from orishell.workshop.settings import Language
from orishell.workshop.sheets import draw_backs, draw_sheets

CLOSE = 1e-12
"""Of sizes of some metres."""


def _hung(name: str) -> HungLines:
    found = HungLines.joined(part.hung for part in shell_of(name).document.attached)
    assert found is not None
    return found


@pytest.mark.parametrize("name", [BOXED, BOXED_ON_MEMBRANE])
def test_strips_are_on_their_lines_in_the_shell(name: str) -> None:
    """Ends of lines go with their panels to where strips are in the shell, on the same face."""
    document = shell_of(name).document
    girders = [part for part in document.attached if part.hung is not None]
    assert len(girders) == 3
    for part in girders:
        hung, strips = part.hung, part.shell.positions.reshape(3, -1, 3)
        assert hung is not None
        assert {*hung.sides.tolist()} == {1}  # valleys, and panels beside them rise to the top
        panels = document.mesh.faces[hung.panels]
        flat, shell = document.require_flat()[panels], document.shell.positions[panels]
        axes = np.stack([flat[:, 1] - flat[:, 0], flat[:, 3] - flat[:, 0]], axis=-1)
        shares = np.linalg.solve(axes[:, None], (hung.ends - flat[:, :1])[..., None])[..., 0]
        along = shell[:, [1, 3]] - shell[:, :1]
        moved = shell[:, :1] + np.einsum("lek,lkx->lex", shares, along)
        ends = np.concatenate([np.stack([q[:-1], q[1:]], axis=1) for q in strips[[0, 2]]])
        assert np.abs(moved - ends).max() < CLOSE
        middle = np.concatenate([strips[1, :-1], strips[1, :-1]])
        above = ((middle - ends[:, 0]) * unit_normals(shell)).sum(axis=1)
        assert (above * hung.sides > 0).all()


@pytest.mark.parametrize("name", [BOXED, BOXED_ON_MEMBRANE])
def test_boards_have_the_lines_of_their_face(name: str) -> None:
    """A line is as long as its board there, bears a name, and no other word lies on it."""
    hung = _hung(name)
    line_of = {panel: number for number, panel in enumerate(hung.panels.tolist())}
    for board in board_parts(shell_of(name).document):
        number = line_of.get(board.panel) if board.side >= 0 else None
        named = [text.words for text in board.texts if text.words != board.name]
        named = [words for words in named if words.startswith("box ")]
        if number is None:
            assert not named
            continue
        assert named == [hung.names[number] + (" T" if name == BOXED else "")]
        full = shapely.LineString(hung.ends[number])
        on_board = full.intersection(shapely.Polygon(board.outline))
        lines = [shapely.LineString(line.points) for line in board.lines]
        along = [line for line in lines if line.hausdorff_distance(on_board) < CLOSE]
        assert len(along) == 1
        assert on_board.length > 0.9 * full.length
        words = [text for text in board.texts if "°" not in text.words]
        assert not any(_least(text).intersects(full) for text in words)


def _least(text: Text) -> shapely.Polygon:
    """The least that a text takes: 0.8 of its height, and half of that for each letter."""
    along = np.array([np.cos(text.angle), np.sin(text.angle)])
    up, middle = np.array([-along[1], along[0]]), np.array([text.x, text.y])
    wide = 0.25 * text.height * len(text.words)
    corners = [
        middle + a * wide * along + b * 0.4 * text.height * up
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    return shapely.Polygon(corners)


def test_a_membrane_has_lines_on_the_face_of_the_girders() -> None:
    """All lines are on the front of the membrane, from edge to edge of panels; none on its back."""
    document, hung = shell_of(BOXED_ON_MEMBRANE).document, _hung(BOXED_ON_MEMBRANE)
    workshop = Workshop(labels="panels")
    (front,), (back,) = draw_sheets(document, workshop), draw_backs(document, workshop)
    for drawing, count in ((front, len(hung)), (back, 0)):
        assert sum(text.words in hung.names for text in drawing.texts) == count
    marks = [line.points for line in front.lines if line.layer == "ENGRAVE" and not line.closed]
    drawn = np.array([np.linalg.norm(each[-1] - each[0]) for each in marks if len(each) == 2])
    lengths = np.linalg.norm(hung.ends[:, 1] - hung.ends[:, 0], axis=-1)
    assert np.abs(lengths[:, None] - drawn).min(axis=1).max() < CLOSE


def test_lines_are_as_far_from_the_crease_as_strips_are() -> None:
    """Along edges of columns, as a tape measures them in the shell that stands."""
    document = shell_of(BOXED).document
    grid = document.shell.positions.reshape(*(document.grid_shape or ()), 3)
    for part in document.attached:
        if part.hung is not None and part.borne_at is not None:
            x = grid[tuple(part.borne_at.T)]
            q, _, r = part.shell.positions.reshape(3, -1, 3)
            far = np.linalg.norm(np.stack([q, r]) - x, axis=-1)
            ends = np.stack([far[:, :-1], far[:, 1:]], axis=-1).reshape(-1, 2)
            assert np.abs(part.hung.away - ends).max() < CLOSE


def test_a_card_model_has_lines_to_its_scale() -> None:
    model = make_card_model(shell_of(BOXED).document, Workshop())
    found, hung = HungLines.joined(part.hung for part in model.document.attached), _hung(BOXED)
    assert found is not None
    factor = 1000 * model.scale  # metres to millimetres
    assert found.ends == pytest.approx(factor * hung.ends, rel=1e-12)
    assert found.away == pytest.approx(factor * hung.away, rel=1e-12)
    (front,) = draw_sheets(model.document, model.workshop)
    named = {f"{name} T" for name in hung.names}
    assert sum(text.words in named for text in front.texts) == len(hung)


@pytest.mark.parametrize("name", [BOXED, BOXED_ON_MEMBRANE, SKINNED])
def test_the_verdict_counts_boards_of_what_is_carried(name: str) -> None:
    """As many as sheet, flaps and what the sheet carries have in the document."""
    shell = shell_of(name)
    parts = [part for part in shell.document.parts if part.kind != "plate"]
    wanted = sum(len(part.boards) for part in parts if part.boards is not None)
    (row,) = (each for each in shell.report.verdict if each.subject == "boards")
    assert row.finding.startswith(f"{wanted}, of panels")
    assert len(parts) == 1 + len(shell.design.carried) > 3


def test_a_wall_has_its_name_on_both_skins() -> None:
    """Of every panel of a wall, on the bottom of one panel and on the top of another."""
    document = shell_of(SKINNED).document
    (skin,) = (part for part in document.attached if part.kind == "skin")
    walls = [part for part in document.attached if part.kind == "wall"]
    assert len(walls) == 6
    outer = HungLines.joined(part.hung for part in walls)
    assert outer is not None
    assert skin.bears is not None
    assert outer.names == skin.bears.names
    assert {*outer.sides.tolist()} == {-1}
    assert {*skin.bears.sides.tolist()} == {1}
    # Lines of both are as long as the wall is there: both are lines of one strip.
    flat = [part.require_flat().reshape(2, -1, 2) for part in walls]
    wanted = np.sort(
        np.concatenate([np.linalg.norm(np.diff(f, axis=1), axis=-1).ravel() for f in flat])
    )
    drawn = np.concatenate([outer.ends, skin.bears.ends])
    lengths = np.sort(np.linalg.norm(drawn[:, 1] - drawn[:, 0], axis=1))
    np.testing.assert_allclose(lengths, wanted, rtol=0, atol=CLOSE)
    texts = [text.words for board in board_parts(document) for text in board.texts]
    for wall in walls:
        (name,) = {*(wall.hung.names if wall.hung is not None else ())}
        assert texts.count(f"{name} B") == texts.count(f"{name} T") == len(wall.mesh.faces)


@pytest.mark.parametrize("language", ["en", "de"])
def test_the_booklet_has_skin_and_walls(language: Language) -> None:
    """As parts, and one step each to fit them before the shell is folded."""
    document, workshop = shell_of(SKINNED).document, Workshop()
    facts = find_facts(document)
    parts = kit_parts(document, workshop, facts)
    assert {part.name: part.count for part in parts if part.name in ("skin", "wall")} == {
        "skin": 1,
        "wall": 6,
    }
    words = load_words(language)
    steps = kit_steps(document, workshop, facts, parts)
    names = [step.name for step in steps]
    assert names.index("fit_skin") + 1 == names.index("fit_wall")
    for step in steps:
        if step.name in ("fit_skin", "fit_wall"):
            assert "{" not in words.say(f"steps.{step.name}.text", **step.values)
    for part in parts:
        if part.name in ("skin", "wall"):
            assert "{" not in words.say(f"parts.{part.note}", **part.values)
