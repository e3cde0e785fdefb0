// The plot of panels against distance: all sizes faint, the best as points that are chosen.

import type { Tradeoff, Trial } from "../../shared/api-types.ts";
import { axisAcross, axisUp } from "../../shared/plot.ts";
import { h, nearestTo, s, setAttribute, uniqueId } from "../parts/dom.ts";
import { LogScale } from "./front.ts";
import { short } from "../parts/numbers.ts";

const WIDTH = 352;
const HEIGHT = 232;
const LEFT = 48;
const RIGHT = 10;
const TOP = 8;
const BOTTOM = 38;
const FRAME = { left: LEFT, right: WIDTH - RIGHT, top: TOP, bottom: HEIGHT - BOTTOM };

export class TradeoffPlot {
  readonly element: HTMLElement;
  private readonly frame = s("g", {});
  private readonly cloud = s("g", { class: "beaten", "aria-hidden": "true" });
  private readonly line = s("polyline", { class: "line" });
  private readonly allowed = s("line", { class: "limit", x1: LEFT, x2: WIDTH - RIGHT });
  private readonly now = s("circle", { class: "begun", r: 8 }, s("title", {}, "the shell on the screen"));
  private readonly points = s("g", { role: "radiogroup", "aria-label": "Sizes that no other beats" });
  private best: readonly Trial[] = [];
  private chosen = 0;
  private panels: LogScale | null = null;
  private errors: LogScale | null = null;
  private present: { rows: number; columns: number; error: number | undefined } | null = null;

  constructor(private readonly picked: (trial: Trial) => void) {
    const id = uniqueId("tradeoff");
    const drawing = s(
      "svg",
      { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, "data-testid": "tradeoff-plot", onclick: (event: MouseEvent) => this.click(event) },
      this.frame, this.allowed, this.cloud, this.line, this.now, this.points,
    );
    this.points.addEventListener("keydown", (event) => this.key(event));
    this.element = h(
      "figure",
      { class: "front-figure", "aria-labelledby": id },
      h("figcaption", { id, class: "note" }, "Largest distance from the surface against the number of panels. Choose a point."),
      drawing,
    );
  }

  draw({ tried, best }: Tradeoff, unit: string, tolerance: number | undefined): void {
    this.best = best;
    const errors = [...tried, ...best].map(({ error }) => error);
    this.panels = LogScale.of(tried.map(({ panels }) => panels), LEFT, WIDTH - RIGHT);
    this.errors = LogScale.of(errors, HEIGHT - BOTTOM, TOP);
    const { panels: across, errors: up } = this;
    this.frame.replaceChildren(
      ...axisAcross(FRAME, { ticks: across.ticks(), at: (value) => across.at(value), written: short, name: "panels" }),
      ...axisUp(FRAME, { ticks: up.ticks(), at: (value) => up.at(value), written: short, name: `distance (${unit})` }),
    );
    const place = ({ panels, error }: Trial): [number, number] => [this.panels!.at(panels), this.errors!.at(error)];
    this.cloud.replaceChildren(
      ...tried.map((trial) => {
        const [cx, cy] = place(trial);
        return s("circle", { cx, cy, r: 2.5 });
      }),
    );
    setAttribute(this.line, "points", best.map((trial) => place(trial).join(",")).join(" "));
    this.points.replaceChildren(
      ...best.map((trial, number) => {
        const [cx, cy] = place(trial);
        const words = `${trial.rows} rows, ${trial.columns} columns: ${trial.panels} panels, ${short(trial.error, 3)} ${unit}`;
        return s(
          "g",
          { class: "point", role: "radio", "aria-label": words, "data-testid": `front-${number}` },
          s("title", {}, words),
          s("circle", { class: "touched", cx, cy, r: 12 }),
          s("circle", { class: "dot", cx, cy, r: 4.5 }),
        );
      }),
    );
    this.limit(tolerance);
    this.markPresent();
    this.show();
  }

  /** The tolerance as a line. */
  limit(tolerance: number | undefined): void {
    const { errors } = this;
    const seen = !!errors && tolerance !== undefined && tolerance >= errors.low && tolerance <= errors.high;
    this.allowed.toggleAttribute("hidden", !seen);
    if (!seen) return;
    const y = errors!.at(tolerance!);
    setAttribute(this.allowed, "y1", y);
    setAttribute(this.allowed, "y2", y);
  }

  /** The shell on the screen as a ring. */
  mark(rows: number, columns: number, error: number | undefined): void {
    this.present = { rows, columns, error };
    this.markPresent();
  }

  select(trial: Trial): void {
    this.chosen = Math.max(0, this.best.indexOf(trial));
    this.show();
  }

  private markPresent(): void {
    const { present, panels, errors } = this;
    const at = present && panels ? (present.rows + 1) * (present.columns - 1) : 0;
    const error = present?.error;
    const seen = !!errors && !!panels && error !== undefined
      && at >= panels.low && at <= panels.high && error >= errors.low && error <= errors.high;
    this.now.toggleAttribute("hidden", !seen);
    if (!seen) return;
    setAttribute(this.now, "cx", panels!.at(at));
    setAttribute(this.now, "cy", errors!.at(error!));
  }

  private show(): void {
    [...this.points.children].forEach((point, number) => {
      const here = number === this.chosen;
      setAttribute(point, "aria-checked", here ? "true" : "false");
      setAttribute(point, "tabindex", here ? "0" : "-1");
    });
  }

  private choose(number: number): void {
    const trial = this.best[number];
    if (!trial) return;
    this.chosen = number;
    this.show();
    this.picked(trial);
  }

  /** The point nearest to the pointer: they lie closer together than fingers are wide. */
  private click(event: MouseEvent): void {
    this.choose(nearestTo(event, this.points));
    this.focus();
  }

  private key(event: Event): void {
    const { key } = event as KeyboardEvent;
    const last = this.best.length - 1;
    const to = {
      ArrowRight: this.chosen + 1, ArrowDown: this.chosen + 1,
      ArrowLeft: this.chosen - 1, ArrowUp: this.chosen - 1,
      Home: 0, End: last,
    }[key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.choose(Math.min(Math.max(to, 0), last));
    this.focus();
  }

  private focus(): void {
    (this.points.children[this.chosen] as SVGGElement).focus();
  }
}
