// The plot of a search: designs that others beat faint, those that none beats as points to choose.

import type { SearchedDesign } from "../../shared/api-types.ts";
import { Chooser } from "../../shared/chooser.ts";
import { axisAcross, axisUp, Scale } from "../../shared/plot.ts";
import { h, s, setAttribute, uniqueId } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { Found, Member } from "./found.ts";

const WIDTH = 352;
const HEIGHT = 240;
const LEFT = 52;
const RIGHT = 10;
const TOP = 10;
const BOTTOM = 38;
const FRAME = { left: LEFT, right: WIDTH - RIGHT, top: TOP, bottom: HEIGHT - BOTTOM };
const SQUARE = 9;

export interface PlotEvents {
  /** A member is looked at. */
  looked(member: Member): void;
  picked(member: Member): void;
}

/** The figure of an axis, by name; the order in which designs were made where there is only one. */
export type Axis = string | null;

export class SearchPlot {
  readonly element: HTMLElement;
  private readonly frame = s("g", {});
  private readonly cloud = s("g", { class: "beaten", "aria-hidden": "true" });
  private readonly line = s("polyline", { class: "line" });
  private readonly begun = s("rect", { class: "begun", width: SQUARE, height: SQUARE }, s("title", {}, "the design as it was opened"));
  private readonly chooser: Chooser;
  private found: Found | null = null;
  /** Number of the design that is looked at; the knee until another is. */
  private at = -1;
  private chosen = false;
  private open: Member | null = null;

  constructor(private readonly events: PlotEvents) {
    const id = uniqueId("search");
    const drawing = s("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, "data-testid": "search-plot" });
    this.chooser = new Chooser(drawing, "Designs that no other beats", {
      walked: (place) => this.look(place),
      picked: (place) => this.pick(place),
    });
    drawing.append(this.frame, this.cloud, this.line, this.begun, this.chooser.element);
    this.element = h(
      "figure",
      { class: "front-figure", "aria-labelledby": id },
      drawing,
      h("figcaption", { id, class: "note" }, "Click a point, or walk with arrow keys and press Enter: the open design becomes that one. Grey: another is better. Square: the design as it was."),
    );
  }

  draw(found: Found, [x, y]: [Axis, Axis], words: (member: Member) => string): void {
    this.found = found;
    const { designs, front, baseline: begun, objectives } = found;
    const valueOf = (axis: Axis, design: SearchedDesign): number => (axis === null ? designs.indexOf(design) + 1 : design.figures[axis]!);
    const shown = begun && x !== null ? [...designs, begun] : designs;
    const across = Scale.of(shown.map((each) => valueOf(x, each)), LEFT, WIDTH - RIGHT);
    const up = Scale.of(shown.map((each) => valueOf(y, each)), HEIGHT - BOTTOM, TOP);
    const place = (each: SearchedDesign): [number, number] => [across.at(valueOf(x, each)), up.at(valueOf(y, each))];
    const label = (axis: Axis): string => objectives.find(({ name }) => name === axis)?.label ?? "designs, in the order in which they were made";
    this.frame.replaceChildren(
      ...axisAcross(FRAME, { ticks: across.ticks(), at: (value) => across.at(value), written: short, name: label(x) }),
      ...axisUp(FRAME, { ticks: up.ticks(5), at: (value) => up.at(value), written: short, name: label(y) }),
    );
    const best = new Set(front.map(({ design }) => design));
    this.cloud.replaceChildren(...designs.filter((each) => !best.has(each)).map((each) => circle("", place(each), 2.5)));
    const walked = objectives.length === 2 ? front.map(({ design }) => place(design).join(",")) : [];
    setAttribute(this.line, "points", walked.join(" "));
    this.begun.toggleAttribute("hidden", shown === designs);
    if (shown !== designs) {
      const [left, top] = place(begun!);
      setAttribute(this.begun, "x", left - SQUARE / 2);
      setAttribute(this.begun, "y", top - SQUARE / 2);
    }
    if (!this.chosen || !front.some(({ number }) => number === this.at)) this.at = front[found.knee]?.number ?? -1;
    this.show();
    const choices = front.map((member, number) => ({ at: place(member.design), label: words(member), testid: `searched-${number}` }));
    this.chooser.draw(choices, found.knee);
  }

  /** Another search begins. */
  forget(): void {
    this.found = null;
    this.chosen = false;
    this.open = null;
    this.chooser.draw([]);
    this.cloud.replaceChildren();
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
    this.chooser.mark(this.place, this.open ? this.found!.front.indexOf(this.open) : -1);
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

function circle(name: string, [cx, cy]: [number, number], r: number): SVGCircleElement {
  return s("circle", { class: name || null, cx, cy, r });
}
