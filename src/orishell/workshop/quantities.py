"""Bill of quantities: sheet, cuts, creases, boards and hinges of a shell, and what they weigh."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np

from orishell.conventions.quantities import PERSON_KG, conversion
from orishell.conventions.record import record
from orishell.design.fittings import Fittings
from orishell.document import Document
from orishell.workshop.assembly import laid_flat
from orishell.workshop.board_masses import mass_of_boards
from orishell.workshop.board_sheets import count_board_sheets
from orishell.workshop.boards import cut_of_sheet
from orishell.workshop.hinge_parts import fittings_of
from orishell.workshop.layout import on_its_roll, require_stock
from orishell.workshop.masses import (
    centre_of_mass,
    mass_by_area,
    mass_of_hinges,
    mass_of_ties,
)
from orishell.workshop.order import find_order
from orishell.workshop.order_row import OrderRow
from orishell.workshop.settings import Workshop
from orishell.workshop.sheets import Waste, measure_waste


@dataclass(frozen=True, slots=True)
class BoardCount:
    """Number of boards by the face that they lie on."""

    # boards on the upper and on the lower face of the membrane
    top: int
    bottom: int
    solid: int  # solid panels


@dataclass(frozen=True, slots=True)
class PanelMass:
    """Mass of panels with a thickness (kg)."""

    boards: float | None  # of boards, or of solid panels; None if their density is not known
    membrane: float | None  # of the membrane; None if its density is not known, 0 if there is none
    # of boards, membrane, and arms, hinges and ties where these are known; None if one of the first
    # is not known
    total: float | None
    arms: float | None = 0.0  # of arms and their feet; None if their density is not known
    hinges: float | None = 0.0  # of hinges, tape left out; None if it is not known
    ties: float | None = 0.0  # of ties; None if it is not known


@record
class HingeBill:
    """Hinges of whole boards and their arms; lengths in the document's unit."""

    count: int  # number of hinges
    on_arms: int  # how many of them stand on an arm on either side
    length: float  # of all hinges together
    screws: int  # holes in boards, and in the fins of arms
    arms: int  # number of arms
    arm_kinds: int  # how many different ones there are
    arm_area: float  # of the sheet that they are bent of


@dataclass(frozen=True, slots=True)
class PanelBill:
    """What panels with a thickness are made of; lengths and areas in the document's unit."""

    boards: BoardCount  # how many boards there are, those that are clipped on included
    board_area: float  # area of all boards, each at its largest
    membrane_area: float  # area of the membrane, without tabs and strips; 0 if there is none
    glue_area: float  # area of the boards' faces on the membrane
    hinge_length: float  # length of the creases that fold, or of the hinges of whole boards
    mass_kg: PanelMass  # mass by part
    # of the shell at its target, in the world; None if its mass is not known
    centre_of_mass: tuple[float, float, float] | None
    # number of sheets of stock for the boards; None if there is no stock, or that was not asked for
    stock_sheets: int | None
    hinges: HingeBill | None = None  # hinges of whole boards; None for others


