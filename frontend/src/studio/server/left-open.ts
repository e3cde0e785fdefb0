import type { View } from "../../shared/view.ts";

/** Take from a view what only the proof can say: the figures then call it not yet known. */
export function leaveOpen(view: View): void {
  const { lock: _, deviation, ...rest } = view.header.report;
  const { surface: _surface, ...known } = deviation ?? {};
  view.header.report = { ...rest, deviation: known };
  view.header.contact = null;
}
