// Points of a plot to choose among, by pointer or by keys.

import { svg } from "./svg.ts";

export type Point = [number, number];

export interface Choice {
  /** Its place in the plot. */
  at: Point;
  label: string;
  testid?: string;
}

export interface ChooserEvents {
  /** Keys went on to a point. */
  walked(number: number): void;
  /** The mouse, or the focus of keys, is at a point; -1: at none. */
  pointed?(number: number): void;
  /** A point was clicked, or Enter was pressed; with shift it is to be compared. */
  picked(number: number, compared: boolean): void;
}

/** Pixels of the screen within which a click is meant for a point. */
const REACH = 28;
/** Points nearer to each other than this (pixels) lie on each other. */
const SAME = 3;
const [RING, DOT] = [10, 5];
/** Where the baseline of the knee's name is: above its point, and within the plot. */
const [ABOVE, HIGHEST] = [16, 12];

export class Chooser {
  readonly element: SVGGElement;
  private readonly name = svg("text", { class: "knee-name", "text-anchor": "middle", "aria-hidden": "true" });
  private readonly points: SVGGElement;
  private choices: readonly Choice[] = [];
  private knee = -1;
  private pointed = -1;
  /** The point that Tab comes to, the one that is chosen, and the one that it is compared with. */
  private marks = { current: 0, chosen: -1, compared: -1 };

  constructor(plot: SVGSVGElement, label: string, private readonly events: ChooserEvents) {
    this.points = svg("g", { role: "listbox", "aria-label": label, "aria-orientation": "horizontal" });
    this.points.addEventListener("keydown", (event) => this.key(event));
    plot.addEventListener("click", (event) => this.click(event));
    plot.addEventListener("pointermove", (event) => this.pointAt(nearest(this.places(), [event.clientX, event.clientY], REACH)));
    plot.addEventListener("pointerleave", () => this.pointAt(-1));
    this.points.addEventListener("focusin", (event) => this.pointAt([...this.points.children].indexOf(event.target as Element)));
    this.points.addEventListener("focusout", () => this.pointAt(-1));
    this.element = svg("g");
    this.element.append(this.points, this.name);
  }

  /** Draw the points; the one that has the focus gives it to the one that takes its place. */
  draw(choices: readonly Choice[], knee = -1): void {
    const held = this.points.contains(document.activeElement);
    [this.choices, this.knee] = [choices, knee];
    this.points.replaceChildren(...choices.map((choice, number) => this.point(choice, number === knee)));
    // Two points have no knee that one could see.
    const named = choices.length > 2 ? choices[knee]?.at : undefined;
    const [x, y] = named ?? [0, 0];
    this.name.textContent = named ? "knee" : "";
    this.name.setAttribute("x", String(x));
    this.name.setAttribute("y", String(Math.max(y - ABOVE, HIGHEST)));
    this.show();
    if (held) this.focus();
  }

  /** Mark the point that keys begin at, the chosen one and the one it is compared with; -1 for none. */
  mark(current: number, chosen = current, compared = -1): void {
    this.marks = { current, chosen, compared };
    this.show();
  }

  private focus(): void {
    this.points.querySelector<SVGGElement>('[tabindex="0"]')?.focus({ preventScroll: true });
  }

  private point({ at: [x, y], testid }: Choice, knee: boolean): SVGGElement {
    const point = svg("g", { role: "option", class: knee ? "point knee" : "point", ...(testid ? { "data-testid": testid } : {}) });
    point.append(
      svg("title"),
      svg("circle", { class: "ring", cx: x, cy: y, r: RING }),
      knee ? svg("path", { class: "dot", d: diamond(x, y) }) : svg("circle", { class: "dot", cx: x, cy: y, r: DOT }),
    );
    return point;
  }

  private show(): void {
    const { current, chosen, compared } = this.marks;
    [...this.points.children].forEach((point, number) => {
      const label = [this.choices[number]!.label, number === this.knee && "the knee", number === compared && "compared with"].filter(Boolean).join(", ");
      point.setAttribute("aria-label", label);
      point.firstElementChild!.textContent = label;
      point.setAttribute("aria-selected", String(number === chosen));
      point.setAttribute("tabindex", number === current ? "0" : "-1");
      point.classList.toggle("looked", number === current && number !== chosen);
      point.classList.toggle("pinned", number === compared);
    });
  }

  private pointAt(number: number): void {
    if (number === this.pointed) return;
    this.pointed = number;
    this.events.pointed?.(number);
  }

  /** Where the points are in the window. */
  private places(): Point[] {
    return [...this.points.children].map((point): Point => {
      const { x, y, width, height } = point.querySelector(".dot")!.getBoundingClientRect();
      return [x + width / 2, y + height / 2];
    });
  }

  private click(event: MouseEvent): void {
    const places = this.places();
    const { current, compared } = this.marks;
    const before = event.shiftKey && compared >= 0 ? compared : current;
    const number = taken(places, [event.clientX, event.clientY], REACH, before);
    if (number < 0) return;
    this.events.picked(number, event.shiftKey);
    this.focus();
  }

  private key(event: KeyboardEvent): void {
    // The picture's y axis points down.
    const places = this.choices.map(({ at: [x, y] }): Point => [x, -y]);
    const from = [...this.points.children].indexOf(event.target as Element);
    const pick = (): void => this.events.picked(from, false);
    const walk = (to: number): void => {
      if (to === from) return;
      this.events.walked(to);
      this.focus();
    };
    const act = {
      ArrowRight: () => walk(next(places, from, 0, true)),
      ArrowLeft: () => walk(next(places, from, 0, false)),
      ArrowUp: () => walk(next(places, from, 1, true)),
      ArrowDown: () => walk(next(places, from, 1, false)),
      Home: () => walk(0),
      End: () => walk(places.length - 1),
      Enter: pick,
      " ": pick,
    }[event.key];
    if (!act || from < 0) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  }
}

/** Number of the point nearest to a place, within reach of it; -1 if none is. */
export function nearest(points: readonly Point[], [x, y]: Point, reach: number): number {
  let best = -1, least = reach;
  points.forEach(([px, py], number) => {
    const away = Math.hypot(px - x, py - y);
    if (away <= least) [best, least] = [number, away];
  });
  return best;
}

/** The point at a place; of those that lie on each other the one after that which was taken before. */
export function taken(points: readonly Point[], place: Point, reach: number, before: number): number {
  const first = points[nearest(points, place, reach)];
  if (!first) return -1;
  const there = points.flatMap(([x, y], number) => (Math.hypot(x - first[0], y - first[1]) < SAME ? [number] : []));
  return there[(there.indexOf(before) + 1) % there.length]!;
}

/** The next point in the order of one coordinate, those equal in it by their number; the same at the end. */
export function next(points: readonly Point[], number: number, axis: 0 | 1, forwards: boolean): number {
  const order = points.map((_, k) => k).sort((one, other) => points[one]![axis] - points[other]![axis] || one - other);
  return order[order.indexOf(number) + (forwards ? 1 : -1)] ?? number;
}

export function diamond(x: number, y: number): string {
  return `M${x} ${y - 8}l8 8l-8 8l-8 -8z`;
}
