import { expect, test } from "vitest";

import { doorOf, usualDoor, walled, wallAt, withWall } from "../src/studio/design/end-wall-table.ts";
import type { Design } from "../src/studio/state/types.ts";

const design = (end_wall?: Design["end_wall"], unit = "m"): Design => ({ shell: { family: "orthodiagonal", unit }, pattern: {}, ...(end_wall ? { end_wall } : {}) });

test("each end has a wall or none, and those of the file keep their order", () => {
  const one = design(withWall(design(), "last", { at: "last" }));
  expect(one.end_wall).toEqual([{ at: "last" }]);
  const both = design(withWall(one, "first", { at: "first" }));
  expect(both.end_wall).toEqual([{ at: "last" }, { at: "first" }]);
  expect(withWall(both, "last", { at: "last", gap: 0.02 })).toEqual([{ at: "last", gap: 0.02 }, { at: "first" }]);
  expect(withWall(both, "last", undefined)).toEqual([{ at: "first" }]);
  expect(withWall(one, "last", undefined)).toBeUndefined();
  expect(wallAt(both, "first")).toEqual({ at: "first" });
  expect(wallAt(one, "first")).toBeUndefined();
});

test("a wall keeps what else it says", () => {
  const wall = { at: "last", gap: 0.02, door: { width: 0.8, height: 2, offset: 0.2 } } as unknown as Parameters<typeof walled>[0];
  expect(walled(wall, "last", "gap", null)).toEqual({ at: "last", door: { width: 0.8, height: 2, offset: 0.2 } });
  expect(doorOf(walled(wall, "last", "door", null))).toBeUndefined();
  expect(walled(undefined, "first", "gap", 0.1)).toEqual({ at: "first", gap: 0.1 });
});

test("a new door is 0.9 x 2 m in every unit", () => {
  expect(usualDoor(design())).toEqual({ width: 0.9, height: 2 });
  expect(usualDoor(design(undefined, "mm"))).toEqual({ width: 900, height: 2000 });
  expect(usualDoor(design(undefined, "ft"))).toEqual({ width: 3, height: 6.6 });
});
