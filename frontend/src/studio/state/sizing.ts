// A design whose size was chosen by a tolerance, as one that says its size itself.

import type { Design, Report } from "./types.ts";

/** What the search settles beside rows and columns, where the design leaves it open. */
const SETTLED = ["placement", "spacing", "depth"];

/** The same design with the rows, columns and ways that were chosen, so that they are not sought
 * again; a design without a tolerance as it is. */
export function sized(design: Design, report: Report | null): Design {
  if (!design.tolerance || !report) return design;
  const { tolerance: _, ...rest } = design;
  const pattern: Design["pattern"] = { ...design.pattern, rows: report.rows, columns: report.columns };
  for (const key of SETTLED) {
    const taken = report.parameters[key];
    if (!(key in design.pattern) && taken !== undefined) pattern[key] = taken;
  }
  return { ...rest, pattern };
}
