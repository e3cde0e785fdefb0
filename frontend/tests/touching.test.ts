import { Vector3 } from "three";
import { expect, test } from "vitest";

import { nearestOf } from "../src/shared/touching.ts";

const square = (z: number, x = 0): Vector3[] => [[0, 0], [1, 0], [1, 1], [0, 1]].map(([u, v]) => new Vector3(x + u!, v, z));

test("panels are as near as their nearest points, sides without length or not", () => {
  expect(nearestOf(square(0), square(2)).gap).toBeCloseTo(2, 12);
  expect(nearestOf(square(0), square(0, 4)).gap).toBeCloseTo(3, 12);
  const [a, b, c] = square(0, 4);
  for (const triangle of [[a, a, b, c], [a, b, c, c]] as Vector3[][]) {
    expect(nearestOf(square(0), triangle).gap).toBeCloseTo(3, 12);
    expect(nearestOf(triangle, square(0)).gap).toBeCloseTo(3, 12);
  }
});
