// The structure's figures in a few lines: how far the shell is displaced, and what governs.

import type { CaseResult, Analysis } from "./api-types.ts";
import { GOVERNING } from "./api-words.ts";
import { length, threeDigits } from "./quantities.ts";

export interface Figure {
  name: string;
  value: string;
  note: string;
}

export function structureFigures(report: Analysis | null, unit: string): Figure[] {
  if (!report) return [];
  const { cases, governs } = report;
  const figures: Figure[] = [];
  const held = cases.filter(({ equilibrium }) => equilibrium !== null);
  if (held.length) {
    const size = (each: CaseResult): number => each.equilibrium!.displacement.size;
    const worst = held.reduce((most, each) => (size(each) > size(most) ? each : most));
    figures.push({ name: "Displacement", value: length(size(worst), unit), note: `at most, under ${namesOf([worst], cases)}` });
  }
  if (governs) {
    const found = cases.filter(({ name, creases }) => name === governs.case && creases === governs.creases);
    figures.push({
      name: "Utilisation", value: `${threeDigits(100 * governs.utilisation)} %`,
      note: `${GOVERNING[governs.part]} governs${report.carries === null ? " of what is known" : ""}, under ${namesOf(found, cases)}`,
    });
  }
  return figures;
}

/** Names of cases, the stiffness of creases said where there are several. */
function namesOf(some: CaseResult[], all: CaseResult[]): string {
  const several = new Set(all.map(({ creases }) => creases)).size > 1;
  const stiffness = ({ creases }: CaseResult): string =>
    typeof creases === "string" ? `${creases} creases` : `creases of ${threeDigits(creases)} N`;
  return some.map((each) => (several ? `${each.name}, ${stiffness(each)}` : each.name)).join("; ");
}
