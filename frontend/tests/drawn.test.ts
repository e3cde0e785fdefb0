import { expect, test } from "vitest";

import { withPointNear } from "../src/studio/curves/curve-table.ts";
import { caught } from "../src/studio/curves/snapping.ts";
import { fitStroke, placeAmong, splineThrough } from "../src/studio/curves/spline.ts";
import type { Point } from "../src/studio/state/types.ts";

const nets = { others: [[-1, 1.3], [2, 0]] as Point[], middle: null, step: 1, reach: 0.1 };

test("a point is caught by the mirror image of another, then by lines", () => {
  expect(caught([1.04, 1.26], nets)).toMatchObject({ at: [1, 1.3], words: "mirror image about x = 0" });
  expect(caught([0.05, 0.5], nets)).toMatchObject({ at: [0, 0.5], words: "x = 0" });
  expect(caught([0.4, 1.25], nets)).toMatchObject({ at: [0.4, 1.3], words: "level with a point" });
  expect(caught([0.4, 0.5], nets)).toEqual({ at: [0.4, 0.5], guides: [], words: "" });
  expect(caught([5.05, 0.03], { ...nets, middle: 2 })).toMatchObject({ at: [5, 0] });
  expect(caught([5.05, 1.3], { ...nets, middle: 2 })).toMatchObject({ at: [5, 1.3], words: "mirror image about the middle" });
});

test("a point goes in where the curve is nearest, and never changes the order", () => {
  const points: Point[] = [[0, 0], [4, 0]];
  let table = { points, smooth: true };
  for (const x of [1, 2, 3]) table = withPointNear(table, [x, 0.4 * x])!.table as typeof table;
  expect(table.points.map(([x]) => x)).toEqual([0, 1, 2, 3, 4]);
  // Beyond an end the curve goes on.
  expect(placeAmong(points, [-1, 0.2])).toBe(0);
  expect(placeAmong(points, [5, 0.2])).toBe(2);
});

test("a trembling stroke becomes a smooth curve through few points", () => {
  const track = Array.from({ length: 120 }, (_, i): Point => {
    const turn = (Math.PI * i) / 119;
    return [-3 * Math.cos(turn), 3 * Math.sin(turn) + 0.03 * (i % 2)];
  });
  const points = fitStroke(track);
  expect(points.length).toBeLessThan(8);
  const spline = splineThrough(points);
  for (let i = 0; i <= 50; i++) expect(Math.abs(Math.hypot(...spline(i / 50)) - 3)).toBeLessThan(0.12);
});

test("a stroke through points that coincide is a curve all the same", () => {
  for (const track of [[[0, 0], [0, 0], [1, 1], [1, 1], [2, 0], [2, 0]], [[1, 1], [1, 1], [1, 1]]] as Point[][]) {
    for (const [x, y] of fitStroke(track)) expect(Number.isFinite(x + y)).toBe(true);
  }
});
