// Numbers of single panels and creases: measured on the flat sheet, and on the state drawn.

import { Vector3 } from "three";
import type { Motion } from "./rigid.ts";
import { edgePanels, panelCount, type View } from "./view.ts";

/** Sides of a panel as the flat sheet lies, in the order of its corners. */
export const SIDES = ["left", "bottom", "right", "top"] as const;
/** Creases folded nearer to flat on themselves than this are measured without a sign (degrees). */
const CLOSED = 179.9;
/** How far off a side a vertex on it may be, by its length: numbers are singles. */
const OFF = 1e-4;

export interface Sheet {
  /** (E, 2) panels beside every edge, -1 where there is none; that of which it is but a part of a
   * side is the second one. */
  beside: Int32Array;
  /** (F, 4) the edge of every side, -1 for one of several edges. */
  edges: Int32Array;
  /** By their places in the faces, edges of such sides at which panels are hinged. */
  hinges: Map<number, number[]>;
  /** (F,) */
  areas: Float64Array;
  /** (F,) shortest side. */
  shortest: Float64Array;
  smallest: number;
  largest: number;
}

const known = new WeakMap<View, Sheet>();

/** What is measured once of a sheet. */
export function sheetOf(view: View): Sheet {
  const before = known.get(view);
  if (before) return before;
  const count = panelCount(view);
  const beside = edgePanels(view);
  const edges = new Int32Array(4 * count).fill(-1), hinges = new Map<number, number[]>();
  for (let e = 0; e < beside.length / 2; e++) {
    for (const panel of [beside[2 * e]!, beside[2 * e + 1]!]) {
      if (panel < 0) continue;
      const side = sideOf(view, panel, view.edges[2 * e]!, view.edges[2 * e + 1]!);
      if (side >= 0) edges[4 * panel + side] = e;
    }
  }
  const parted = [...edges.keys()].filter((place) => edges[place] === -1);
  for (let e = 0; parted.length && e < beside.length / 2; e++) {
    if (beside[2 * e + 1] !== -1) continue;
    const side = parted.find((place) => [0, 1].every((end) => liesOn(view, view.edges[2 * e + end]!, place)));
    if (side === undefined) continue;
    if (beside[2 * e] !== -1) hinges.set(side, [...(hinges.get(side) ?? []), e]);
    beside[beside[2 * e] === -1 ? 2 * e : 2 * e + 1] = side >> 2;
  }
  const areas = new Float64Array(count), shortest = new Float64Array(count).fill(Infinity);
  let smallest = 0, largest = 0;
  for (let panel = 0; panel < count; panel++) {
    const [a, b, c, d] = cornersOfPanel(view, panel);
    areas[panel] = c.clone().sub(a).cross(d.clone().sub(b)).length() / 2;
    for (const [from, to] of [[a, b], [b, c], [c, d], [d, a]] as const) {
      shortest[panel] = Math.min(shortest[panel]!, from.distanceTo(to));
    }
    if (areas[panel]! < areas[smallest]!) smallest = panel;
    if (areas[panel]! > areas[largest]!) largest = panel;
  }
  const sheet = { beside, edges, hinges, areas, shortest, smallest, largest };
  known.set(view, sheet);
  return sheet;
}

/** Place of a vertex in the flat sheet; in the first state of a sheet that is known folded only. */
export function flatPlace(view: View, vertex: number): Vector3 {
  return view.flat.length
    ? new Vector3(view.flat[2 * vertex]!, view.flat[2 * vertex + 1]!, 0)
    : new Vector3().fromArray(view.positions, 3 * vertex);
}

function cornersOfPanel(view: View, panel: number): [Vector3, Vector3, Vector3, Vector3] {
  return [0, 1, 2, 3].map((k) => flatPlace(view, view.faces[4 * panel + k]!)) as [Vector3, Vector3, Vector3, Vector3];
}

