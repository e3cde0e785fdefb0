// Designs as shells: one whose size was chosen by a tolerance, two that differ in their search only.

import { inFamily, isAuto } from "./aims.ts";
import { changed } from "./changed.ts";
import type { Design, Info, Report } from "./types.ts";

/** What the search settles beside rows and columns, where the design leaves it open or to it. */
const SETTLED = ["placement", "spacing", "depth", "xi_deg", "theta_deg", "sector_deg", "stage_deg"];

/** The same design with the rows, columns and ways that were chosen, so that they are not sought
 * again; a design without a tolerance as it is. */
export function sized(design: Design, report: Report | null): Design {
  if (!design.tolerance || !report) return design;
  const { pattern } = design;
  const open = SETTLED.filter((key) => key in report.parameters && (pattern[key] ?? "auto") === "auto");
  const settled = Object.fromEntries(open.map((key) => [key, report.parameters[key]]));
  const { rows, columns } = report;
  return changed(design, { tolerance: null, pattern: { ...pattern, ...settled, rows, columns } });
}

/** The same design with all that was chosen: its family, too. */
export function settled(info: Info, design: Design, report: Report | null): Design {
  return sized(isAuto(design) && report ? inFamily(info, design, report.family) : design, report);
}

/** Whether two designs, one of which came from the other, differ in what is searched for only. */
export function isSameShell(design: Design, before: Design): boolean {
  const { search: _, ...now } = design;
  const { search: __, ...then } = before;
  const names = new Set([...Object.keys(now), ...Object.keys(then)]) as Set<keyof typeof now>;
  return [...names].every((name) => Object.is(now[name], then[name]));
}
