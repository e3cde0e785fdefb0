// Room below a shell that stands: how high it is clear above the ground, and where most.

import { targetPoints, type View } from "./view.ts";

export interface Headroom {
  /** Largest clear height. */
  height: number;
  /** Where, about the view's origin. */
  x: number;
  y: number;
}

/** Places along the longer side of the plan at first; about the best so many across the square. */
const CELLS = 120;
const FINER = 24;

interface Plan {
  x: number;
  y: number;
  step: number;
  across: number;
  up: number;
}

/** Room that is clear over a square of so large a half side; null where nothing stands above the ground. */
export function headroomOf(view: View, ground: number, half: number): Headroom | null {
  const shells = [view, ...view.clipped].map((each) => triangles(each));
  const all = shells.reduce((sum, { length }) => sum + length, 0);
  const corners = new Float32Array(all);
  let at = 0;
  for (const each of shells) {
    corners.set(each, at);
    at += each.length;
  }
  if (!all) return null;
  let west = Infinity, east = -Infinity, south = Infinity, north = -Infinity;
  for (let i = 0; i < all; i += 3) {
    west = Math.min(west, corners[i]!);
    east = Math.max(east, corners[i]!);
    south = Math.min(south, corners[i + 1]!);
    north = Math.max(north, corners[i + 1]!);
  }
  const step = Math.max(east - west, north - south) / CELLS || 1;
  const plan = (x: number, y: number, width: number, depth: number, size: number): Plan => ({
    x, y, step: size, across: Math.max(1, Math.ceil(width / size)), up: Math.max(1, Math.ceil(depth / size)),
  });
  const coarse = highest(corners, plan(west, south, east - west, north - south, step), half);
  if (!coarse) return null;
  const near = step + half;
  const best = highest(corners, plan(coarse.x - near, coarse.y - near, 2 * near, 2 * near, 2 * (half || near) / FINER), half, true) ?? coarse;
  const height = best.height - ground;
  return height > 0 ? { ...best, height } : null;
}

/** The place of a plan around which the lowest panel is highest; in a part of the whole plan, one whose square
 * lies in it. */
function highest(corners: Float32Array, plan: Plan, half: number, part = false): Headroom | null {
  const { x: west, y: south, step, across, up } = plan;
  const low = lowest(corners, plan);
  const reach = Math.floor(half / step + 1e-9);
  // The least of a square is the least along rows of the least along columns.
  const clear = along(along(low, across, up, reach, true), across, up, reach, false);
  let best = -1, height = -Infinity;
  const rim = part ? reach : 0;
  for (let k = 0; k < low.length; k++) {
    const column = k % across, row = Math.floor(k / across);
    if (column < rim || column >= across - rim || row < rim || row >= up - rim) continue;
    if (low[k]! < Infinity && clear[k]! > height) [best, height] = [k, clear[k]!];
  }
  if (best < 0) return null;
  return { height, x: west + ((best % across) + 0.5) * step, y: south + (Math.floor(best / across) + 0.5) * step };
}

/** The least of so many places to either side, along rows or columns. */
function along(values: Float64Array, across: number, up: number, reach: number, rows: boolean): Float64Array {
  const least = values.slice();
  const step = rows ? 1 : across;
  for (let k = 0; k < values.length; k++) {
    const at = rows ? k % across : Math.floor(k / across), last = (rows ? across : up) - 1;
    for (let by = -Math.min(reach, at); by <= Math.min(reach, last - at); by++) {
      if (values[k + by * step]! < least[k]!) least[k] = values[k + by * step]!;
    }
  }
  return least;
}

/** The lowest panel above every place, infinite where there is none. */
function lowest(corners: Float32Array, { x: west, y: south, step, across, up }: Plan): Float64Array {
  const low = new Float64Array(across * up).fill(Infinity);
  for (let i = 0; i < corners.length; i += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = corners.subarray(i, i + 9) as unknown as number[] as [number, number, number, number, number, number, number, number, number];
    const det = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (Math.abs(det) < 1e-12 * step * step) continue;
    const cell = (value: number, from: number): number => (value - from) / step - 0.5;
    const first = Math.max(0, Math.ceil(cell(Math.min(ax, bx, cx), west))), last = Math.min(across - 1, Math.floor(cell(Math.max(ax, bx, cx), west)));
    const bottom = Math.max(0, Math.ceil(cell(Math.min(ay, by, cy), south))), top = Math.min(up - 1, Math.floor(cell(Math.max(ay, by, cy), south)));
    for (let row = bottom; row <= top; row++) {
      const y = south + (row + 0.5) * step;
      for (let column = first; column <= last; column++) {
        const x = west + (column + 0.5) * step;
        const v = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / det;
        const w = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / det;
        if (v < 0 || w < 0 || v + w > 1) continue;
        const z = az + v * (bz - az) + w * (cz - az);
        if (z < low[row * across + column]!) low[row * across + column] = z;
      }
    }
  }
  return low;
}

/** Corners (n, 3, 3) of two triangles for each panel of the shell as it stands. */
function triangles(view: View): Float32Array {
  const points = targetPoints(view) ?? new Float32Array();
  const out = new Float32Array(points.length ? 4.5 * view.faces.length : 0);
  for (let f = 0, n = 0; points.length && f < view.faces.length; f += 4) {
    for (const k of [0, 1, 2, 0, 2, 3]) {
      const v = 3 * view.faces[f + k]!;
      out[n++] = points[v]!;
      out[n++] = points[v + 1]!;
      out[n++] = points[v + 2]!;
    }
  }
  return out;
}
