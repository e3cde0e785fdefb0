// A design to be drawn: both curves are still missing.

import { NO_CURVE, isCurve, isWhole } from "./curve-table.ts";
import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import type { Store } from "../state/store.ts";
import type { CurveName, Design, Value } from "../state/types.ts";

const SIZES = { rows: 9, columns: 11 };

/** The present family and unit, its parameters as it would choose them, and no curves. */
export function blankDesign(store: Store): { name: string; design: Design } {
  const { family, unit } = store.design.value.shell;
  const pattern: Record<string, Value> = { ...SIZES };
  for (const { key, auto, default: value } of store.info.families[family]!.parameters) {
    // What must be given, and what has no value yet, is left to the program.
    if (value === null && auto) pattern[key] = "auto";
  }
  return { name: "shell", design: { shell: { family, unit }, target: { f: { ...NO_CURVE }, g: { ...NO_CURVE } }, pattern } };
}

/** Stands in the shell's place until there is one. */
export function blankCover(store: Store, draw: (names: CurveName[]) => void): HTMLElement {
  const words = h("p", {});
  const begin = button({ label: "Draw", text: "Draw", class: "button primary", testid: "draw-missing", act: () => draw(missing()) });
  const cover = h("div", { class: "blank-cover", role: "status", "data-testid": "blank", hidden: true }, words, begin);
  const missing = (): CurveName[] =>
    isWhole(store.design.value) ? [] : (["f", "g"] as const).filter((name) => !isCurve(store.design.value.target?.[name] ?? NO_CURVE));
  const refresh = (): void => {
    const { design, freshness } = store;
    if (missing().length) cover.hidden = false;
    // It stays until the first shell of the new curves is there.
    else if (isWhole(design.value) && freshness.value !== "computing") cover.hidden = true;
    const which = missing();
    begin.hidden = !which.length;
    words.textContent =
      which.length === 2
        ? "Draw the profile f and the path g: the shell appears here."
        : which.length
          ? `Now draw the ${which[0] === "f" ? "profile f" : "path g"}: the shell appears here.`
          : "The shell appears here.";
  };
  store.design.bind(refresh);
  store.freshness.watch(refresh);
  return cover;
}
