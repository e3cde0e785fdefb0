// Where a point that is drawn or dragged is caught: the mirror image of another, an axis, the grid.

import { pretty } from "../parts/numbers.ts";
import { distance } from "./spline.ts";
import type { Point } from "../state/types.ts";

/** A line through the plane, or between two points. */
export type Guide = { axis: 0 | 1; value: number } | { from: Point; to: Point };

export interface Caught {
  at: Point;
  guides: Guide[];
  words: string;
}

export interface Nets {
  /** Other points of the curve. */
  others: Point[];
  /** Where the curve's middle is, if its ends stay. */
  middle: number | null;
  /** Distance of grid lines. */
  step: number;
  /** From how far a point is caught. */
  reach: number;
}

export function caught(at: Point, { others, middle, step, reach }: Nets): Caught {
  const mirrors = middle === null || Math.abs(middle) < reach ? [0] : [0, middle];
  let best: { gap: number; other: Point; axis: number } | null = null;
  for (const axis of mirrors) {
    for (const other of others) {
      const gap = distance(at, [2 * axis - other[0], other[1]]);
      // A point on the axis is its own image.
      if (Math.abs(other[0] - axis) > reach && gap < reach && gap < (best?.gap ?? Infinity)) best = { gap, other, axis };
    }
  }
  if (best) {
    const { other, axis } = best;
    const image: Point = [2 * axis - other[0], other[1]];
    const guides: Guide[] = [{ axis: 0, value: axis }, { from: other, to: image }];
    return { at: image, guides, words: axis === 0 ? "mirror image about x = 0" : "mirror image about the middle" };
  }
  const found: Point = [...at];
  const guides: Guide[] = [];
  const words: string[] = [];
  for (const axis of [0, 1] as const) {
    const level = axis === 1 ? others.find(([, y]) => Math.abs(y - at[1]) < reach) : undefined;
    const line = Math.round(at[axis] / step) * step;
    const near = Math.abs(line - at[axis]) < reach;
    const half = axis === 0 && middle !== null && Math.abs(middle - at[0]) < reach;
    if (half && !(near && line === 0)) {
      found[0] = middle;
      words.push("middle");
    } else if (near) {
      found[axis] = Number(line.toPrecision(12));
      words.push(`${"xy"[axis]} = ${pretty(found[axis], 5)}`);
    } else if (level) {
      found[1] = level[1];
      words.push("level with a point");
    } else {
      continue;
    }
    guides.push({ axis, value: found[axis] });
  }
  return { at: found, guides, words: words.join(", ") };
}
