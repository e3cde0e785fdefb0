// Figures that only the page knows: headroom, the smallest and the largest panel.

import { area, length } from "../../shared/quantities.ts";
import { UNKNOWN } from "../../shared/figures.ts";
import { sheetOf } from "../../shared/inspect.ts";
import { Person3D } from "../../shared/person3d.ts";
import { panelCount, panelName, type View } from "../../shared/view.ts";
import { h } from "../parts/dom.ts";
import type { Selection } from "./selection.ts";
import type { Measured, Standing } from "./standing.ts";

/** Put them among the others: headroom below the sizes, panels below their number. */
export function addFigures(figures: HTMLElement, view: View, standing: Standing, selection: Selection): void {
  const { unit } = view.header;
  const room = headroomWords(view, standing.headroom.value);
  if (room) row(figures, "deployed", "headroom", "Headroom", room, Person3D.suits(view) ? "over a person's width, where most" : "clear, where most");
  if (panelCount(view) < 2) return;
  const { smallest, largest, areas, shortest } = sheetOf(view);
  for (const [key, name, panel] of [["largest", "Largest", largest], ["smallest", "Smallest", smallest]] as const) {
    const what = panelName(view, panel);
    const choose = h(
      "button",
      { type: "button", class: "figure-link", "data-testid": `figure-${key}`, title: `Show ${what}`, onclick: () => selection.chosen.set({ panel, edge: null }) },
      area(areas[panel]!, unit),
    );
    row(figures, "panels", key, name, choose, `${what}, shortest side ${length(shortest[panel]!, unit)}`);
  }
}

/** The headroom of a shell, once it is measured; until then that it is not known, but where the shell
 * before has none. */
export function headroomWords(view: View, measured: Measured | null): string {
  if (measured && !measured.room) return "";
  return measured?.view === view ? length(measured.room!.height, view.header.unit) : UNKNOWN;
}

function row(figures: HTMLElement, after: string, key: string, name: string, value: string | HTMLElement, note: string): void {
  figures
    .querySelector(`[data-figure="${after}"]`)
    ?.after(h("div", { "data-figure": key }, h("dt", {}, name), h("dd", {}, h("span", { class: value === UNKNOWN ? "orishell-pending" : "orishell-number" }, value), h("small", {}, note))));
}
