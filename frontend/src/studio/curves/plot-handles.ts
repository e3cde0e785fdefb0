// The handles of a curve in its plane: dragged, moved with arrow keys, removed.

import { s, setAttribute } from "../parts/dom.ts";
import { pretty, roundTo } from "../parts/numbers.ts";
import type { Plane } from "./plane.ts";
import { line } from "./plot-grid.ts";
import type { Caught } from "./snapping.ts";
import type { CurveName, Point } from "../state/types.ts";

export interface Handle {
  at: Point;
  kind: "point" | "tangent" | "bulge";
  /** Where the line to it begins. */
  from?: Point;
}

export interface HandleEvents {
  /** A handle is moved; `gesture` names the motion for the history. */
  moved(index: number, to: Point, gesture: string): void;
  released(): void;
  removed(index: number): void;
  selected(index: number | null): void;
}

export interface HandlePlace {
  plane: Plane;
  pixels(event: MouseEvent): Point;
  /** Where a point is caught, and show why; with Alt it goes where it is put. */
  catch(at: Point, index: number, event: PointerEvent): Caught;
  free(): void;
}

/** A handle moves by this share of a grid step with an arrow key. */
const NUDGE = 1 / 20;
const WORDS = { point: "point", tangent: "tangent handle", bulge: "bulge handle" } as const;
export const ARROWS: Record<string, Point> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class PlotHandles {
  readonly element = s("g", {});
  private readonly arms = s("path", { class: "plot-arm" });
  private groups: SVGGElement[] = [];
  private handles: Handle[] = [];
  private dragging: number | null = null;

  constructor(
    private readonly name: CurveName,
    private readonly place: HandlePlace,
    private readonly events: HandleEvents,
  ) {
    this.element.append(this.arms);
  }

  /** A handle is being dragged. */
  get held(): boolean {
    return this.dragging !== null;
  }

  draw(handles: Handle[]): void {
    this.handles = handles;
    const { plane } = this.place;
    while (this.groups.length > handles.length) this.groups.pop()!.remove();
    while (this.groups.length < handles.length) this.add(this.groups.length);
    const counts = { point: 0, tangent: 0, bulge: 0 };
    const all = handles.filter(({ kind }) => kind === "point").length;
    handles.forEach(({ at, kind }, i) => {
      const [x, y] = plane.toPixels(at);
      const group = this.groups[i]!;
      const number = counts[kind]++;
      group.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
      setAttribute(group, "data-testid", `${kind}-${this.name}-${number}`);
      group.classList.toggle("lesser", kind !== "point");
      group.classList.toggle("bulge", kind === "bulge");
      const which = kind === "point" ? `${WORDS[kind]} ${number + 1} of ${all}` : `${WORDS[kind]} ${number + 1}`;
      group.setAttribute("aria-label", `${this.name}, ${which}: x ${pretty(at[0], 4)}, y ${pretty(at[1], 4)}`);
    });
    const arms = handles.filter(({ from }) => from);
    this.arms.setAttribute("d", arms.map(({ at, from }) => line(plane.toPixels(from!), plane.toPixels(at))).join(""));
  }

  select(index: number | null): void {
    this.groups.forEach((each, i) => each.classList.toggle("selected", i === index));
  }

  focus(index: number): void {
    this.groups[index]?.focus();
  }

  private add(index: number): void {
    const group = s(
      "g",
      { class: "handle", tabindex: 0, role: "button", "aria-roledescription": "control point" },
      s("circle", { r: 13, class: "handle-reach" }),
      s("circle", { r: 5.5, class: "handle-dot" }),
    );
    group.addEventListener("focus", () => this.events.selected(index));
    group.addEventListener("keydown", (event) => this.pressed(event, index));
    group.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.stopPropagation();
      event.preventDefault();
      group.focus({ preventScroll: true });
      this.dragging = index;
      group.setPointerCapture(event.pointerId);
    });
    group.addEventListener("pointermove", (event) => {
      if (this.dragging !== index) return;
      const { plane } = this.place;
      const { at } = this.place.catch(plane.fromPixels(this.place.pixels(event)), index, event);
      const fine = 1 / plane.scale;
      this.events.moved(index, [roundTo(at[0], fine), roundTo(at[1], fine)], `drag-${this.name}-${index}!`);
    });
    const release = (): void => {
      if (this.dragging !== index) return;
      this.dragging = null;
      this.place.free();
      this.events.released();
    };
    group.addEventListener("pointerup", release);
    group.addEventListener("lostpointercapture", release);
    this.groups.push(group);
    this.element.append(group);
  }

  private pressed(event: KeyboardEvent, index: number): void {
    const direction = ARROWS[event.key];
    if (direction && !event.ctrlKey && !event.metaKey) {
      const step = this.place.plane.step * NUDGE * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
      const [x, y] = this.handles[index]!.at;
      const to: Point = [roundTo(x + direction[0] * step, step), roundTo(y + direction[1] * step, step)];
      this.events.moved(index, to, `nudge-${this.name}-${index}`);
    } else if (event.key === "Delete" || event.key === "Backspace") {
      this.events.removed(index);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }
}
