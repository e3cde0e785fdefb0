// The panel or crease that is chosen: one in space and in the pattern.

import type { Vector3 } from "three";
import type { GroundFoot } from "../../shared/api-types.ts";
import { flatPlace, neighbour, sheetOf } from "../../shared/inspect.ts";
import { Chosen3D } from "../../shared/moving3d.ts";
import type { Pattern2D } from "../../shared/pattern2d.ts";
import type { Motion } from "../../shared/rigid.ts";
import type { Shell3D } from "../../shared/shell3d.ts";
import { panelCount, type View } from "../../shared/view.ts";
import { ARROWS, type Room, type Sight } from "./sight.ts";
import { Signal } from "../state/signal.ts";
import type { Store } from "../state/store.ts";

export interface Chosen {
  panel: number;
  /** A crease or edge of the panel; null: the panel. */
  edge: number | null;
  /** A vertex of it that stands on the ground: which of the feet. */
  foot?: number;
}

/** Creases are caught within so many pixels, and within this share of a panel's size. */
const REACH = 7;
const REACH_TOUCH = 12;
const SHARE = 0.16;
/** Feet are caught within so many pixels. */
const FOOT = 9;
const FOOT_TOUCH = 16;

export class Selection {
  readonly chosen = new Signal<Chosen | null>(null);
  readonly pointed = new Signal<Chosen | null>(null);

  constructor(
    private readonly store: Store,
    private readonly sight: Sight,
    pattern: Pattern2D,
    private readonly shell: Shell3D,
  ) {
    const redraw = shell.add(new Chosen3D(shell.uniforms, "--accent", (motion) => this.marks(motion), true));
    pattern.layers.top.push((pen, at, theme) => {
      const { value } = this.chosen;
      const view = store.view.value;
      if (!value || !view?.flat.length) return;
      pen.beginPath();
      for (const [k, vertex] of this.vertices(value).entries()) {
        const { x, y } = flatPlace(view, vertex);
        pen[k ? "lineTo" : "moveTo"](...at(x, y));
      }
      if (value.edge === null) pen.closePath();
      pen.lineWidth = value.edge === null ? 3 : 5;
      pen.strokeStyle = theme.text("--accent");
      pen.stroke();
    });
    this.chosen.watch((chosen) => {
      shell.explainMark("chosen", chosen !== null);
      redraw();
      pattern.refresh();
    });
    store.view.watch((view, before) => {
      const { value } = this.chosen;
      const same = view && before && String(view.header.grid) === String(before.header.grid);
      const gone = value?.foot !== undefined && (!view || !feetIn(view)[value.foot]);
      if (value && (!same || gone || value.panel >= panelCount(view))) this.chosen.set(null);
      this.pointed.set(null);
    });
    // Before the pattern's own keys, which move the picture.
    pattern.canvas.addEventListener("keydown", (event) => {
      if (!this.walk(event)) return;
      event.preventDefault();
      event.stopImmediatePropagation();
    }, { capture: true });
  }

  /** Choose what is under the pointer; nothing there: nothing is chosen. */
  take(room: Room, event: PointerEvent): void {
    this.chosen.set(this.found(room, event));
  }

  point(room: Room, event: PointerEvent | null): void {
    const now = event && this.found(room, event);
    const { value } = this.pointed;
    if (now?.panel !== value?.panel || now?.edge !== value?.edge || now?.foot !== value?.foot) this.pointed.set(now);
  }

  private found(room: Room, event: PointerEvent): Chosen | null {
    const view = this.store.view.value;
    const foot = view && room === "space" ? this.footAt(view, event) : null;
    if (foot) return foot;
    const seen = view && this.sight.at(room, event, 0);
    if (!seen) return null;
    const reach = Math.min(event.pointerType === "touch" ? REACH_TOUCH : REACH, SHARE * seen.size);
    const edge = seen.away <= reach ? sheetOf(view).edges[4 * seen.panel + seen.side]! : -1;
    return { panel: seen.panel, edge: edge < 0 ? null : edge };
  }

  private footAt(view: View, event: PointerEvent): Chosen | null {
    const { shell } = this, { motion } = shell;
    if (!motion || !shell.atTarget) return null;
    const reach = event.pointerType === "touch" ? FOOT_TOUCH : FOOT;
    const away = feetIn(view).map((_, foot) => {
      const [x, y] = shell.onScreen(shell.corner(cornerOfFoot(view, motion, foot)));
      return Math.hypot(x - event.clientX, y - event.clientY);
    });
    const foot = away.indexOf(Math.min(...away));
    return foot >= 0 && away[foot]! <= reach ? { panel: cornerOfFoot(view, motion, foot) >> 2, edge: null, foot } : null;
  }

  /** Arrow keys go to the panel beside; Enter begins with the one in the middle. */
  private walk(event: KeyboardEvent): boolean {
    const view = this.store.view.value;
    if (!view || event.ctrlKey || event.metaKey || event.altKey) return false;
    const { value } = this.chosen;
    if (event.key === "Enter" && !value) {
      const [rows, columns] = view.header.grid ?? [2, 2];
      this.chosen.set({ panel: Math.floor((rows - 1) / 2) * (columns - 1) + Math.floor((columns - 1) / 2), edge: null });
      return true;
    }
    const step = ARROWS[event.key];
    if (!step || !value) return false;
    const panel = neighbour(view, value.panel, ...step);
    if (panel !== null) this.chosen.set({ panel, edge: null });
    return true;
  }

  private vertices({ panel, edge }: Chosen): number[] {
    const view = this.store.view.value!;
    return edge === null ? [...view.faces.subarray(4 * panel, 4 * panel + 4)] : [...view.edges.subarray(2 * edge, 2 * edge + 2)];
  }

  private marks(motion: Motion): { lines: Vector3[]; dots: Vector3[] } {
    const { value } = this.chosen;
    const view = this.store.view.value;
    if (!view || !value || value.panel >= motion.panels) return { lines: [], dots: [] };
    if (value.foot !== undefined) return { lines: [], dots: [this.shell.corner(cornerOfFoot(view, motion, value.foot))] };
    const places = this.vertices(value).map((vertex) => this.shell.corner(motion.cornerOf(value.panel, vertex)));
    return { lines: value.edge === null ? places.flatMap((place, k) => [place, places[(k + 1) & 3]!]) : places, dots: [] };
  }
}

/** None before the shell is proved. */
export function feetIn(view: View): readonly GroundFoot[] {
  return view.header.report.deployment?.ground?.feet ?? [];
}

/** A corner of a panel at a foot. */
function cornerOfFoot(view: View, motion: Motion, foot: number): number {
  const [row, column] = feetIn(view)[foot]!.at;
  return motion.faces.indexOf(row * (view.header.grid?.[1] ?? 0) + column);
}
