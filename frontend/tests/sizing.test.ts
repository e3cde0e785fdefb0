import { expect, it } from "vitest";

import { sized } from "../src/studio/state/sizing.ts";
import type { Design, Report } from "../src/studio/state/types.ts";

const design = {
  shell: { family: "longitudinal-linear-repeating", unit: "m" },
  target: {},
  pattern: { stage_deg: "auto", sector_deg: [85, 80, 95, 100], flap: "auto" },
  tolerance: { surface: 0.36 },
} as unknown as Design;
const report = {
  rows: 1,
  columns: 6,
  parameters: { stage_deg: 10.03, sector_deg: [85, 80, 95, 100.1], spacing: "equal", flap: 1.25 },
} as unknown as Report;

it("a design whose size was chosen keeps all that the search chose, and what was given", () => {
  const { tolerance, pattern } = sized(design, report);
  expect(tolerance).toBeUndefined();
  expect(pattern).toEqual({ rows: 1, columns: 6, stage_deg: 10.03, spacing: "equal", sector_deg: [85, 80, 95, 100], flap: "auto" });
});

it("a design without a tolerance, or without a shell, stays as it is", () => {
  expect(sized(design, null)).toBe(design);
  const { tolerance: _, ...free } = design;
  expect(sized(free as Design, report)).toBe(free);
});
