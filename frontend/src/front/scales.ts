// Places of designs in the plot: arithmetic without the page.

import { Scale } from "../shared/plot.ts";

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
