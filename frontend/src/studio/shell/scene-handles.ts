// Handles at the shell: panels are drawn longer or wider, for fewer rows or columns, folds deeper, flaps wider, f and g
// farther.

import { Vector3 } from "three";
import type { Motion } from "../../shared/rigid.ts";
import { cornersOf } from "../../shared/ties.ts";
import { targetPoints, type View } from "../../shared/view.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { Signal } from "../state/signal.ts";
import type { Store } from "../state/store.ts";
import { isOpen, type Kind, KINDS, type Span, type Vertices } from "./handle-kinds.ts";
import type { Pinned } from "./pinned.ts";
import type { Stage } from "./stage.ts";

/** A handle that is held: where its line was, and what sets its value. */
interface Held extends Span {
  kind: Kind;
  value: number;
  x: number;
  y: number;
  set(wanted: number, gesture: string): void;
}

export class SceneHandles {
  private readonly handles: [Kind, HTMLElement][];
  private held: Held | null = null;

  constructor(
    private readonly store: Store,
    private readonly stage: Stage,
    pinned: Pinned,
    private readonly on: Signal<boolean>,
  ) {
    this.handles = Object.entries(KINDS).map(([key, kind]) => [kind, this.handle(key, kind)]);
    for (const [kind, element] of this.handles) pinned.add(element, () => this.spanOf(kind)?.to ?? null);
    for (const signal of [store.design, store.report, store.curves]) (signal as { watch(listener: () => void): void }).watch(() => this.show());
    on.watch(() => stage.shell.refit());
    this.show();
  }

  private handle(key: string, kind: Kind): HTMLElement {
    const { store } = this;
    const element = h("div", { class: "scene-handle", role: "slider", tabindex: 0, "data-testid": `handle-${key}` }, h("span", { class: "scene-handle-value", "aria-hidden": "true" }));
    element.addEventListener("pointerdown", (event) => {
      const span = this.spanOf(kind), value = kind.value(store);
      if (!span || value === null || event.button !== 0) return;
      element.setPointerCapture(event.pointerId);
      this.held = { ...span, kind, value, x: event.clientX, y: event.clientY, set: kind.begin(store) };
      event.preventDefault();
      element.focus({ preventScroll: true });
    });
    element.addEventListener("pointermove", (event) => this.held?.kind === kind && this.drag(this.held, event, `drag-${key}!`));
    for (const end of ["pointerup", "pointercancel"]) {
      element.addEventListener(end, () => {
        this.held = null;
        store.rest();
      });
    }
    element.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
      const value = kind.value(store);
      if (!way || value === null) return;
      event.preventDefault();
      kind.begin(store)(value + way * kind.step(store, value), `step-${key}`);
    });
    return element;
  }

  /** Where the handle is along its line says how long that is. */
  private drag({ kind, from, to, value, x, y, set }: Held, event: PointerEvent, gesture: string): void {
    const { eye } = this.stage.shell;
    const [begin, end] = [eye.onScreen(from), eye.onScreen(to)];
    const [u, v] = [end[0] - begin[0], end[1] - begin[1]], pixels = Math.hypot(u, v);
    if (pixels < 1) return;
    const times = Math.max(0.02, 1 + ((event.clientX - x) * u + (event.clientY - y) * v) / pixels ** 2);
    set(kind.drawn(value, times, from.distanceTo(to)), gesture);
  }

  private show(): void {
    for (const [kind, element] of this.handles) {
      const value = kind.value(this.store);
      if (value === null) continue;
      const label = kind.label(this.store);
      const said = `${short(value, 3)}${kind.isLength ? ` ${this.store.design.value.shell.unit}` : ""}`;
      element.title = `${label}: ${said}. Drag, or press arrow keys`;
      element.firstElementChild!.textContent = `${label} ${said}`;
      for (const [name, text] of [["aria-label", label], ["aria-valuenow", String(value)], ["aria-valuetext", said]] as const) setAttribute(element, name, text);
    }
  }

  private spanOf(kind: Kind): Span | null {
    const { shell } = this.stage;
    const view = this.store.view.value, { motion } = shell, value = kind.value(this.store);
    if (!view?.header.grid || !motion || !this.on.value || !shell.atTarget || shell.load || value === null) return null;
    const span = kind.span(verticesOf(view, motion, shell.eye.camera.position));
    const closed = (kind === KINDS["f"] || kind === KINDS["g"]) && span !== null && !isOpen(span, value);
    return closed ? null : span;
  }
}

const corners = new WeakMap<View, Uint32Array>();

function verticesOf(view: View, motion: Motion, eye: Vector3): Vertices {
  const of = corners.get(view) ?? cornersOf(motion.faces, view);
  corners.set(view, of);
  const [rows, columns] = view.header.grid!;
  const flaps = view.header.report.deployment?.flap_attachment === "folded" ? 1 : 0;
  const at = (row: number, column: number): Vector3 => motion.at(of[row * columns + column]!, new Vector3());
  return { rows, columns, flaps, at, flap: () => nearest(eye, flaps ? folded(rows, columns, at) : clipped(view)) };
}

/** Where flaps may be held: half way up on either side of the shell, where no other handle is. */
function heights(rows: number): number[] {
  return [rows >> 2, rows - 1 - (rows >> 2)];
}

/** Across flaps that fold with the sheet: its first and last column of panels. */
function folded(rows: number, columns: number, at: Vertices["at"]): Span[] {
  const ends = [[1, 0], [columns - 2, columns - 1]] as const;
  return heights(rows).flatMap((row) => ends.map(([from, to]) => ({ from: at(row, from), to: at(row, to) })));
}

/** Across flaps that are clipped on: strips of two columns of vertices, that in front of the first called -1. */
function clipped(view: View): Span[] {
  return view.clipped.flatMap((strip) => {
    const { grid, names } = strip.header;
    const points = targetPoints(strip);
    if (grid?.[1] !== 2 || !names || !points) return [];
    const outer = names[0]!.endsWith(",-1") ? 0 : 1;
    const at = (row: number, column: number): Vector3 => new Vector3().fromArray(points, 3 * (2 * row + column));
    return heights(grid[0]).map((row) => ({ from: at(row, 1 - outer), to: at(row, outer) }));
  });
}

function nearest(eye: Vector3, spans: Span[]): Span | null {
  const away = spans.map(({ to }) => to.distanceTo(eye));
  return spans[away.indexOf(Math.min(...away))] ?? null;
}
