// How many states of the motion are asked for: fewer of large sheets while they change.

import { isSlow } from "../state/aims.ts";
import type { Design } from "../state/types.ts";

export const STATES = 25;
const QUICK = 500;
const MEDIUM = 3000;
const LARGE = 15000;

/** While the design changes. */
export function liveStates(design: Design): number {
  if (isSlow(design)) return allStates(design);
  const vertices = verticesOf(design);
  return vertices <= QUICK ? STATES : vertices <= MEDIUM ? 9 : 7;
}

/** When it rests. */
export function allStates(design: Design): number {
  return verticesOf(design) <= LARGE ? STATES : 13;
}

function verticesOf(design: Design): number {
  const { rows, columns } = design.pattern;
  return (Number(rows) + 2) * (Number(columns) + 2) || 0;
}
