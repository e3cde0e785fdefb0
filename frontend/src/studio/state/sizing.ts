// Designs as shells: one whose size was chosen by a tolerance, two that differ in their search only.

import { inFamily, isAuto } from "./aims.ts";
import { changed } from "./changed.ts";
import type { Design, Info, Report } from "./types.ts";

/** What the search settles beside rows and columns, where the design leaves it open. */
const SETTLED = ["placement", "spacing", "depth"];

/** The same design with the rows, columns and ways that were chosen, so that they are not sought
 * again; a design without a tolerance as it is. */
export function sized(design: Design, report: Report | null): Design {
  if (!design.tolerance || !report) return design;
  const settled = Object.fromEntries(SETTLED.flatMap((key) => (key in report.parameters ? [[key, report.parameters[key]]] : [])));
  const { rows, columns } = report;
  return changed(design, { tolerance: null, pattern: { ...settled, ...design.pattern, rows, columns } });
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
