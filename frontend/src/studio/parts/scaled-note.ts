// Below a target: that the shell follows it scaled, where sizes are asked for.

import { type ScaledTarget, scaledBy } from "../state/fitted.ts";
import type { Store } from "../state/store.ts";
import { h } from "./dom.ts";

const NAMES: Record<ScaledTarget, string> = { f: "f", g: "g", surface: "the surface", pattern: "the drawing" };

export function scaledNote(store: Store, name: ScaledTarget): HTMLElement {
  const note = h("p", { class: "note", hidden: true, "data-testid": `scaled-${name}` });
  const show = (): void => {
    const { design, report, freshness } = store;
    const scaled = freshness.value === "outdated" ? "" : scaledBy(design.value, report.value, name);
    note.textContent = scaled && `For its sizes the shell follows ${NAMES[name]} scaled ${scaled}; here it is as in the file.`;
    note.hidden = !scaled;
  };
  store.design.watch(show);
  store.report.watch(show);
  store.freshness.bind(show);
  return note;
}
