// The verdict on a shell, in the words of its report: what speaks against it, what wants attention, what holds.

import type { Row } from "./api-types.ts";

export const SIGNS = { fails: "\u2715", warns: "!", holds: "\u2713" } as const;
const MEANS = { fails: "fails", warns: "attention", holds: "holds" } as const;

/** A list of findings, worst first; what only informs stands among the figures. */
export function verdictList(rows: readonly Row[]): HTMLElement {
  const list = document.createElement("ul");
  list.className = "orishell-verdict";
  for (const { sign, subject, finding, remedy } of rows) {
    if (sign === "says") continue;
    const row = document.createElement("li");
    row.dataset["sign"] = sign;
    const mark = document.createElement("span");
    mark.textContent = SIGNS[sign];
    mark.setAttribute("role", "img");
    mark.setAttribute("aria-label", MEANS[sign]);
    const name = document.createElement("b");
    name.textContent = subject;
    row.append(mark, name, ` ${finding}`);
    if (remedy) {
      const mends = document.createElement("i");
      mends.textContent = ` \u2192 ${remedy}`;
      row.append(mends);
    }
    list.append(row);
  }
  return list;
}
