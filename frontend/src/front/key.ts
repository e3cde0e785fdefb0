// What the marks of the plot mean.

import type { FrontPage } from "../shared/api-types.ts";
import { element } from "../viewer/elements.ts";
import { diamond } from "../shared/chooser.ts";
import { svg } from "../shared/svg.ts";
import { square } from "./plot.ts";

export function keyOf(page: FrontPage, outside: number): HTMLElement[] {
  const beyond = outside ? ` (${outside} more beyond the plot)` : "";
  return [
    entry("no other beats it", svg("circle", { class: "dot", cx: 9, cy: 9, r: 5 })),
    entry("knee", svg("path", { class: "dot knee", d: diamond(9, 9) })),
    ...(page.beaten.length ? [entry(`others beat it${beyond}`, svg("path", { class: "beaten", d: "M9 9h0" }))] : []),
    ...(page.baseline ? [entry("the design to begin with", svg("path", { class: "begun", d: square(9, 9) }))] : []),
  ];
}

function entry(words: string, mark: SVGElement): HTMLElement {
  const item = element("li", "");
  const drawing = svg("svg", { width: 18, height: 18, viewBox: "0 0 18 18", "aria-hidden": "true" });
  drawing.append(mark);
  item.append(drawing, words);
  return item;
}
