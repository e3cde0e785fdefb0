// A rectangle in plan: what of a surface is to be covered; its handles, and what dragging one makes of it.

import type { Point } from "../state/types.ts";

export interface Patch {
  centre: Point;
  /** Along its own x and y. */
  size: Point;
  /** From the plan's x to its own, anticlockwise. */
  turn_deg: number;
}

export interface PatchHandle {
  at: Point;
  kind: "corner" | "side" | "middle" | "turn";
  words: string;
}

/** Signs of its corners along its own x and y, anticlockwise from the lower left, and of its sides. */
const CORNERS: Point[] = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
const SIDES: Point[] = [[0, -1], [1, 0], [0, 1], [-1, 0]];
const NAMES = {
  corner: ["lower left corner", "lower right corner", "upper right corner", "upper left corner"],
  side: ["lower side", "right side", "upper side", "left side"],
};
/** A side is at least this share of what it was when it was taken. */
const LEAST = 0.02;

export function cornersOf(patch: Patch): Point[] {
  return CORNERS.map((signs) => inPlan(patch, signs));
}

/** What can be dragged; `arm` is how far beyond its right side it is turned, if it can be turned. */
export function handlesOf(patch: Patch, arm: number | null): PatchHandle[] {
  const found: PatchHandle[] = [
    ...CORNERS.map((signs, k): PatchHandle => ({ at: inPlan(patch, signs), kind: "corner", words: NAMES.corner[k]! })),
    ...SIDES.map((signs, k): PatchHandle => ({ at: inPlan(patch, signs), kind: "side", words: NAMES.side[k]! })),
    { at: patch.centre, kind: "middle", words: "middle" },
  ];
  if (arm !== null) found.push({ at: inPlan(patch, [1 + (2 * arm) / patch.size[0], 0]), kind: "turn", words: "turn" });
  return found;
}

/** The rectangle with a handle dragged to a place: what lies opposite stays, or the middle if `about`. */
export function dragged(patch: Patch, handle: number, to: Point, about = false): Patch {
  const [x, y] = axesOf(patch);
  const way: Point = [to[0] - patch.centre[0], to[1] - patch.centre[1]];
  const signs = [...CORNERS, ...SIDES][handle];
  if (!signs) {
    if (handle === 8) return { ...patch, centre: to };
    return { ...patch, turn_deg: (Math.atan2(way[1], way[0]) * 180) / Math.PI };
  }
  const local = [dot(way, x), dot(way, y)];
  const size: Point = [...patch.size], shift: Point = [0, 0];
  for (const axis of [0, 1] as const) {
    if (!signs[axis]) continue;
    const half = patch.size[axis] / 2, reach = signs[axis] * local[axis]!;
    size[axis] = Math.max(about ? 2 * reach : half + reach, LEAST * patch.size[axis]);
    if (!about) shift[axis] = (signs[axis] * (size[axis] - patch.size[axis])) / 2;
  }
  const centre: Point = [patch.centre[0] + shift[0] * x[0] + shift[1] * y[0], patch.centre[1] + shift[0] * x[1] + shift[1] * y[1]];
  return { ...patch, centre, size };
}

function axesOf({ turn_deg }: Patch): [Point, Point] {
  const turn = (turn_deg * Math.PI) / 180;
  return [[Math.cos(turn), Math.sin(turn)], [-Math.sin(turn), Math.cos(turn)]];
}

function inPlan(patch: Patch, [along, across]: Point): Point {
  const [x, y] = axesOf(patch);
  const u = (along * patch.size[0]) / 2, v = (across * patch.size[1]) / 2;
  return [patch.centre[0] + u * x[0] + v * y[0], patch.centre[1] + u * x[1] + v * y[1]];
}

function dot(a: Point, b: Point): number {
  return a[0] * b[0] + a[1] * b[1];
}
