// What the table of a target surface says: its kind, the piece that is covered, and changes of it.

import type { Ends, Place, Point, SurfaceTable } from "../state/types.ts";
import type { DrawnSurface } from "./drawn-surface.ts";
import type { Patch } from "./patch.ts";

export type Kind = "height" | "map" | "mesh";

export function kindOf(table: SurfaceTable): Kind {
  if (table.formula === undefined) return "mesh";
  return Array.isArray(table.formula) ? "map" : "height";
}

/** The rectangle in plan that is covered; `drawn` is what the server took last. */
export function patchOf(table: SurfaceTable, drawn: DrawnSurface | null): Patch | null {
  // Three formulas are over a rectangle of other variables than x and y, and a scale moves all.
  if (kindOf(table) !== "height" || table["scale"] !== undefined) return null;
  if (table.size) return { centre: table.centre ?? [0, 0], size: table.size, turn_deg: typeof table.turn_deg === "number" ? table.turn_deg : 0 };
  const ends = [table.x, table.y].flatMap((each) => each ?? []).map((each) => (typeof each === "number" ? each : NaN));
  // Ends that are formulas are known to the server only.
  if (ends.length < 4 || !ends.every(Number.isFinite)) return drawn?.patch ?? null;
  const [a, b, c, d] = ends as [number, number, number, number];
  return { centre: [(a + b) / 2, (c + d) / 2], size: [b - a, d - c], turn_deg: 0 };
}

/** The table with another rectangle: by its ranges, as long as it is not turned. */
export function withPatch(table: SurfaceTable, { centre, size, turn_deg }: Patch): SurfaceTable {
  const { turn_deg: _, centre: __, size: ___, x: _x, y: _y, ...rest } = table;
  if (turn_deg) return { ...rest, centre: centre.map(tidy) as Point, size: size.map(tidy) as Point, turn_deg };
  const ends = (axis: 0 | 1): Ends => [tidy(centre[axis] - size[axis] / 2), tidy(centre[axis] + size[axis] / 2)];
  return { ...rest, x: ends(0), y: ends(1) };
}

/** The corners of a mesh in space; null: it has none that could be moved, as those of a rectangle. */
export function cornersOf(table: SurfaceTable, drawn: DrawnSurface | null): Place[] | null {
  if (kindOf(table) !== "mesh" || !drawn || table.size || table.x) return null;
  return table.corners?.map((at) => at.map((value, axis) => value * drawn.factor[axis]!) as Place) ?? drawn.corners;
}

/** The table of a mesh with one of its corners at another place in space. */
export function withCorner(table: SurfaceTable, drawn: DrawnSurface, corner: number, to: Place): SurfaceTable {
  const corners = cornersOf(table, drawn)!.with(corner, to);
  return { ...table, corners: corners.map((at) => at.map((value, axis) => Number((value / drawn.factor[axis]!).toPrecision(7)) + 0) as Place) };
}

function tidy(value: number): number {
  return Number(value.toPrecision(10)) + 0;
}
