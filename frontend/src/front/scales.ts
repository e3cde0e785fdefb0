// Places of designs in the plot: arithmetic without the page.

import { Scale } from "../shared/plot.ts";
import { shareOf, stopsOf } from "../shared/stops.ts";
import type { Stop } from "../shared/stops.ts";
import type { View } from "../shared/view.ts";

/** Designs that others beat are shown this far beyond the front, in its own size. */
const BEYOND = 0.75;

/** The scale that shows all of the front and what is to be seen with it, and of others those near it. */
export function scaleOf(front: readonly number[], seen: readonly number[], others: readonly number[], from: number, to: number): Scale {
  const low = Math.min(...front, ...seen);
  const high = Math.max(...front, ...seen);
  const beyond = BEYOND * (high - low || Math.abs(high) || 1);
  const shown = others.map((each) => Math.min(Math.max(each, low - beyond), high + beyond));
  return Scale.of([low, high, ...shown], from, to);
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
