import { expect, test } from "vitest";

import { scaledBy } from "../src/studio/state/fitted.ts";
import type { Design, Report } from "../src/studio/state/types.ts";

const DESIGN = {
  shell: { family: "orthodiagonal", unit: "m" },
  target: { f: { formula: "-x**2", scale: 2 }, g: { formula: "0*x", scale: [4, 5] }, surface: {}, fit: { width: 4 } },
  pattern: {},
} as Design;
const report = (scales: Record<string, number | number[]>): Report => ({ fitted: { scales } }) as unknown as Report;

test.each([
  // The report has the scale that the file would say: its ratio to the file's own is what the target is scaled by.
  ["f", { "target.f.scale": [2, 3] }, "by 1.5 along y"],
  ["f", { "target.f.scale": 3 }, "by 1.5"],
  ["g", { "target.g.scale": [6, 5] }, "by 1.5 along x"],
  ["g", { "target.g.scale": 10 }, "by 2.5 along x and by 2 along y"],
  ["surface", { "target.surface.scale": [1.1, 1, 1.2] }, "by 1.1 along x and by 1.2 along z"],
  ["pattern", { "target.pattern.scale": 0.8 }, "by 0.8"],
  ["g", { "target.f.scale": [2, 3] }, ""],
] as const)("%s of %j", (name, scales, expected) => {
  expect(scaledBy(DESIGN, report(scales as unknown as Record<string, number | number[]>), name)).toBe(expected);
});

test("without sizes nothing is scaled, whatever the last shell was", () => {
  const { fit: _, ...target } = DESIGN.target!;
  expect(scaledBy({ ...DESIGN, target }, report({ "target.f.scale": 3 }), "f")).toBe("");
});
