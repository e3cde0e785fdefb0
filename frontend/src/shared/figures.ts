// The figures of a shell: the rows of its verdict as they are written, in every page as in terminal and report.

import type { Row } from "./api-types.ts";
import { panelCount, type View } from "./view.ts";
import { capital } from "./words.ts";

export const UNKNOWN = "not yet known";
/** Rows that judge, and have figures that are compared. */
const FIGURED = new Set(["held", "locks", "packs", "stands"]);
/** In which group a row is, by its subject; all others are of the way and of loads. */
const GROUPS: Record<string, string> = {
  approach: "Shell", deployed: "Shell", family: "Shell", feet: "Shell", surface: "Shell", tilted: "Shell", turned: "Shell", sheet: "Sheet",
};
const LAST = "Deployment and loads";

/** What a row is called as a figure: what holds a shell is one, whichever way it does. */
const KEYS: Record<string, string> = { held: "locks" };

/** Names and figures in three groups; `container` is emptied first. `said` puts texts into the page's words. */
export function renderFigures(container: HTMLElement, view: View, said = (text: string): string => text): void {
  const groups = new Map<string, HTMLElement[]>([["Shell", []], ["Sheet", panelsOf(view)], [LAST, []]]);
  for (const row of figured(view.header.report.verdict ?? [])) {
    groups.get(GROUPS[row.subject] ?? LAST)!.push(rowOf(capital(row.subject), said(row.finding), "", KEYS[row.subject] ?? row.subject));
  }
  container.replaceChildren(...[...groups].flatMap(([title, rows]) => group(title, rows)));
}

/** Rows that inform, and those that judge by figures. */
export function figured(rows: readonly Row[]): Row[] {
  return rows.filter(({ sign, subject }) => sign === "says" || FIGURED.has(subject));
}

/** A heading, and rows below it; nothing if there are none. */
function group(title: string, rows: HTMLElement[]): HTMLElement[] {
  if (!rows.length) return [];
  const list = document.createElement("dl");
  list.className = "orishell-figures";
  list.append(...rows);
  const head = document.createElement("h2");
  head.className = "orishell-group";
  head.textContent = title;
  return [head, list];
}

/** How many panels there are, and how many of them are clipped on, as the report counts them. */
function panelsOf(view: View): HTMLElement[] {
  const { grid, names, report } = view.header;
  const count = names ? new Set(names).size : panelCount(view);  // parts of one have one name
  const { panels = count, clipped = 0 } = report.quantities ?? {};
  const counted = grid && !names ? `${grid[0] - 1} \u00d7 ${grid[1] - 1}` : "";
  const note = clipped ? `${counted || count}, and ${clipped} clipped on` : counted;
  return [rowOf("Panels", panels.toLocaleString("en").replaceAll(",", "\u202f"), note, "panels")];
}

function rowOf(name: string, value: string, note: string, key: string): HTMLElement {
  const row = document.createElement("div");
  row.dataset["figure"] = key;
  const term = document.createElement("dt");
  term.textContent = name;
  const figure = document.createElement("dd");
  const number = document.createElement("span");
  number.className = value.startsWith("not known") ? "orishell-pending" : "orishell-number";
  number.textContent = value;
  figure.append(number);
  if (note) {
    const small = document.createElement("small");
    small.textContent = note;
    figure.append(small);
  }
  row.append(term, figure);
  return row;
}