def measure_panels(
    document: Document, workshop: Workshop, *, nested: bool = True
) -> PanelBill | None:
    """The bill of panels with a thickness; None if they have none.

    Boards are laid out on their stock if ``nested``.
    """
    if document.panel is None:
        return None
    everything = laid_flat(document)
    boards, build = everything.boards, everything.panel
    if boards is None or build is None:
        return None
    boards = boards.chosen(~boards.arms)  # arms are not of their stock
    areas = boards.areas()
    sandwich = build.construction == "sandwich"
    membrane = float(laid_flat(cut_of_sheet(document)).areas().sum()) if sandwich else 0.0
    length = everything.edge_lengths()
    cubic = conversion(document.unit, "m") ** 3
    board_mass = mass_of_boards(document)
    membrane_mass = cubic * membrane * build.membrane * build.membrane_density or None
    if not membrane:
        membrane_mass = 0.0
    fittings = fittings_of(everything)
    arm_mass: float | None = 0.0
    hinge_length = float(length[np.isin(everything.assignment, ("M", "V"))].sum())
    if fittings is not None:
        if fittings.arms:
            arm_mass = cubic * fittings.arm_mass(build) or None
        hinge_length = float(fittings.lengths.sum())
    hinge_mass, tied = mass_of_hinges(document, workshop), mass_of_ties(document, workshop)
    total = None
    if board_mass is not None and membrane_mass is not None:
        others = arm_mass, hinge_mass, tied
        total = board_mass + membrane_mass + sum(each or 0.0 for each in others)
    return PanelBill(
        boards=BoardCount(*(int((boards.sides == side).sum()) for side in (1, -1, 0))),
        board_area=float(areas.sum()),
        membrane_area=membrane,
        glue_area=float(areas[boards.sides != 0].sum()),
        hinge_length=hinge_length,
        mass_kg=PanelMass(board_mass, membrane_mass, total, arm_mass, hinge_mass, tied),
        centre_of_mass=None if total is None else centre_of_mass(document, workshop),
        stock_sheets=count_board_sheets(document, workshop) if nested else None,
        hinges=None if fittings is None else _count_hinges(fittings),
    )


def _count_hinges(fittings: Fittings) -> HingeBill:
    return HingeBill(
        count=len(fittings.edges),
        on_arms=int(fittings.on_arms.sum()),
        length=float(fittings.lengths.sum()),
        screws=fittings.screws,
        arms=sum(arm.count for arm in fittings.arms),
        arm_kinds=len(fittings.arms),
        arm_area=sum(arm.count * arm.area for arm in fittings.arms),
    )


@record
class CreaseLength:
    """Length of all creases of a kind, in the document's unit."""

    mountain: float
    valley: float
    unfolded: float


@record
class Quantities:
    """Totals of the sheet and its clipped boards; lengths and areas in the document's unit."""

    REPORTED = (
        *("panels", "clipped", "area", "crease_length", "outline_length", "stock"),
        *("mass_kg", "built", "carried_by", "order"),
    )

    panels: int
    clipped: int  # how many of them are panels of boards that are clipped on at the target
    area: float  # area of all panels
    crease_length: CreaseLength  # length of the creases by their assignment
    outline_length: float  # length of the outlines and of cuts within them
    # sheets of stock for the sheet, or for panels that are solid, and what of them is not used;
    # None if that was not asked for
    stock: Waste | None
    # mass by the areal density, and of hinges and ties where these are weighed by their length;
    # None if the areal density is not known
    mass_kg: float | None
    built: PanelBill | None = None  # boards, membrane and hinges; None if panels have no thickness
    order: tuple[OrderRow, ...] = ()  # what to order

    @property
    def mass(self) -> float | None:
        """Of all that is built, or of the sheet by its areal density (kg); None if not known."""
        built = None if self.built is None else self.built.mass_kg.total
        return built or self.mass_kg

    @property
    def carried_by(self) -> int | None:
        """How many people carry all of it; None if its mass is not known."""
        return None if self.mass is None else ceil(self.mass / PERSON_KG)


def measure_quantities(
    document: Document, workshop: Workshop, *, nested: bool = True
) -> Quantities:
    """The totals of a document for a workshop.

    The sheet is laid out on its stock, which takes most of the time, if ``nested``.
    """
    everything = laid_flat(document)
    length = everything.edge_lengths()
    letters = np.array(everything.assignment)

    def total(*which: str) -> float:
        return float(length[np.isin(letters, which)].sum())

    stock = None
    require_stock(document, workshop)
    if nested or on_its_roll(document, workshop).stock is None:
        stock = measure_waste(document, workshop)
    area = float(everything.areas().sum())
    return Quantities(
        panels=len(everything.mesh.faces),
        clipped=sum(len(part.mesh.faces) for part in document.attached if not document.moves(part)),
        area=area,
        crease_length=CreaseLength(total("M"), total("V"), total("F", "U", "J")),
        outline_length=total("B", "C"),
        stock=stock,
        mass_kg=mass_by_area(document, workshop),
        built=measure_panels(document, workshop, nested=nested),
        order=find_order(document, workshop, nested=nested),
    )
