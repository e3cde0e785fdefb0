// A scatter plot as a figure of the studio, with what it shows beneath it.

import type { Frame } from "../../shared/plot.ts";
import type { Scatter } from "../../shared/scatter.ts";
import { h, uniqueId } from "./dom.ts";

const [LEFT, RIGHT, TOP, BOTTOM] = [52, 10, 10, 38];

/** Where the axes of a plot of such a size end. */
export function frameOf(width: number, height: number): Frame {
  return { left: LEFT, right: width - RIGHT, top: TOP, bottom: height - BOTTOM };
}

export function plotFigure({ element }: Scatter, { right, bottom }: Frame, testid: string, caption: string): HTMLElement {
  const id = uniqueId("plot");
  element.setAttribute("viewBox", `0 0 ${right + RIGHT} ${bottom + BOTTOM}`);
  element.dataset["testid"] = testid;
  return h("figure", { class: "front-figure", "aria-labelledby": id }, element, h("figcaption", { id, class: "note" }, caption));
}
