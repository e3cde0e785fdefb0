// A surface from above: its heights and its rim, and what can be dragged: the rectangle that is covered, or
// the corners of a mesh.

import { ARROWS } from "../curves/plot-handles.ts";
import { Plane, boxOf } from "../curves/plane.ts";
import { gridOf, line } from "../curves/plot-grid.ts";
import { button } from "../parts/controls.ts";
import { h, s, setAttribute } from "../parts/dom.ts";
import { pretty, roundTo } from "../parts/numbers.ts";
import type { Place, Point } from "../state/types.ts";
import type { DrawnSurface } from "./drawn-surface.ts";
import { type Patch, type PatchHandle, cornersOf, dragged, handlesOf } from "./patch.ts";

export interface PlanEvents {
  changed(patch: Patch, gesture: string): void;
  /** A corner of a mesh is moved to a place on its rim. */
  cornered(corner: number, to: Place, gesture: string): void;
  released(): void;
}

/** Pixels from the right side to the handle that turns, and from which a handle is caught by the grid. */
const ARM = 26;
const REACH = 6;
/** Degrees by which a turn is caught, and from which. */
const [TURN, NEAR] = [15, 2];
/** Share of a grid step by which arrow keys move a handle. */
const NUDGE = 1 / 10;
const BANDS = 10;
/** Room for the handle that turns, and for fingers the tools. */
const MARGIN = matchMedia("(pointer: coarse)").matches ? 54 : 34;

export class PlanPlot {
  readonly element: HTMLElement;
  private readonly heights = s("g", { class: "plan-heights", "aria-hidden": "true" });
  private readonly grid = s("g", { class: "plot-grid" });
  private readonly labels = s("g", { class: "plot-labels" });
  private readonly rim = s("path", { class: "plan-rim" });
  private readonly box = s("path", { class: "plan-patch" });
  private readonly arm = s("path", { class: "plot-arm" });
  private readonly handles = s("g", {});
  private readonly svg: SVGSVGElement;
  private readonly plane = new Plane();
  private groups: SVGGElement[] = [];
  private drawn: DrawnSurface | null = null;
  private patch: Patch | null = null;
  private corners: Place[] | null = null;
  private held: number | null = null;
  private wantsFit = true;

  constructor(private readonly events: PlanEvents) {
    this.svg = s(
      "svg",
      { class: "plot", role: "group", "aria-label": "The surface from above", "data-testid": "plan" },
      this.heights, this.grid, this.rim, this.box, this.arm, this.labels, this.handles,
    );
    const tools = h(
      "div",
      { class: "plot-tools" },
      button({ label: "Zoom in on the plan", icon: "plus", act: () => this.zoom(1.25) }),
      button({ label: "Zoom out of the plan", icon: "minus", act: () => this.zoom(0.8) }),
      button({ label: "Fit the plan into view", icon: "fit", act: () => this.fit() }),
    );
    this.element = h("div", { class: "plot-frame plan-frame" }, this.svg, tools);
    this.listen();
    new ResizeObserver(() => this.resized()).observe(this.element);
  }

  /** Show a surface, and the rectangle or the corners on it. */
  show(drawn: DrawnSurface | null, patch: Patch | null, corners: Place[] | null, stale: boolean): void {
    this.corners = corners;
    const other = drawn !== this.drawn;
    this.drawn = drawn;
    this.patch = patch;
    this.element.classList.toggle("stale", stale);
    const box = this.seen();
    if (box && this.held === null && (this.wantsFit || (other && !this.plane.suits(box)))) {
      this.plane.fit(box, MARGIN);
      this.wantsFit = false;
    }
    this.draw();
  }

  /** Show all of the surface that is drawn next. */
  refit(): void {
    this.wantsFit = true;
  }

  private fit(): void {
    const box = this.seen();
    if (box) this.plane.fit(box, MARGIN);
    this.draw();
  }

  private seen() {
    return boxOf([...(this.drawn?.rim ?? []).map(inPlan), ...(this.patch ? cornersOf(this.patch) : [])]);
  }

  private zoom(factor: number, about?: Point): void {
    this.plane.zoom(factor, about);
    this.draw();
  }

