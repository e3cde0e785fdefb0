// An elliptical arc between two points, as how far it bulges beside its chord.

import type { Arc, Bezier } from "./path-data.ts";
import type { Point } from "../state/types.ts";

/** Flatter arcs are straight lines: bulge over chord. */
const FLATTEST = 0.01;

/** A plane in which the arc is that of a circle. */
interface Round {
  into(point: Point): Point;
  back(point: Point): Point;
  ratio: number;
  turn: number;
}

function roundOf(arc: Arc | Bezier): Round {
  const turn = arc.kind === "A" ? arc.turn : 0;
  const ratio = arc.kind === "A" ? arc.radii[1] / arc.radii[0] : 1;
  const [cos, sin] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)];
  return {
    turn,
    ratio,
    into: ([x, y]) => [x * cos + y * sin, (y * cos - x * sin) / ratio],
    back: ([x, y]) => [x * cos - y * ratio * sin, x * sin + y * ratio * cos],
  };
}

/** Height of the arc over its chord, positive to the chord's right, over half the chord. */
export function bulgeOf(start: Point, piece: Arc | Bezier): number {
  if (piece.kind === "B") return 0;
  const { into } = roundOf(piece);
  const [p, q] = [into(start), into(piece.to)];
  const half = Math.hypot(q[0] - p[0], q[1] - p[1]) / 2;
  const radius = Math.max(piece.radii[0], half);
  const rise = Math.sqrt((radius - half) * (radius + half));
  return ((piece.large ? radius + rise : radius - rise) / half) * (piece.sweep ? 1 : -1);
}

/** The middle of an arc or a straight line. */
export function middleOf(start: Point, piece: Arc | Bezier): Point {
  const { into, back } = roundOf(piece);
  const [p, q] = [into(start), into(piece.to)];
  const bulge = bulgeOf(start, piece) / 2;
  return back([(p[0] + q[0]) / 2 + bulge * (q[1] - p[1]), (p[1] + q[1]) / 2 - bulge * (q[0] - p[0])]);
}

/** The same kind of arc with another bulge, or the straight line if that is next to nothing. */
export function withBulge(start: Point, piece: Arc | Bezier, bulge: number): Arc | Bezier {
  const { to } = piece;
  if (!(Math.abs(bulge) > FLATTEST)) return { kind: "B", control: [], to };
  const { into, ratio, turn } = roundOf(piece);
  const [p, q] = [into(start), into(to)];
  const half = Math.hypot(q[0] - p[0], q[1] - p[1]) / 2;
  const height = Math.abs(bulge);
  const radius = Math.abs(height - 1) < 1e-9 ? half : (half * (1 + height * height)) / (2 * height);
  return { kind: "A", radii: [radius, radius * ratio], turn, large: height > 1 + 1e-9, sweep: bulge > 0, to };
}

/** The bulge with which the arc passes as near as it can by a point. */
export function bulgeTowards(start: Point, piece: Arc | Bezier, at: Point): number {
  const { into } = roundOf(piece);
  const [p, q, r] = [into(start), into(piece.to), into(at)];
  const [cx, cy] = [q[0] - p[0], q[1] - p[1]];
  const away = (r[0] - (p[0] + q[0]) / 2) * cy - (r[1] - (p[1] + q[1]) / 2) * cx;
  return (2 * away) / (cx * cx + cy * cy);
}

/** Points along an arc, and the two arcs that it is cut into at a share of its turn. */
export function cutArc(start: Point, arc: Arc, share: number): { at: Point; parts: [Arc, Arc] } {
  const { into, back } = roundOf(arc);
  const [p, q] = [into(start), into(arc.to)];
  const bulge = bulgeOf(start, arc);
  const turn = 4 * Math.atan(bulge);
  const half = Math.hypot(q[0] - p[0], q[1] - p[1]) / 2;
  const radius = (half * (1 + bulge * bulge)) / (2 * Math.abs(bulge));
  // The centre lies on the chord's left where the arc bulges to its right.
  const rise = (half * (1 - bulge * bulge)) / (2 * bulge) / (2 * half);
  const centre: Point = [(p[0] + q[0]) / 2 - rise * (q[1] - p[1]), (p[1] + q[1]) / 2 + rise * (q[0] - p[0])];
  const angle = Math.atan2(p[1] - centre[1], p[0] - centre[0]) + share * turn;
  const at = back([centre[0] + radius * Math.cos(angle), centre[1] + radius * Math.sin(angle)]);
  const part = (to: Point, each: number): Arc => ({ ...arc, to, large: Math.abs(turn) * each > Math.PI });
  return { at, parts: [part(at, share), part(arc.to, 1 - share)] };
}
