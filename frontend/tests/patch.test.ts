// Rectangles in plan: handles, and what dragging them does.

import { expect, test } from "vitest";
import { type Patch, cornersOf, dragged, handlesOf } from "../src/studio/surface/patch.ts";
import type { Point } from "../src/studio/state/types.ts";

const patch: Patch = { centre: [1, 2], size: [4, 2], turn_deg: 30 };
const apart = ([a, b]: Point, [c, d]: Point): number => Math.hypot(a - c, b - d);

test("a handle that is dragged to where it is changes nothing", () => {
  handlesOf(patch, 0.5).forEach(({ at }, k) => {
    const same = dragged(patch, k, at);
    expect(apart(same.centre, patch.centre)).toBeLessThan(1e-12);
    expect(apart(same.size, patch.size)).toBeLessThan(1e-12);
    expect(same.turn_deg).toBeCloseTo(30, 12);
  });
});

test("a corner follows the pointer, and the one opposite stays", () => {
  for (const [k, opposite] of [[0, 2], [1, 3], [2, 0], [3, 1]] as const) {
    const [x, y] = cornersOf(patch)[k]!;
    const to: Point = [x + 0.3, y - 0.2];
    const corners = cornersOf(dragged(patch, k, to));
    expect(apart(corners[k]!, to)).toBeLessThan(1e-12);
    expect(apart(corners[opposite]!, cornersOf(patch)[opposite]!)).toBeLessThan(1e-12);
    const about = dragged(patch, k, to, true);
    expect(about.centre).toEqual(patch.centre);
    expect(apart(cornersOf(about)[k]!, to)).toBeLessThan(1e-12);
  }
});

test("a side moves across itself only, and never beyond the other", () => {
  const right = handlesOf(patch, null)[5]!;
  const wider = dragged(patch, 5, [right.at[0] + 10, right.at[1] + 10]);
  expect(wider.size[0]).toBeGreaterThan(4);
  expect(wider.size[1]).toBe(2);
  expect(apart(handlesOf(wider, null)[7]!.at, handlesOf(patch, null)[7]!.at)).toBeLessThan(1e-12);
  expect(dragged(patch, 5, [-100, -100]).size[0]).toBeGreaterThan(0);
});

test("the middle moves it, the arm turns it", () => {
  expect(dragged(patch, 8, [5, 5])).toEqual({ ...patch, centre: [5, 5] });
  expect(dragged(patch, 9, [1, 7]).turn_deg).toBeCloseTo(90, 12);
});
