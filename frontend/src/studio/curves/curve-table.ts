// What the table of a target curve says: its kind, its handles, and changes of it.

import { MOST_PIECES, halfway, handlesOf, moveHandle, nodesOf, withNode, withoutNode } from "./path-handles.ts";
import { type Path, type Piece, readPath, writePath } from "./path-data.ts";
import type { Handle } from "./plot-handles.ts";
import { boxOf } from "./plane.ts";
import { between, fitPoints, placeAmong, splineControls, splineThrough } from "./spline.ts";
import { aimOf } from "../state/aims.ts";
import type { CurveTable, Design, Point } from "../state/types.ts";

export type Mode = "spline" | "lines" | "path" | "formula" | "file";
export const NO_CURVE: CurveTable = { points: [], smooth: true };
/** Samples of a curve that is drawn here. */
const SAMPLES = 800;
/** Steps towards an extent, at most, and the share of it that it is met to. */
const TURNS = 20;
const SAME = 1e-7;

export function modeOf(table: CurveTable): Mode {
  if (table.formula !== undefined) return "formula";
  if (table.path !== undefined) return "path";
  if (!Array.isArray(table.points)) return "file";
  return table.smooth === false ? "lines" : "spline";
}

/** Whether a curve has begun, at least: with fewer than two points it is none yet. */
export function isCurve(table: CurveTable): boolean {
  return !Array.isArray(table.points) || table.points.length > 1;
}

export function isWhole(design: Design): boolean {
  return aimOf(design) !== "curves" || (["f", "g"] as const).every((name) => isCurve(design.target?.[name] ?? NO_CURVE));
}

export function scaleOf({ scale = 1 }: CurveTable): Point {
  return Array.isArray(scale) ? scale : [scale, scale];
}

/** The table with other factors; one number where both are the same, none where they are 1. */
export function withScale(table: CurveTable, [x, y]: Point): CurveTable {
  const { scale: _, ...rest } = table;
  const [along, up] = [Number(x.toPrecision(12)), Number(y.toPrecision(12))];
  if (along === 1 && up === 1) return rest;
  return { ...rest, scale: along === up ? along : [along, up] };
}

/** The table whose curve extends so far along an axis; `scale` is what would do if the curve were only
 * stretched: a spline goes another way between points that are. */
export function withExtent(table: CurveTable, axis: 0 | 1, extent: number, scale: Point): CurveTable {
  let found = withScale(table, scale);
  for (let turn = 0; turn < TURNS; turn++) {
    const box = boxOf(samplesOf(found) ?? []);
    const factor = box ? extent / (box.high[axis] - box.low[axis]) : 1;
    if (!Number.isFinite(factor) || Math.abs(factor - 1) < SAME) break;
    scale = scale.with(axis, scale[axis] * factor) as Point;
    found = withScale(table, scale);
  }
  return found;
}

function pathOf(table: CurveTable): Path | null {
  return table.path === undefined ? null : readPath(table.path);
}

/** What can be dragged, as it is drawn: enlarged by the table's scale. */
export function handlesIn(table: CurveTable): Handle[] {
  const [sx, sy] = scaleOf(table);
  const drawn = ([x, y]: Point): Point => [x * sx, y * sy];
  if (Array.isArray(table.points)) return table.points.map((at) => ({ at: drawn(at), kind: "point" }));
  const path = pathOf(table);
  if (!path) return [];
  return handlesOf(path).map(({ at, kind, from }) => ({ at: drawn(at), kind, ...(from && { from: drawn(from) }) }));
}

/** Of a path with more pieces than can be dragged one by one: how many it has. */
export function piecesBeyond(table: CurveTable): number | null {
  const count = pathOf(table)?.pieces.length ?? 0;
  return count > MOST_PIECES ? count : null;
}

/** Samples of the curve of points, as the server draws it; none where only the server knows. */
export function samplesOf(table: CurveTable): Point[] | null {
  if (!Array.isArray(table.points) || table.part || table["unit"] || table["reverse"]) return null;
  const points = handlesIn(table).map(({ at }) => at);
  if (points.length < 2) return [];
  if (table.smooth === false) return points;
  const spline = splineThrough(points);
  const samples = Array.from({ length: SAMPLES + 1 }, (_, i) => spline(i / SAMPLES));
  return samples.every(([x, y]) => Number.isFinite(x + y)) ? samples : null;
}