  private draw(): void {
    const { plane } = this;
    setAttribute(this.svg, "viewBox", `0 0 ${plane.width} ${plane.height}`);
    const { lines, texts } = gridOf(plane);
    this.grid.replaceChildren(...lines);
    this.labels.replaceChildren(...texts);
    const closed = (points: Point[]): string => (points.length ? `${line(...points.map((at) => plane.toPixels(at)))}Z` : "");
    this.rim.setAttribute("d", closed((this.drawn?.rim ?? []).map(inPlan)));
    this.box.setAttribute("d", this.patch ? closed(cornersOf(this.patch)) : "");
    this.drawHandles(this.handlesNow());
    this.drawHeights();
  }

  private handlesNow(): PatchHandle[] {
    if (this.patch) return handlesOf(this.patch, ARM / this.plane.scale);
    return (this.corners ?? []).map((at, k) => ({ at: inPlan(at), kind: "corner", words: `corner ${k + 1}` }));
  }

  private drawHandles(handles: PatchHandle[]): void {
    while (this.groups.length > handles.length) this.groups.pop()!.remove();
    while (this.groups.length < handles.length) this.add(this.groups.length);
    handles.forEach(({ at, kind, words }, k) => {
      const group = this.groups[k]!;
      const [x, y] = this.plane.toPixels(at);
      group.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
      group.classList.toggle("lesser", kind !== "corner");
      setAttribute(group, "data-testid", `handle-${words.replaceAll(" ", "-")}`);
      group.setAttribute("aria-label", kind === "turn" ? `turn: ${pretty(this.patch!.turn_deg, 4)} degrees` : `${words}: x ${pretty(at[0], 4)}, y ${pretty(at[1], 4)}`);
    });
    const turn = handles.find(({ kind }) => kind === "turn");
    this.arm.setAttribute("d", turn ? line(this.plane.toPixels(handles[5]!.at), this.plane.toPixels(turn.at)) : "");
  }

  /** Heights as bands: the higher, the darker. */
  private drawHeights(): void {
    const bands = Array.from({ length: BANDS }, () => "");
    const { points, rows, columns } = this.drawn?.glass ?? { points: [], rows: 1, columns: 1 };
    let low = Infinity, high = -Infinity;
    for (let k = 2; k < points.length; k += 3) {
      low = Math.min(low, points[k]!);
      high = Math.max(high, points[k]!);
    }
    for (let cell = 0; cell < (rows - 1) * (columns - 1); cell++) {
      const v = Math.floor(cell / (columns - 1)) * columns + (cell % (columns - 1));
      const corners = [v, v + 1, v + columns + 1, v + columns].map((k) => 3 * k);
      const height = corners.reduce((sum, at) => sum + points[at + 2]! / 4, 0);
      const band = Math.min(BANDS - 1, Math.floor((BANDS * (height - low)) / (high - low || 1)));
      bands[band] += `${line(...corners.map((at) => this.plane.toPixels([points[at]!, points[at + 1]!])))}Z`;
    }
    this.heights.replaceChildren(...bands.map((d, band) => s("path", { d, "fill-opacity": 0.08 + (0.5 * band) / (BANDS - 1) })));
  }

  private resized(): void {
    const { width, height } = this.svg.getBoundingClientRect();
    if (!width || !height) return;
    const grown = Math.abs(width / this.plane.width - 1) > 0.01 || Math.abs(height / this.plane.height - 1) > 0.01;
    Object.assign(this.plane, { width, height });
    if (grown) this.fit();
    else this.draw();
  }

