// What uses most of what it bears, flagged in the scene while a load case is shown.

import type { Drawn } from "../../shared/loaded3d.ts";
import { threeDigits } from "../../shared/quantities.ts";
import type { Shell3D } from "../../shared/shell3d.ts";
import { h } from "../parts/dom.ts";
import type { Pinned } from "./pinned.ts";

export function flagWorst(shell: Shell3D, pinned: Pinned): void {
  const flag = h("div", { class: "scene-flag", "data-testid": "worst-flag" });
  let shown: Drawn | null = null;
  pinned.add(flag, () => {
    const { load } = shell;
    if (load !== shown) flag.textContent = load ? wordsOf(load) : "";
    shown = load;
    return load?.at ?? null;
  });
}

function wordsOf({ measure, most, of }: Drawn): string {
  return `${measure === "utilisation" ? `${threeDigits(100 * most)} %` : `${threeDigits(most)} MPa`}, ${of ?? ""}`;
}
