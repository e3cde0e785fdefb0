// What is known of the chosen member, and of that which it is compared with.

import type { FrontPage } from "../shared/api-types.ts";
import { differences } from "../shared/differences.ts";
import { figured } from "../shared/figures.ts";
import type { View } from "../shared/view.ts";
import { element } from "../viewer/elements.ts";
import { written } from "../shared/written.ts";
import { difference, nameOf } from "./words.ts";

interface Row {
  name: string;
  note: string;
  values: unknown[];
  /** Whether it is in words. */
  said?: boolean;
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
    ["Verdict", rowsOf(views)],
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

function lineOf({ name, note, values, said = false }: Row, two: boolean): HTMLElement {
  const line = element("tr", "");
  const title = element("th", "", { scope: "row" }, name);
  if (note) title.append(element("small", "", {}, note));
  line.append(title, ...values.map((value) => element("td", said ? "said" : "", {}, written(value))));
  if (two) {
    const change = said ? changeOf(String(values[0]), String(values[1])) : difference(values[0], values[1]);
    line.append(element("td", change === "same" ? "same" : said ? "said" : "change", {}, change));
  }
  return line;
}

/** By how much the numbers of a sentence differ from those of another, in its order. */
function changeOf(now: string, other: string): string {
  const change = differences(now, other);
  return change.startsWith("was ") ? "differs" : change || "same";
}

/** Rows of the verdict that every report has, as they are written; none where a shell is not drawn. */
function rowsOf(views: (View | null)[]): Row[] {
  const [first, ...others] = views.map((view) => figured(view?.header.report.verdict ?? []));
  return (first ?? []).flatMap(({ subject, finding }) => {
    const texts = [finding, ...others.map((rows) => rows.find((row) => row.subject === subject)?.finding)];
    return texts.every((text) => text !== undefined) ? [{ name: subject, note: "", values: texts, said: true }] : [];
  });
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
