// A scatter plot: what others beat as faint dots, what none beats as points to choose among.

import { Chooser, type Choice, type ChooserEvents, type Point } from "./chooser.ts";
import { axisAcross, axisUp, type Axis, type Frame } from "./plot.ts";
import { svg } from "./svg.ts";

/** What is drawn; points are values of both axes, and an axis without a name is left out. */
export interface Scattered {
  frame: Frame;
  across: Axis;
  up: Axis;
  written: (value: number) => string;
  dots: readonly Point[];
  best: readonly Choice[];
  /** Whether a line joins the best. */
  joined: boolean;
  /** Which of the best is the knee. */
  knee?: number;
}

export class Scatter {
  readonly element = svg("svg");
  readonly chooser: Chooser;
  /** What lies beneath the points, in places of the picture. */
  readonly marks = svg("g");
  private readonly axes = svg("g");
  private readonly dots = svg("path", { class: "beaten" });
  private readonly line = svg("polyline", { class: "line" });

  constructor(label: string, events: ChooserEvents) {
    this.chooser = new Chooser(this.element, label, events);
    this.element.append(this.axes, this.dots, this.line, this.marks, this.chooser.element);
  }

  draw({ frame, across, up, written, dots, best, joined, knee }: Scattered): void {
    const place = ([x, y]: Point): Point => [across.scale.at(x), up.scale.at(y)];
    this.axes.replaceChildren(...axisAcross(frame, across, written), ...(up.name ? axisUp(frame, up, written) : []));
    this.dots.setAttribute("d", dots.map((each) => `M${place(each).map((one) => one.toFixed(1)).join(" ")}h0`).join(""));
    const choices = best.map((each) => ({ ...each, at: place(each.at) }));
    this.line.setAttribute("points", joined ? choices.map(({ at }) => at.join(",")).join(" ") : "");
    this.chooser.draw(choices, knee);
  }
}
