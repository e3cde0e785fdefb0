import { describe, expect, test } from "vitest";

import { fitPoints, placeAmong, splineThrough } from "../src/studio/curves/spline.ts";
import type { Point } from "../src/studio/state/types.ts";
import scipy from "./spline.json";

describe("the spline through control points is SciPy's", () => {
  scipy.points.forEach((points, k) => {
    test(`through ${points.length} points`, () => {
      const spline = splineThrough(points as Point[]);
      scipy.shares.forEach((share, i) => {
        const [x, y] = spline(share);
        expect(x).toBeCloseTo(scipy.drawn[k]![i]![0]!, 11);
        expect(y).toBeCloseTo(scipy.drawn[k]![i]![1]!, 11);
      });
    });
  });
});

test("points fitted to a parabola put a spline within 0.3 % of it", () => {
  const samples = Array.from({ length: 101 }, (_, i): Point => [i / 50 - 1, -((i / 50 - 1) ** 2)]);
  const fitted = fitPoints(samples);
  expect(fitted.length).toBeLessThan(9);
  expect(fitted[0]).toEqual([-1, -1]);
  expect(fitted.at(-1)).toEqual([1, -1]);
  const spline = splineThrough(fitted);
  const size = Math.hypot(2, 1);
  for (let i = 0; i <= 100; i++) {
    const [x, y] = spline(i / 100);
    expect(Math.abs(y + x * x)).toBeLessThan(0.006 * size);
  }
});

test("a new point goes where it lengthens the polyline least", () => {
  const points: Point[] = [[0, 0], [1, 0], [2, 0]];
  expect(placeAmong(points, [-1, 0])).toBe(0);
  expect(placeAmong(points, [1.4, 0.1])).toBe(2);
  expect(placeAmong(points, [3, 0.5])).toBe(3);
});