/** Angles between its sides at its corners, degrees. */
export function sectorAngles(view: View, panel: number): number[] {
  const corners = cornersOfPanel(view, panel);
  const normal = corners[2].clone().sub(corners[0]).cross(corners[3].clone().sub(corners[1]));
  return corners.map((corner, k) => {
    const next = corners[(k + 1) & 3]!.clone().sub(corner), last = corners[(k + 3) & 3]!.clone().sub(corner);
    const angle = degrees(next.angleTo(last));
    return next.clone().cross(last).dot(normal) < 0 ? 360 - angle : angle;
  });
}

export function edgeLength(view: View, edge: number): number {
  return flatPlace(view, view.edges[2 * edge]!).distanceTo(flatPlace(view, view.edges[2 * edge + 1]!));
}

/** Fold angle of a crease as drawn, degrees, valley positive; null at the sheet's edge. */
export function foldAngle(view: View, motion: Motion, edge: number): number | null {
  const { beside } = sheetOf(view);
  const [one, other] = [beside[2 * edge]!, beside[2 * edge + 1]!];
  if (one < 0 || other < 0) return null;
  const from = view.edges[2 * edge]!, to = view.edges[2 * edge + 1]!;
  const first = normalOf(motion, one), second = normalOf(motion, other);
  const along = motion.at(motion.cornerOf(one, to), new Vector3()).sub(motion.at(motion.cornerOf(one, from), new Vector3()));
  // The one panel, which the whole edge is a side of, lies to the left of its sides.
  if (!runs(view, one, from, to)) along.negate();
  const angle = degrees(first.angleTo(second));
  const sign = second.clone().cross(first).dot(along) < 0 ? -1 : 1;
  const given = view.foldAngles[edge]!;
  return angle > CLOSED && !Number.isNaN(given) ? Math.sign(given) * angle : sign * angle;
}

/** Whether a panel is a flap of the sheet: in its first or last column of panels, or behind all others. */
export function isFlap(view: View, panel: number): boolean {
  const { grid, names, report } = view.header;
  if (!grid || report.deployment?.flap_attachment !== "folded") return false;
  const columns = grid[1] - 1;
  return names ? panel >= (grid[0] - 1) * columns : panel % columns === 0 || panel % columns === columns - 1;
}

/** The panel beside another in the grid of the flat sheet; null beyond its edge. */
export function neighbour(view: View, panel: number, down: number, right: number): number | null {
  const { grid } = view.header;
  if (!grid) return null;
  const rows = grid[0] - 1, columns = grid[1] - 1;
  if (panel >= rows * columns) return null;
  const row = Math.floor(panel / columns) + down, column = (panel % columns) + right;
  return row < 0 || column < 0 || row >= rows || column >= columns ? null : row * columns + column;
}

function normalOf(motion: Motion, panel: number): Vector3 {
  const [a, b, c, d] = [0, 1, 2, 3].map((k) => motion.at(4 * panel + k, new Vector3()));
  return c!.sub(a!).cross(d!.sub(b!)).normalize();
}

/** Whether a vertex lies on a side, from the corner with this place in the faces to the next one. */
function liesOn(view: View, vertex: number, place: number): boolean {
  const from = flatPlace(view, view.faces[place]!);
  const side = flatPlace(view, view.faces[(place & ~3) | ((place + 1) & 3)]!).sub(from);
  const away = flatPlace(view, vertex).sub(from);
  const share = Math.min(1, Math.max(0, away.dot(side) / side.lengthSq()));
  return away.addScaledVector(side, -share).length() <= OFF * side.length();
}

function sideOf(view: View, panel: number, from: number, to: number): number {
  for (let k = 0; k < 4; k++) {
    const a = view.faces[4 * panel + k]!, b = view.faces[4 * panel + ((k + 1) & 3)]!;
    if ((a === from && b === to) || (a === to && b === from)) return k;
  }
  return -1;
}

function runs(view: View, panel: number, from: number, to: number): boolean {
  const side = sideOf(view, panel, from, to);
  return view.faces[4 * panel + side] === from;
}

function degrees(angle: number): number {
  return (angle * 180) / Math.PI;
}
