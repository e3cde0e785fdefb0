// Handles at the shell: panels are drawn longer or wider, for fewer rows or columns, and folds deeper.

import { Vector3 } from "three";
import type { Motion } from "../../shared/rigid.ts";
import { cornersOf } from "../../shared/ties.ts";
import type { View } from "../../shared/view.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { clamp, short } from "../parts/numbers.ts";
import type { Signal } from "../state/signal.ts";
import type { Store } from "../state/store.ts";
import type { Parameter } from "../state/types.ts";
import type { Pinned } from "./pinned.ts";
import type { Stage } from "./stage.ts";

const KEYS = ["rows", "columns", "depth"] as const;
type Key = (typeof KEYS)[number];

/** From where to where a handle is drawn, in space. */
interface Span {
  from: Vector3;
  to: Vector3;
}

interface Grabbed extends Span {
  key: Key;
  value: number;
  x: number;
  y: number;
}

export class SceneHandles {
  private readonly handles: Record<Key, HTMLElement>;
  private grabbed: Grabbed | null = null;

  constructor(
    private readonly store: Store,
    private readonly stage: Stage,
    pinned: Pinned,
    private readonly on: Signal<boolean>,
  ) {
    this.handles = Object.fromEntries(KEYS.map((key) => [key, this.handle(key)])) as Record<Key, HTMLElement>;
    for (const key of KEYS) pinned.add(this.handles[key], () => this.spanOf(key)?.to ?? null);
    for (const signal of [store.design, store.report]) (signal as { watch(listener: () => void): void }).watch(() => this.show());
    on.watch(() => stage.shell.refit());
    this.show();
  }

  private handle(key: Key): HTMLElement {
    const element = h("div", { class: "scene-handle", role: "slider", tabindex: 0, "data-testid": `handle-${key}` }, h("span", { class: "scene-handle-value", "aria-hidden": "true" }));
    element.addEventListener("pointerdown", (event) => {
      const span = this.spanOf(key), value = this.value(key);
      if (!span || value === null || event.button !== 0) return;
      element.setPointerCapture(event.pointerId);
      this.grabbed = { ...span, key, value, x: event.clientX, y: event.clientY };
      event.preventDefault();
      element.focus({ preventScroll: true });
    });
    element.addEventListener("pointermove", (event) => this.grabbed?.key === key && this.drag(this.grabbed, event));
    for (const end of ["pointerup", "pointercancel"]) {
      element.addEventListener(end, () => {
        this.grabbed = null;
        this.store.rest();
      });
    }
    element.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
      const value = this.value(key);
      if (!way || value === null) return;
      event.preventDefault();
      this.set(key, value + way * this.step(key, value), `step-${key}`);
    });
    return element;
  }

  /** Where the handle is along its line says how long a panel is, or how deep a fold. */
  private drag({ key, from, to, value, x, y }: Grabbed, event: PointerEvent): void {
    const { eye } = this.stage.shell;
    const [begin, end] = [eye.onScreen(from), eye.onScreen(to)];
    const [u, v] = [end[0] - begin[0], end[1] - begin[1]], pixels = Math.hypot(u, v);
    if (pixels < 1) return;
    // How many times as long it is drawn.
    const times = Math.max(0.02, 1 + ((event.clientX - x) * u + (event.clientY - y) * v) / pixels ** 2);
    const wanted = key === "depth" ? value + (times - 1) * from.distanceTo(to) : value / times;
    this.set(key, wanted, `drag-${key}!`);
  }

  private set(key: Key, wanted: number, gesture: string): void {
    const parameter = this.parameter(key)!;
    const [low, high] = parameter.slider ?? [0, Infinity];
    const step = parameter.step ?? 1;
    const value = key === "depth" ? Number(short(Math.max(0, wanted), 3)) : clamp(low + step * Math.round((wanted - low) / step), low, high);
    if (value !== this.store.design.value.pattern[key]) this.store.setPattern(key, value, gesture);
  }

  private step(key: Key, value: number): number {
    return key === "depth" ? 10 ** Math.floor(Math.log10(value || 1) - 1) : (this.parameter(key)?.step ?? 1);
  }

  private parameter(key: Key): Parameter | undefined {
    const { info, design } = this.store;
    return info.families[design.value.shell.family]?.parameters.find((each) => each.key === key && each.only !== "none");
  }

  /** Of what may be set by hand: not where it is chosen by a tolerance, nor of a drawn sheet. */
  private value(key: Key): number | null {
    const { design, report } = this.store;
    if (!this.parameter(key) || design.value.tolerance || !(design.value.target?.f ?? design.value.target?.surface)) return null;
    const given = design.value.pattern[key];
    const value = given === "auto" || given === undefined ? report.value?.parameters[key] : given;
    return typeof value === "number" ? value : null;
  }

  private show(): void {
    for (const key of KEYS) {
      const value = this.value(key), element = this.handles[key];
      if (value === null) continue;
      const label = this.store.labels.of(key);
      const unit = key === "depth" ? ` ${this.store.design.value.shell.unit}` : "";
      const said = `${short(value, 3)}${unit}`;
      element.title = `${label}: ${said}. Drag, or press arrow keys`;
      element.firstElementChild!.textContent = `${label} ${said}`;
      for (const [name, text] of [["aria-label", label], ["aria-valuenow", String(value)], ["aria-valuetext", said]] as const) setAttribute(element, name, text);
    }
  }

  /** Rows and columns: from a vertex in the middle over some panels to another. Depth: from the middle of a fold to its crest. */
  private spanOf(key: Key): Span | null {
    const { shell } = this.stage;
    const view = this.store.view.value, { motion } = shell;
    if (!view?.header.grid || !motion || !this.on.value || !shell.atTarget || shell.load || this.value(key) === null) return null;
    const [rows, columns] = view.header.grid;
    const [row, column] = [Math.floor(rows / 2), Math.floor(columns / 2)];
    const at = placed(view, motion);
    if (key === "rows") return { from: at(row, column), to: at(Math.min(rows - 1, row + Math.ceil(rows / 5)), column) };
    if (key === "columns") return { from: at(row, column), to: at(row, Math.min(columns - 1, column + Math.ceil(columns / 5))) };
    const crest = at(row, column);
    return { from: at(row - 1, column).lerp(at(row + 1, column), 0.5), to: crest };
  }
}

const corners = new WeakMap<View, Uint32Array>();

/** Where vertices of the grid are. */
function placed(view: View, motion: Motion): (row: number, column: number) => Vector3 {
  const of = corners.get(view) ?? cornersOf(motion.faces, view);
  corners.set(view, of);
  const columns = view.header.grid![1];
  return (row, column) => motion.at(of[row * columns + column]!, new Vector3());
}
