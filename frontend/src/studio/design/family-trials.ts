// What every family makes of the target, where the family is to be chosen: a table, filled as they are tried.

import type { FamilyTrial } from "../../shared/api-types.ts";
import { sentence } from "../../shared/words.ts";
import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import { inFamily, isAuto } from "../state/aims.ts";
import type { Store } from "../state/store.ts";

const COLUMNS: [string, string][] = [
  ["Distance", "the largest distance between shell and target, both ways"],
  ["Panels", "number of panels"],
  ["Sheet", "area of the flat sheet, or of all strips"],
  ["Packs flat", "whether its motion ends with all panels in one plane"],
  ["Locks", "whether anything in it stops it at the target"],
];

export function familyTrials(store: Store): HTMLElement {
  const table = h("table", {});
  const note = h("p", { class: "note" });
  const element = h("div", { class: "family-trials", "data-testid": "family-trials", role: "region", "aria-label": "What the families make of the target" }, table, note);
  const refresh = (): void => {
    const { trials, design, fitting, freshness } = store;
    const found = trials.value;
    element.hidden = !isAuto(design.value) || !found?.tried.length;
    if (element.hidden) return;
    table.replaceChildren(
      h("thead", {}, h("tr", {}, ...COLUMNS.map(([name, title]) => h("th", { scope: "col", title }, name)))),
      ...found!.tried.map((trial) => rows(store, trial, trial.family === found!.family)),
    );
    const under = fitting.value || freshness.value === "computing";
    note.textContent = found!.family ? "Taken: the nearest of those that lock; where none does, the nearest. One made in strips only where no other makes a shell." : under ? "More families are being tried." : "";
    note.hidden = !note.textContent;
  };
  for (const signal of [store.trials, store.design, store.fitting, store.freshness]) (signal as { bind(listener: () => void): void }).bind(refresh);
  return element;
}

/** A family: its name over its numbers, or over the reason why it makes no shell. */
function rows(store: Store, trial: FamilyTrial, taken: boolean): HTMLElement {
  const { info, design, labels } = store;
  const { family, distance } = trial;
  const label = info.families[family]?.label ?? family;
  const made = distance !== null;
  const goOn = button({
    label: `Go on with ${label}`,
    text: "Go on",
    testid: `go-on-${family}`,
    act: () => store.change(inFamily(info, design.value, family), "family"),
  });
  const name = h("th", { scope: "rowgroup", colspan: made ? 4 : 5 }, label, trial.in_strips ? " in strips" : null, taken ? h("span", { class: "taken" }, "taken") : null);
  const { unit } = design.value.shell;
  const cells = made
    ? [`${short(distance, 3)} ${unit}`, String(trial.panels), `${short(trial.sheet_area ?? 0, 3)} ${unit}\u00b2`, yes(trial.packs_flat), yes(trial.locks)].map((text) => h("td", {}, text))
    : [h("td", { class: "why-not", colspan: 5 }, sentence(labels.said(trial.why_not)))];
  return h(
    "tbody",
    { class: taken ? "taken" : null, "data-family": family },
    h("tr", {}, name, made ? h("td", {}, goOn) : null),
    h("tr", {}, ...cells),
  );
}

function yes(value: boolean | null): string {
  return value ? "yes" : "no";
}