export function moved(table: CurveTable, index: number, to: Point): CurveTable {
  const own = unscaled(table, to);
  if (Array.isArray(table.points)) return { ...table, points: table.points.with(index, own) };
  const path = pathOf(table);
  const handle = path && handlesOf(path)[index];
  return handle ? { ...table, path: writePath(moveHandle(path, handle, own)) } : table;
}

/** The table without a point; what bends a piece of a path is made straight. */
export function removed(table: CurveTable, index: number): CurveTable {
  if (Array.isArray(table.points)) return table.points.length > 2 ? { ...table, points: table.points.toSpliced(index, 1) } : table;
  const path = pathOf(table);
  const handle = path && handlesOf(path)[index];
  if (!handle) return table;
  if (handle.kind === "point") return { ...table, path: writePath(withoutNode(path, index)) };
  const { to } = path.pieces[handle.index]!;
  return { ...table, path: writePath({ ...path, pieces: path.pieces.with(handle.index, { kind: "B", control: [], to }) }) };
}

/** The table with a point more, where its curve is nearest to a place; and which that is. */
export function withPointNear(table: CurveTable, at: Point): { table: CurveTable; index: number } | null {
  const own = unscaled(table, at).map((value) => Number(value.toPrecision(6))) as Point;
  if (Array.isArray(table.points)) {
    if (table.points.length < 2) return null;
    const index = placeAmong(table.points, own, table.smooth !== false);
    return { table: { ...table, points: table.points.toSpliced(index, 0, own) }, index };
  }
  const path = pathOf(table);
  if (!path || path.pieces.length >= MOST_PIECES) return null;
  const found = withNode(path, own);
  return { table: { ...table, path: writePath(found.path) }, index: found.index };
}

/** A place on the curve after one of its points, where another would go. */
export function placeAfter(table: CurveTable, after: number): Point | null {
  const [sx, sy] = scaleOf(table);
  const path = pathOf(table);
  if (path) {
    const [x, y] = halfway(path, Math.min(after, path.pieces.length - 1));
    return [x * sx, y * sy];
  }
  const points = handlesIn(table).map(({ at }) => at);
  if (points.length < 2) return null;
  const index = Math.min(after, points.length - 2);
  const [a, b] = [points[index]!, points[index + 1]!];
  return table.smooth === false ? [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] : between(points, index);
}

/** The curve given in another way, from its table and close samples of it. */
export function given(table: CurveTable, mode: "spline" | "lines" | "path", samples: Point[]): CurveTable | null {
  const before = modeOf(table);
  if (mode === "path") {
    const points = Array.isArray(table.points) ? table.points : samples.length > 1 ? fitPoints(samples) : null;
    if (!points || points.length < 2) return null;
    const controls = before === "lines" ? null : splineControls(points);
    const pieces = points.slice(1).map((to, k): Piece => ({ kind: "B", control: controls?.[k] ?? [], to }));
    const { points: _, smooth: _smooth, formula: _formula, range: _range, ...rest } = table;
    const kept = before === "formula" ? {} : rest;
    return { ...kept, path: writePath({ start: points[0]!, pieces }) };
  }
  const smooth = mode === "spline";
  if (Array.isArray(table.points)) return { ...table, smooth };
  const path = pathOf(table);
  if (path && (!smooth || path.pieces.every((piece) => piece.kind === "B" && !piece.control.length))) {
    const { path: _, ...rest } = table;
    return { ...rest, points: nodesOf(path), smooth };
  }
  return samples.length > 1 ? { points: fitPoints(samples), smooth } : null;
}

export function fileOf(table: CurveTable): string {
  return String(table.points ?? table["svg"] ?? table["dxf"] ?? "");
}

function unscaled(table: CurveTable, [x, y]: Point): Point {
  const [sx, sy] = scaleOf(table);
  return [x / sx, y / sy];
}
