import { expect, test } from "vitest";

import type { CaseResult, Analysis } from "../src/shared/api-types.ts";
import { structureFigures } from "../src/shared/structure-figures.ts";

function caseOf(name: string, creases: CaseResult["creases"], displaced: number | null): CaseResult {
  const equilibrium = displaced === null ? null : { displacement: { size: displaced } };
  return { name, creases, loads: [], load: [0, 0, 0], equilibrium } as unknown as CaseResult;
}

const reportOf = (cases: CaseResult[], governs: Analysis["governs"] = null): Analysis =>
  ({ cases, governs, warnings: [], not_covered: [] }) as unknown as Analysis;

test("a shell that was not analysed has no figures", () => {
  expect(structureFigures(null, "m")).toEqual([]);
});

test("the largest displacement and what governs are named with their cases", () => {
  const cases = [caseOf("snow", "free", null), caseOf("wind", "free", 0.02), caseOf("snow", 150, 0.05), caseOf("wind", 150, 0.01)];
  const governs = { part: "ties", case: "wind", creases: "free", utilisation: 0.803 } as const;
  expect(structureFigures(reportOf(cases, governs), "m")).toEqual([
    { name: "Displacement", value: "50 mm", note: "at most, under snow, creases of 150 N" },
    { name: "Utilisation", value: "80.3 %", note: "the force in a tie governs, under wind, free creases" },
  ]);
});

test("with one stiffness of creases it is not said", () => {
  expect(structureFigures(reportOf([caseOf("snow", "rigid", 2)]), "mm")).toEqual([
    { name: "Displacement", value: "2 mm", note: "at most, under snow" },
  ]);
});