  private pixels(event: MouseEvent): Point {
    const { left, top } = this.svg.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  private add(index: number): void {
    const group = s(
      "g",
      { class: "handle", tabindex: 0, role: "button", "aria-roledescription": "handle of the rectangle" },
      s("circle", { r: 13, class: "handle-reach" }),
      s("circle", { r: 5.5, class: "handle-dot" }),
    );
    group.addEventListener("keydown", (event) => this.pressed(event, index));
    group.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.stopPropagation();
      event.preventDefault();
      group.focus({ preventScroll: true });
      this.held = index;
      group.setPointerCapture(event.pointerId);
    });
    group.addEventListener("pointermove", (event) => {
      if (this.held !== index) return;
      const at = this.plane.fromPixels(this.pixels(event));
      if (!this.patch) return this.moveCorner(index, nearestIn(this.drawn?.rim ?? [], at), "drag-plan!");
      this.move(index, event.altKey ? at : this.caught(at, index), event.shiftKey, "drag-plan!", !event.altKey);
    });
    const release = (): void => {
      if (this.held !== index) return;
      this.held = null;
      this.events.released();
      const box = this.seen();
      if (box && !this.plane.suits(box)) this.fit();
    };
    group.addEventListener("pointerup", release);
    group.addEventListener("lostpointercapture", release);
    this.groups.push(group);
    this.handles.append(group);
  }

  /** Lines of the grid catch what is near them. */
  private caught(at: Point, index: number): Point {
    if (index > 8) return at;
    const step = this.plane.step;
    return at.map((value) => {
      const near = Number((Math.round(value / step) * step).toPrecision(12));
      return Math.abs(near - value) * this.plane.scale < REACH ? near : value;
    }) as Point;
  }

  private move(index: number, to: Point, about: boolean, gesture: string, catching: boolean): void {
    const fine = 1 / this.plane.scale;
    const round = (value: number): number => roundTo(value, fine) + 0;
    const { centre, size, turn_deg } = dragged(this.patch!, index, to, about);
    const near = TURN * Math.round(turn_deg / TURN);
    const turn = catching && Math.abs(turn_deg - near) < NEAR ? near : turn_deg;
    this.events.changed({ centre: centre.map(round) as Point, size: size.map(round) as Point, turn_deg: Number(turn.toFixed(1)) + 0 }, gesture);
  }

  private moveCorner(corner: number, to: number, gesture: string): void {
    const rim = this.drawn?.rim ?? [];
    const place = rim[(to + rim.length) % rim.length];
    if (place && place !== this.corners?.[corner]) this.events.cornered(corner, place, gesture);
  }

  private pressed(event: KeyboardEvent, index: number): void {
    const direction = ARROWS[event.key];
    if (!direction || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    if (!this.patch) {
      // Along the rim, whichever way that runs there.
      const now = nearestIn(this.drawn?.rim ?? [], inPlan(this.corners![index]!));
      return this.moveCorner(index, now + (direction[0] || direction[1]) * (event.shiftKey ? 5 : 1), `nudge-plan-${index}`);
    }
    const handle = handlesOf(this.patch, ARM / this.plane.scale)[index]!;
    if (handle.kind === "turn") {
      const way = direction[1] || -direction[0];
      const turn_deg = Number((this.patch.turn_deg + way * (event.shiftKey ? TURN : 1)).toFixed(1));
      return this.events.changed({ ...this.patch, turn_deg }, "nudge-plan-turn");
    }
    const step = this.plane.step * NUDGE * (event.shiftKey ? 10 : 1);
    const to: Point = [roundTo(handle.at[0] + direction[0] * step, step), roundTo(handle.at[1] + direction[1] * step, step)];
    this.move(index, to, false, `nudge-plan-${index}`, false);
  }

  private listen(): void {
    let from: Point | null = null;
    this.svg.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      from = this.pixels(event);
      this.svg.setPointerCapture(event.pointerId);
    });
    this.svg.addEventListener("pointermove", (event) => {
      if (!from || this.held !== null) return;
      const to = this.pixels(event);
      this.plane.pan(to[0] - from[0], to[1] - from[1]);
      from = to;
      this.draw();
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) this.svg.addEventListener(end, () => (from = null));
    this.svg.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-0.0015 * event.deltaY), this.pixels(event));
    }, { passive: false });
  }
}

function inPlan([x, y]: Place): Point {
  return [x, y];
}

/** Number of the place that is nearest in plan. */
function nearestIn(places: Place[], [x, y]: Point): number {
  const away = places.map((at) => Math.hypot(at[0] - x, at[1] - y));
  return away.indexOf(Math.min(...away));
}
