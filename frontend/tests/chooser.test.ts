import { describe, expect, it } from "vitest";

import { type Point, nearest, next, taken } from "../src/shared/chooser.ts";

describe("points", () => {
  const points: Point[] = [[0, 9], [4, 4], [5, 4], [9, 0]];

  it("are chosen by the nearest within reach", () => {
    expect(nearest(points, [4.4, 4], 3)).toBe(1);
    expect(nearest(points, [4.6, 4], 3)).toBe(2);
    expect(nearest(points, [9, 5], 3)).toBe(-1);
  });

  it("that lie on each other are taken one after the other", () => {
    const lying: Point[] = [[0, 0], [50, 50], [50, 51], [51, 50], [90, 90]];
    const takes = (before: number): number => taken(lying, [48, 50], 10, before);
    expect([0, 1, 2, 3, 4].map(takes)).toEqual([1, 2, 3, 1, 1]);
    expect(taken(lying, [1, 0], 10, 0)).toBe(0);
    expect(taken(lying, [70, 70], 10, 0)).toBe(-1);
  });

  it("follow each other along either axis, and end where they end", () => {
    const along = (axis: 0 | 1, forwards: boolean, from: number): number[] => {
      const way = [from];
      for (let k = 0; k < points.length; k++) way.push(next(points, way.at(-1)!, axis, forwards));
      return way;
    };
    expect(along(0, true, 0)).toEqual([0, 1, 2, 3, 3]);
    expect(along(0, false, 3)).toEqual([3, 2, 1, 0, 0]);
    expect(along(1, true, 3)).toEqual([3, 1, 2, 0, 0]);
    expect(along(1, false, 0)).toEqual([0, 2, 1, 3, 3]);
  });
});
