import { describe, expect, it } from "vitest";
import type { Trial } from "../src/shared/api-types.ts";
import { LogScale, keyOf, nearestTo, roundUp, toleranceOf, withSizes, withTolerance } from "../src/studio/design/front.ts";
import type { Design } from "../src/studio/state/types.ts";

function trial(rows: number, columns: number, error: number): Trial {
  return { rows, columns, panels: (rows + 1) * (columns - 1), error, shortest: 1, longest: 2 };
}

const design: Design = {
  shell: { family: "orthodiagonal", unit: "m" },
  target: { f: { formula: "-x**2" }, g: { formula: "0*x" } },
  pattern: { rows: 9, columns: 11, flap: 0.3 },
};

describe("tolerances that are offered", () => {
  it("are never below what the sheet keeps", () => {
    for (const error of [0.2259359, 0.226, 1e-7, 1234.5678, 0.99999, 9.999e5, 0.1, 3]) {
      for (const digits of [2, 3, 6]) {
        expect(roundUp(error, digits)).toBeGreaterThanOrEqual(error);
        expect(roundUp(error, digits)).toBeLessThan(error * (1 + 10 ** (1 - digits)) * (1 + 1e-12));
      }
    }
    expect(toleranceOf(trial(9, 11, 0.2259359))).toBe(0.226);
    expect(roundUp(0.226, 3)).toBe(0.226);
    expect(roundUp(0, 3)).toBe(0);
  });
});

describe("the best sizes", () => {
  it("are near the present ones by the share of panels", () => {
    const best = [trial(3, 3, 3), trial(5, 8, 2), trial(21, 21, 1)];
    expect(nearestTo(40, best)).toBe(1);
    expect(nearestTo(10_000, best)).toBe(2);
    expect(nearestTo(0, best)).toBe(0);
  });

  it("take the place of a tolerance, with what was settled beside them", () => {
    const tolerated = withTolerance(design, { surface: 0.2 });
    expect(tolerated.pattern).toEqual({ flap: 0.3 });
    const taken = withSizes(tolerated, trial(5, 8, 2), { placement: "balanced", flap: 9 });
    expect(taken).toEqual({ ...design, pattern: { rows: 5, columns: 8, flap: 0.3, placement: "balanced" } });
    expect("tolerance" in taken).toBe(false);
  });

  it("stay known while only sizes and the distance change", () => {
    const tolerated = withTolerance(design, { surface: 0.2 });
    expect(keyOf(tolerated)).toBe(keyOf(design));
    expect(keyOf(withTolerance(design, { surface: 0.3 }))).toBe(keyOf(design));
    expect(keyOf(withTolerance(design, { surface: 0.2, panel_max: 1 }))).not.toBe(keyOf(design));
    expect(keyOf({ ...design, pattern: { ...design.pattern, flap: 0.4 } })).not.toBe(keyOf(design));
  });
});

describe("a logarithmic scale", () => {
  it("puts equal ratios equally far apart, with room at both ends", () => {
    const scale = LogScale.of([1, 100], 0, 100);
    expect(scale.at(10) - scale.at(1)).toBeCloseTo(scale.at(100) - scale.at(10), 9);
    expect(scale.at(1)).toBeGreaterThan(0);
    expect(scale.at(100)).toBeLessThan(100);
  });

  it("has few ticks, within it", () => {
    expect(LogScale.of([0.05, 5.4], 0, 1).ticks()).toEqual([0.05, 0.1, 0.2, 0.5, 1, 2, 5]);
    expect(LogScale.of([4, 1122], 0, 1).ticks()).toEqual([10, 100, 1000]);
    expect(LogScale.of([3, 3], 0, 1).ticks().every((tick) => tick > 2 && tick < 4)).toBe(true);
  });
});
