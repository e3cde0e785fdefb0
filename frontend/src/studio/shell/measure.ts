// Distances between two points of the sheet: as the shell stands, and in the flat sheet.

import type { Vector3 } from "three";
import { length } from "../../shared/quantities.ts";
import { Chosen3D } from "../../shared/moving3d.ts";
import type { Pattern2D } from "../../shared/pattern2d.ts";
import type { Shell3D } from "../../shared/shell3d.ts";
import { type Anchor, anchorFlat, anchorNow, anchorOf } from "../../shared/snap.ts";
import { panelCount } from "../../shared/view.ts";
import { button } from "../parts/controls.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { ARROWS, type Room, type Sight } from "./sight.ts";
import { Signal } from "../state/signal.ts";
import type { Store } from "../state/store.ts";

/** Corners catch within so many pixels. */
const REACH = 12;
const REACH_TOUCH = 20;

export class Measure {
  readonly active = new Signal(false);
  readonly button = button({ label: "Measure a distance", icon: "measure", keys: "M", testid: "measure", act: () => this.toggle() });
  readonly element = h("section", { class: "inspect-card", "aria-label": "Distance", "data-testid": "measure-card", hidden: true });
  private readonly words = h("p", { class: "inspect-note", role: "status" });
  private readonly inSpace = h("dd", { "data-testid": "measure-space" });
  private readonly inSheet = h("dd", { "data-testid": "measure-sheet" });
  private readonly facts = h("dl", { "aria-live": "polite" }, h("dt", {}, "Now, in space"), this.inSpace, h("dt", {}, "In the flat sheet"), this.inSheet);
  private points: Anchor[] = [];
  /** Where the next point would be. */
  private next: Anchor | null = null;
  private readonly redraw: () => void;

  constructor(
    private readonly store: Store,
    private readonly sight: Sight,
    private readonly shell: Shell3D,
    pattern: Pattern2D,
    share: Signal<number>,
  ) {
    this.element.append(
      h("header", {}, h("h3", {}, "Distance"), button({ label: "End measuring", icon: "close", keys: "Escape", act: () => this.active.set(false) })),
      this.words,
      this.facts,
    );
    const again = shell.add(new Chosen3D(shell.uniforms, "--text", (motion) => {
      const shown = this.shown.filter(({ panel }) => panel < motion.panels).map((anchor) => anchorNow(motion, anchor));
      return { lines: shown.slice(0, 2).length === 2 ? shown.slice(0, 2) : [], dots: shown };
    }));
    pattern.layers.top.push((pen, at, theme) => this.drawFlat(pen, at, theme.text("--text")));
    this.redraw = () => {
      again();
      shell.explainMark("measured", this.shown.length > 0);
      pattern.refresh();
      this.say();
    };
    this.active.bind((on) => {
      this.points = [];
      this.next = null;
      this.element.hidden = !on;
      setAttribute(this.button, "aria-pressed", String(on));
      this.redraw();
    });
    share.watch(() => this.say());
    store.view.watch((view, before) => {
      const same = view && before && String(view.header.grid) === String(before.header.grid);
      if (!same || this.points.some(({ panel }) => panel >= panelCount(view))) this.points = [];
      this.next = null;
      if (this.active.value) this.redraw();
    });
    pattern.canvas.addEventListener("keydown", (event) => {
      if (!this.active.value || !this.key(event)) return;
      event.preventDefault();
      event.stopImmediatePropagation();
    }, { capture: true });
  }

  toggle(): void {
    this.active.set(!this.active.value);
  }

  take(room: Room, event: PointerEvent): void {
    const anchor = this.found(room, event);
    if (anchor) this.add(anchor);
  }

  point(room: Room, event: PointerEvent | null): void {
    const next = event && this.found(room, event);
    if (isSame(next, this.next)) return;
    this.next = next;
    this.redraw();
  }

  private get shown(): Anchor[] {
    if (!this.active.value) return [];
    return this.points.length < 2 && this.next ? [...this.points, this.next] : this.points;
  }

  private add(anchor: Anchor): void {
    this.points = this.points.length === 2 ? [anchor] : [...this.points, anchor];
    this.redraw();
  }

  private found(room: Room, event: PointerEvent): Anchor | null {
    const view = this.store.view.value;
    const seen = view && this.sight.at(room, event, event.pointerType === "touch" ? REACH_TOUCH : REACH);
    return seen ? anchorOf(view, seen.panel, seen) : null;
  }

  /** In the pattern arrow keys go from vertex to vertex, Enter takes one. */
  private key({ key }: KeyboardEvent): boolean {
    const grid = this.store.view.value?.header.grid;
    if (!grid) return false;
    const [rows, columns] = grid;
    const at = this.next ?? this.points.at(-1) ?? this.vertex(Math.floor(rows / 2), Math.floor(columns / 2));
    if (key === "Enter") {
      this.next = null;
      this.add(at);
      return true;
    }
    const step = ARROWS[key];
    if (!step) return false;
    const vertex = at.along < 0.5 ? at.from : at.to;
    this.next = this.vertex(Math.floor(vertex / columns) + step[0], (vertex % columns) + step[1]);
    if (this.points.length === 2) this.points = [];
    this.redraw();
    return true;
  }

  /** The anchor at a vertex of the grid, at its border for one beyond. */
  private vertex(row: number, column: number): Anchor {
    const view = this.store.view.value!;
    const [rows, columns] = view.header.grid!;
    const at = Math.min(rows - 1, Math.max(0, row)) * columns + Math.min(columns - 1, Math.max(0, column));
    const corner = view.faces.indexOf(at);
    return anchorOf(view, corner >> 2, { side: corner & 3, along: 0 });
  }

  private drawFlat(pen: CanvasRenderingContext2D, at: (x: number, y: number) => [number, number], ink: string): void {
    const view = this.store.view.value;
    if (!view?.flat.length) return;
    const places = this.shown.map((anchor) => anchorFlat(view, anchor)).map(({ x, y }) => at(x, y));
    pen.strokeStyle = pen.fillStyle = ink;
    pen.lineWidth = 2;
    pen.beginPath();
    places.slice(0, 2).forEach((place, k) => pen[k ? "lineTo" : "moveTo"](...place));
    pen.stroke();
    for (const [x, y] of places) {
      pen.beginPath();
      pen.arc(x, y, 4.5, 0, 2 * Math.PI);
      pen.fill();
    }
  }

  private say(): void {
    if (!this.active.value) return;
    const view = this.store.view.value;
    const motion = this.shell.motion;
    const [one, other] = this.shown;
    this.facts.hidden = !other;
    this.words.textContent = this.points.length === 2 ? "Pick again for another distance" : this.points.length ? "Pick the second point" : "Pick the first point, in space or in the pattern";
    if (!view || !motion || !one || !other) return;
    const apart = (place: (anchor: Anchor) => Vector3): string => length(place(one).distanceTo(place(other)), view.header.unit);
    this.inSpace.textContent = apart((anchor) => anchorNow(motion, anchor));
    this.inSheet.textContent = view.flat.length ? apart((anchor) => anchorFlat(view, anchor)) : "\u2013";
  }
}

function isSame(one: Anchor | null, other: Anchor | null): boolean {
  return one === other || (one !== null && other !== null && (Object.keys(one) as (keyof Anchor)[]).every((key) => one[key] === other[key]));
}
