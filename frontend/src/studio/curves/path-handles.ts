// What of a path can be dragged: its points, the tangents of Béziers, the bulge of arcs and lines.

import { bulgeOf, bulgeTowards, cutArc, middleOf, withBulge } from "./arcs.ts";
import type { Path, Piece } from "./path-data.ts";
import { distance } from "./spline.ts";
import type { Point } from "../state/types.ts";

export interface PathHandle {
  at: Point;
  kind: "point" | "tangent" | "bulge";
  /** The point of the path that a tangent begins at. */
  from?: Point;
  /** Which point, or which piece and control point of it. */
  index: number;
  control: number;
}

/** Paths of more pieces are shown, and not dragged piece by piece. */
export const MOST_PIECES = 40;
/** Two tangents that differ less are one, which both handles turn (radians). */
const SMOOTH = 0.02;

export function nodesOf(path: Path): Point[] {
  return [path.start, ...path.pieces.map(({ to }) => to)];
}

/** Points first, in their order; then what bends the pieces between. */
export function handlesOf(path: Path): PathHandle[] {
  if (path.pieces.length > MOST_PIECES) return [];
  const nodes = nodesOf(path);
  const handles: PathHandle[] = nodes.map((at, index) => ({ at, kind: "point", index, control: 0 }));
  path.pieces.forEach((piece, index) => {
    const start = nodes[index]!;
    if (piece.kind === "A" || !piece.control.length) {
      handles.push({ at: middleOf(start, piece), kind: "bulge", index, control: 0 });
      return;
    }
    piece.control.forEach((at, control) => {
      const from = control === 0 ? start : piece.to;
      handles.push({ at, kind: "tangent", from, index, control });
    });
  });
  return handles;
}

export function moveHandle(path: Path, handle: PathHandle, to: Point): Path {
  if (handle.kind === "point") return moveNode(path, handle.index, to);
  const start = nodesOf(path)[handle.index]!;
  const piece = path.pieces[handle.index]!;
  if (handle.kind === "bulge") {
    const bent = withBulge(start, piece, bulgeTowards(start, piece, to));
    return { ...path, pieces: path.pieces.with(handle.index, bent) };
  }
  return moveTangent(path, handle, to);
}

function moveNode(path: Path, index: number, to: Point): Path {
  const nodes = nodesOf(path);
  const from = nodes[index]!;
  const moved = (point: Point): Point => [point[0] + to[0] - from[0], point[1] + to[1] - from[1]];
  const pieces = [...path.pieces];
  const [before, after] = [pieces[index - 1], pieces[index]];
  if (before) {
    if (before.kind === "A") {
      const start = nodes[index - 1]!;
      pieces[index - 1] = withBulge(start, { ...before, to }, bulgeOf(start, before));
    } else {
      const control = before.control.length > 1 ? before.control.with(-1, moved(before.control.at(-1)!)) : before.control;
      pieces[index - 1] = { ...before, control, to };
    }
  }
  if (after?.kind === "A") pieces[index] = withBulge(to, after, bulgeOf(from, after));
  else if (after && after.control.length > 1) pieces[index] = { ...after, control: after.control.with(0, moved(after.control[0]!)) };
  return { start: index === 0 ? to : path.start, pieces };
}

function moveTangent(path: Path, { index, control, from }: PathHandle, to: Point): Path {
  const piece = path.pieces[index]!;
  if (piece.kind === "A") return path;
  const pieces = path.pieces.with(index, { ...piece, control: piece.control.with(control, to) });
  if (piece.control.length < 2 || !from) return { ...path, pieces };
  // A smooth joint stays smooth: the tangent on its other side turns along.
  const other = control === 0 ? index - 1 : index + 1;
  const neighbour = pieces[other];
  if (neighbour?.kind === "B" && neighbour.control.length === 2) {
    const place = control === 0 ? 1 : 0;
    const opposite = neighbour.control[place]!;
    const was = piece.control[control]!;
    const length = distance(opposite, from);
    const turn = Math.abs(angle(was, from, opposite) - Math.PI);
    const reach = distance(to, from);
    if (turn < SMOOTH && reach > 0) {
      const along: Point = [
        from[0] - ((to[0] - from[0]) / reach) * length,
        from[1] - ((to[1] - from[1]) / reach) * length,
      ];
      pieces[other] = { ...neighbour, control: neighbour.control.with(place, along) };
    }
  }
  return { ...path, pieces };
}

function angle(a: Point, corner: Point, b: Point): number {
  const [u, v] = [[a[0] - corner[0], a[1] - corner[1]], [b[0] - corner[0], b[1] - corner[1]]] as const;
  return Math.abs(Math.atan2(u[0]! * v[1]! - u[1]! * v[0]!, u[0]! * v[0]! + u[1]! * v[1]!));
}

/** The path without one of its points: its neighbours are then joined by a straight line. */
export function withoutNode(path: Path, index: number): Path {
  if (path.pieces.length < 2) return path;
  if (index === 0) return { start: path.pieces[0]!.to, pieces: path.pieces.slice(1) };
  if (index === path.pieces.length) return { ...path, pieces: path.pieces.slice(0, -1) };
  const { to } = path.pieces[index]!;
  return { ...path, pieces: path.pieces.toSpliced(index - 1, 2, { kind: "B", control: [], to }) };
}

/** The same curve with one more point, where it is nearest to a place; and which point that is. */
export function withNode(path: Path, near: Point): { path: Path; index: number } {
  const nodes = nodesOf(path);
  let best = { gap: Infinity, index: 0, share: 0.5 };
  path.pieces.forEach((piece, index) => {
    for (let k = 1; k < 40; k++) {
      const gap = distance(cut(nodes[index]!, piece, k / 40).at, near);
      if (gap < best.gap) best = { gap, index, share: k / 40 };
    }
  });
  const { parts } = cut(nodes[best.index]!, path.pieces[best.index]!, best.share);
  return { path: { ...path, pieces: path.pieces.toSpliced(best.index, 1, ...parts) }, index: best.index + 1 };
}

/** The point halfway along a piece. */
export function halfway(path: Path, index: number): Point {
  return cut(nodesOf(path)[index]!, path.pieces[index]!, 0.5).at;
}

function cut(start: Point, piece: Piece, share: number): { at: Point; parts: [Piece, Piece] } {
  if (piece.kind === "A") return cutArc(start, piece, share);
  let row: Point[] = [start, ...piece.control, piece.to];
  const [first, last]: [Point[], Point[]] = [[], []];
  while (row.length > 1) {
    row = row.slice(1).map(([x, y], i): Point => [
      row[i]![0] + share * (x - row[i]![0]),
      row[i]![1] + share * (y - row[i]![1]),
    ]);
    first.push(row[0]!);
    last.unshift(row.at(-1)!);
  }
  const at = row[0]!;
  return {
    at,
    parts: [
      { kind: "B", control: first.slice(0, -1), to: at },
      { kind: "B", control: last.slice(1), to: piece.to },
    ],
  };
}
