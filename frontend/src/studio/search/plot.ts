// The plot of a search: designs that others beat faint, those that none beats as points to choose.

import type { SearchedDesign } from "../../shared/api-types.ts";
import { axisAcross, axisUp, Scale } from "../../shared/plot.ts";
import { h, nearestTo, s, setAttribute, uniqueId } from "../parts/dom.ts";
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
/** Pixels within which a click is meant for a point. */
const REACH = 24;

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
  private readonly points = s("g", { role: "radiogroup", "aria-label": "Designs that no other beats" });
  private readonly knee = s("text", { class: "knee-name", "aria-hidden": "true" }, "knee");
  private found: Found | null = null;
  /** Number of the design that is looked at; the knee until another is. */
  private at = -1;
  private chosen = false;

  constructor(private readonly events: PlotEvents) {
    const id = uniqueId("search");
    this.points.addEventListener("keydown", (event) => this.key(event as KeyboardEvent));
    this.points.addEventListener("focusin", (event) => this.look([...this.points.children].indexOf(event.target as Element)));
    this.element = h(
      "figure",
      { class: "front-figure", "aria-labelledby": id },
      s(
        "svg",
        { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, "data-testid": "search-plot", onclick: (event: MouseEvent) => this.click(event) },
        this.frame, this.cloud, this.line, this.begun, this.knee, this.points,
      ),
      h("figcaption", { id, class: "note" }, "Click a point, or walk with arrow keys and press Enter: the open design becomes that one. Grey: another is better. Square: the design as it was."),
    );
  }

  draw(found: Found, [x, y]: [Axis, Axis], words: (member: Member) => string): void {
    this.found = found;
    const { designs, front, begun_with: begun, objectives } = found;
    const held = this.points.contains(document.activeElement);
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
    this.points.replaceChildren(
      ...front.map((member, number) =>
        s(
          "g",
          { class: number === found.knee ? "point knee" : "point", role: "radio", "aria-label": words(member), "data-testid": `searched-${number}` },
          s("title", {}, words(member)),
          circle("touched", place(member.design), 12),
          circle("dot", place(member.design), 4.5),
        ),
      ),
    );
    const knee = front[found.knee];
    this.knee.toggleAttribute("hidden", !knee || front.length < 3);
    if (knee) {
      const [left, top] = place(knee.design);
      const inward = left > WIDTH - 60;
      setAttribute(this.knee, "x", left + (inward ? -8 : 8));
      setAttribute(this.knee, "y", top - 8);
      setAttribute(this.knee, "text-anchor", inward ? "end" : "start");
    }
    if (!this.chosen || !front.some(({ number }) => number === this.at)) this.at = knee?.number ?? -1;
    this.show();
    if (held) this.focus();
  }

  /** Another search begins. */
  forget(): void {
    this.found = null;
    this.chosen = false;
    for (const part of [this.points, this.cloud]) part.replaceChildren();
  }

  /** Mark the member that the open design is. */
  mark(picked: Member | null): void {
    this.found?.front.forEach((member, place) => setAttribute(this.points.children[place]!, "aria-checked", member === picked ? "true" : "false"));
  }

  get member(): Member | null {
    return this.found?.front[this.place] ?? null;
  }

  private get place(): number {
    return this.found?.front.findIndex(({ number }) => number === this.at) ?? -1;
  }

  private show(): void {
    const { place } = this;
    [...this.points.children].forEach((point, number) => {
      setAttribute(point, "tabindex", number === place ? "0" : "-1");
      point.classList.toggle("looked", number === place);
    });
  }

  private look(place: number): void {
    const member = this.found?.front[place];
    if (!member || member.number === this.at) return;
    this.at = member.number;
    this.chosen = true;
    this.show();
    this.events.looked(member);
  }

  private pick(): void {
    if (this.member) this.events.picked(this.member);
  }

  /** The point nearest to the pointer: they lie closer together than fingers are wide. */
  private click(event: MouseEvent): void {
    const nearest = nearestTo(event, this.points, REACH);
    if (nearest < 0) return;
    this.look(nearest);
    this.focus();
    this.pick();
  }

  private key(event: KeyboardEvent): void {
    const last = this.points.children.length - 1;
    const { place } = this;
    const to = {
      ArrowRight: place + 1, ArrowDown: place + 1,
      ArrowLeft: place - 1, ArrowUp: place - 1,
      Home: 0, End: last, Enter: place, " ": place,
    }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (to === place) return event.key.startsWith("Arrow") ? undefined : this.pick();
    this.look(Math.min(Math.max(to, 0), last));
    this.focus();
  }

  private focus(): void {
    (this.points.children[this.place] as SVGGElement | undefined)?.focus({ preventScroll: true });
  }
}

function circle(name: string, [cx, cy]: [number, number], r: number): SVGCircleElement {
  return s("circle", { class: name || null, cx, cy, r });
}
