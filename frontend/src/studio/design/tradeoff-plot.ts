// The plot of panels against distance: all sizes faint, the best as points that are chosen.

import type { Tradeoff, Trial } from "../../shared/api-types.ts";
import { Chooser } from "../../shared/chooser.ts";
import { axisAcross, axisUp } from "../../shared/plot.ts";
import { h, s, setAttribute, uniqueId } from "../parts/dom.ts";
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
  private readonly chooser: Chooser;
  private best: readonly Trial[] = [];
  private panels: LogScale | null = null;
  private errors: LogScale | null = null;
  private present: { rows: number; columns: number; error: number | undefined } | null = null;

  constructor(private readonly picked: (trial: Trial) => void) {
    const id = uniqueId("tradeoff");
    const drawing = s("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, "data-testid": "tradeoff-plot" });
    const choose = (number: number): void => this.choose(number);
    this.chooser = new Chooser(drawing, "Sizes that no other beats", { walked: choose, picked: choose });
    drawing.append(this.frame, this.allowed, this.cloud, this.line, this.now, this.chooser.element);
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
    this.chooser.draw(
      best.map((trial, number) => ({
        at: place(trial),
        label: `${trial.rows} rows, ${trial.columns} columns: ${trial.panels} panels, ${short(trial.error, 3)} ${unit}`,
        testid: `front-${number}`,
      })),
    );
    this.limit(tolerance);
    this.markPresent();
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
    this.chooser.mark(Math.max(0, this.best.indexOf(trial)));
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

  private choose(number: number): void {
    this.chooser.mark(number);
    this.picked(this.best[number]!);
  }
}
