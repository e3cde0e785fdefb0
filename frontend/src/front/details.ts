// What is known of the chosen member, and of that which it is compared with.

import type { FrontPage } from "../shared/api-types.ts";
import { length, threeDigits } from "../shared/quantities.ts";
import type { View } from "../shared/view.ts";
import { element } from "../viewer/elements.ts";
import { written } from "../shared/written.ts";
import { difference, nameOf } from "./words.ts";

interface Row {
  name: string;
  note: string;
  values: unknown[];
  /** Where it is not written as a bare value. */
  texts?: string[];
}

/** The table of one member, or of two with their differences. */
export function tableOf(page: FrontPage, numbers: number[], views: (View | null)[]): HTMLElement {
  const members = numbers.map((number) => page.members[number]!);
  const figures = page.figures.map(({ name, note }, k): Row => ({ name, note, values: members.map((each) => each.figures[k]) }));
  const wanted = page.figures.map(({ minimised }) => minimised);
  const groups: [string, Row[]][] = [
    ["Minimise", figures.filter((_, k) => wanted[k])],
    ["Limited", figures.filter((_, k) => !wanted[k])],
    ["Variables", page.variables.map((name, k) => ({ name, note: "", values: members.map((each) => each.values[k]) }))],
    ["Sizes", sizesOf(views)],
  ];
  const table = element("table", "figures-table");
  const two = members.length === 2;
  const head = element("tr", "");
  head.append(element("td", ""));
  members.forEach(({ file }, k) => head.append(element("th", k ? "pinned" : "chosen", { scope: "col" }, nameOf(file))));
  if (two) head.append(element("th", "", { scope: "col" }, "difference"));
  const top = element("thead", "");
  top.append(head);
  if (two) table.append(top);
  else table.setAttribute("aria-label", nameOf(members[0]!.file));
  for (const [title, rows] of groups) {
    if (!rows.length) continue;
    const body = element("tbody", "");
    const line = element("tr", "group");
    line.append(element("th", "", { scope: "rowgroup", colspan: String(two ? 4 : 2) }, title));
    body.append(line, ...rows.map((row) => lineOf(row, two)));
    table.append(body);
  }
  return table;
}

function lineOf({ name, note, values, texts }: Row, two: boolean): HTMLElement {
  const line = element("tr", "");
  const title = element("th", "", { scope: "row" }, name);
  if (note) title.append(element("small", "", {}, note));
  line.append(title, ...values.map((value, k) => element("td", "", {}, texts?.[k] ?? written(value))));
  if (two) {
    const change = difference(values[0], values[1]);
    line.append(element("td", change === "same" ? "same" : "change", {}, change));
  }
  return line;
}

/** Sizes that every report has; none where a shell is not drawn. */
function sizesOf(views: (View | null)[]): Row[] {
  const reports = views.flatMap((view) => (view ? [view.header.report] : []));
  if (reports.length < views.length || !views.length) return [];
  const unit = views[0]!.header.unit;
  const row = (name: string, read: (report: (typeof reports)[number]) => number | null | undefined, say: (value: number) => string): Row[] => {
    const values = reports.map(read);
    if (values.some((value) => value === null || value === undefined)) return [];
    return [{ name, note: "", values, texts: values.map((value) => say(value!)) }];
  };
  const sized = (value: number): string => length(value, unit);
  return [
    ...row("width", ({ deployed }) => deployed?.width, sized),
    ...row("depth", ({ deployed }) => deployed?.depth, sized),
    ...row("height", ({ deployed }) => deployed?.height, sized),
    ...row("flat sheet, width", ({ sheet }) => sheet?.width, sized),
    ...row("flat sheet, height", ({ sheet }) => sheet?.height, sized),
    ...row("motion ends at", ({ lock }) => lock?.drive_deg, (value) => `${threeDigits(value)}\u00b0`),
  ];
}

/** What it gains and costs to take a neighbour instead. */
export function stepsOf(page: FrontPage, number: number, pick: (number: number) => void): HTMLElement {
  const list = element("ul", "steps");
  for (const { to, words } of page.members[number]!.steps) {
    const item = element("li", "");
    const mark = to === page.knee ? ", the knee" : "";
    const button = element("button", "step", { type: "button" }, `${to < number ? "\u2190" : "\u2192"} ${nameOf(page.members[to]!.file)}${mark}`);
    button.addEventListener("click", () => pick(to));
    item.append(button, element("p", "", {}, words));
    list.append(item);
  }
  return list;
}
