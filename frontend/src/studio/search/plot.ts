// The plot of a search: designs that others beat faint, those that none beats as points to choose.

import type { SearchedDesign } from "../../shared/api-types.ts";
import type { Point } from "../../shared/chooser.ts";
import { Scale } from "../../shared/plot.ts";
import { Scatter } from "../../shared/scatter.ts";
import { frameOf, plotFigure } from "../parts/plot-figure.ts";
import { s } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { Found, Member } from "./found.ts";

const FRAME = frameOf(352, 240);
const SQUARE = 9;

export interface PlotEvents {
  /** A member is looked at. */
  looked(member: Member): void;
  picked(member: Member): void;
  /** A member is pointed at, or none any more. */
  pointed(member: Member | null): void;
}

/** The figure of an axis, by name; the order in which designs were made where there is only one. */
export type Axis = string | null;

export class SearchPlot {
  readonly element: HTMLElement;
  private readonly scatter = new Scatter("Designs that no other beats", {
    walked: (place) => this.look(place),
    picked: (place) => this.pick(place),
    pointed: (place) => this.events.pointed(this.found?.front[place] ?? null),
  });
  private found: Found | null = null;
  /** Number of the design that is looked at; the knee until another is. */
  private at = -1;
  private chosen = false;
  private open: Member | null = null;

  constructor(private readonly events: PlotEvents) {
    this.element = plotFigure(this.scatter, FRAME, "search-plot", "Click a point, or walk with arrow keys and press Enter: the open design becomes that one. Grey: another is better. Square: the design as it was.");
  }

  draw(found: Found, [x, y]: [Axis, Axis], words: (member: Member) => string): void {
    this.found = found;
    const { designs, front, baseline: begun, objectives, knee } = found;
    const valueOf = (axis: Axis, design: SearchedDesign): number => (axis === null ? designs.indexOf(design) + 1 : design.figures[axis]!);
    const start = begun && x !== null ? [begun] : [];
    const shown = [...designs, ...start];
    const across = Scale.of(shown.map((each) => valueOf(x, each)), FRAME.left, FRAME.right);
    const up = Scale.of(shown.map((each) => valueOf(y, each)), FRAME.bottom, FRAME.top);
    const at = (each: SearchedDesign): Point => [valueOf(x, each), valueOf(y, each)];
    const label = (axis: Axis): string => objectives.find(({ name }) => name === axis)?.label ?? "designs, in the order in which they were made";
    const best = new Set(front.map(({ design }) => design));
    this.scatter.marks.replaceChildren(...start.map(at).map(([u, v]) => s(
      "rect",
      { class: "begun", width: SQUARE, height: SQUARE, x: across.at(u) - SQUARE / 2, y: up.at(v) - SQUARE / 2 },
      s("title", {}, "the design as it was opened"),
    )));
    if (!this.chosen || !front.some(({ number }) => number === this.at)) this.at = front[knee]?.number ?? -1;
    this.show();
    this.scatter.draw({
      frame: FRAME,
      across: { scale: across, name: label(x) },
      up: { scale: up, about: 5, name: label(y) },
      written: short,
      dots: designs.filter((each) => !best.has(each)).map(at),
      best: front.map((member, number) => ({ at: at(member.design), label: words(member), testid: `searched-${number}` })),
      joined: objectives.length === 2,
      knee,
    });
  }

  /** Another search begins. */
  forget(): void {
    this.found = null;
    this.chosen = false;
    this.open = null;
    this.scatter.chooser.draw([]);
  }

  /** Mark the member that the open design is. */
  mark(picked: Member | null): void {
    this.open = picked;
    this.show();
  }

  get member(): Member | null {
    return this.found?.front[this.place] ?? null;
  }

  private get place(): number {
    return this.found?.front.findIndex(({ number }) => number === this.at) ?? -1;
  }

  private show(): void {
    this.scatter.chooser.mark(this.place, this.open ? this.found!.front.indexOf(this.open) : -1);
  }

  private look(place: number): void {
    const member = this.found?.front[place];
    if (!member || member.number === this.at) return;
    this.at = member.number;
    this.chosen = true;
    this.show();
    this.events.looked(member);
  }

  private pick(place: number): void {
    this.look(place);
    if (this.member) this.events.picked(this.member);
  }
}
