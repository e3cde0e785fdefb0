// Places of designs in the plot: arithmetic without the page.

import { Scale } from "../shared/plot.ts";
import { shareOf, stopsOf } from "../shared/stops.ts";
import type { Stop } from "../shared/stops.ts";
import type { View } from "../shared/view.ts";

/** Designs that others beat are shown this far beyond the front, in its own size. */
const BEYOND = 0.75;

export type Point = [number, number];

/** The scale that shows all of the front and what is to be seen with it, and of others those near it. */
export function scaleOf(front: readonly number[], seen: readonly number[], others: readonly number[], from: number, to: number): Scale {
  const low = Math.min(...front, ...seen);
  const high = Math.max(...front, ...seen);
  const beyond = BEYOND * (high - low || Math.abs(high) || 1);
  const shown = others.map((each) => Math.min(Math.max(each, low - beyond), high + beyond));
  return Scale.of([low, high, ...shown], from, to);
}

/** Number of the point nearest to a place, within reach of it; -1 if none is. */
export function nearest(points: readonly Point[], [x, y]: Point, reach: number): number {
  let best = -1, least = reach;
  points.forEach(([px, py], number) => {
    const away = Math.hypot(px - x, py - y);
    if (away <= least) [best, least] = [number, away];
  });
  return best;
}

/** Points nearer to each other than this (pixels) lie on each other. */
const SAME = 3;

/** The point at a place; of those that lie on each other the one after that which was taken before. */
export function taken(points: readonly Point[], place: Point, reach: number, before: number): number {
  const first = points[nearest(points, place, reach)];
  if (!first) return -1;
  const there = points.flatMap(([x, y], number) => (Math.hypot(x - first[0], y - first[1]) < SAME ? [number] : []));
  return there[(there.indexOf(before) + 1) % there.length]!;
}

/** The next point in the order of one coordinate, those equal in it by their number; the same at the end. */
export function next(points: readonly Point[], number: number, axis: 0 | 1, forwards: boolean): number {
  const order = points.map((_, k) => k).sort((one, other) => points[one]![axis] - points[other]![axis] || one - other);
  return order[order.indexOf(number) + (forwards ? 1 : -1)] ?? number;
}

/** Where another shell is in its motion while the first is at a share of its own: at flat, target and
 * pack both are together. */
export function together(first: readonly Stop[], other: readonly Stop[], share: number): number {
  if (first.map(({ name }) => name).join() !== other.map(({ name }) => name).join()) return share;
  const k = Math.max(1, first.findIndex((stop, number) => number > 0 && share <= stop.share));
  const from = first[k - 1], to = first[k];
  if (!from || !to) return share;
  const part = shareOf([from.share, to.share], share);
  return other[k - 1]!.share + part * (other[k]!.share - other[k - 1]!.share);
}

export function shareTogether(first: View, other: View, share: number): number {
  return together(stopsOf(first), stopsOf(other), share);
}
