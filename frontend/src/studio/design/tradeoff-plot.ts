// The plot of panels against distance: all sizes faint, the best as points that are chosen.

import type { Tradeoff, Trial } from "../../shared/api-types.ts";
import type { Point } from "../../shared/chooser.ts";
import { Scatter } from "../../shared/scatter.ts";
import { s } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import { frameOf, plotFigure } from "../parts/plot-figure.ts";
import { LogScale } from "./front.ts";

const FRAME = frameOf(352, 232);

export class TradeoffPlot {
  readonly element: HTMLElement;
  private readonly scatter = new Scatter("Sizes that no other beats", {
    walked: (number) => this.choose(number),
    picked: (number) => this.choose(number),
    pointed: (number) => this.pointed(this.best[number] ?? null),
  });
  private best: readonly Trial[] = [];
  private scales: [LogScale, LogScale] | null = null;
  private tolerance: number | undefined;
  private present: { rows: number; columns: number; error: number | undefined } | null = null;

  /** `pointed`: a trial is pointed at, or none any more. */
  constructor(private readonly picked: (trial: Trial) => void, private readonly pointed: (trial: Trial | null) => void) {
    this.element = plotFigure(this.scatter, FRAME, "tradeoff-plot", "Largest distance from the surface against the number of panels. Choose a point.");
  }

  draw({ tried, best }: Tradeoff, unit: string, tolerance: number | undefined): void {
    this.best = best;
    const across = LogScale.of(tried.map(({ panels }) => panels), FRAME.left, FRAME.right);
    const up = LogScale.of([...tried, ...best].map(({ error }) => error), FRAME.bottom, FRAME.top);
    this.scales = [across, up];
    const at = ({ panels, error }: Trial): Point => [panels, error];
    this.scatter.draw({
      frame: FRAME,
      across: { scale: across, name: "panels" },
      up: { scale: up, name: `distance (${unit})` },
      written: short,
      dots: tried.map(at),
      best: best.map((trial, number) => ({
        at: at(trial),
        label: `${trial.rows} rows, ${trial.columns} columns: ${trial.panels} panels, ${short(trial.error, 3)} ${unit}`,
        testid: `front-${number}`,
      })),
      joined: true,
    });
    this.limit(tolerance);
  }

  /** The tolerance as a line. */
  limit(tolerance: number | undefined): void {
    this.tolerance = tolerance;
    this.show();
  }

  /** The shell on the screen as a ring. */
  mark(rows: number, columns: number, error: number | undefined): void {
    this.present = { rows, columns, error };
    this.show();
  }

  select(trial: Trial): void {
    this.scatter.chooser.mark(Math.max(0, this.best.indexOf(trial)));
  }

  private show(): void {
    const { scales, tolerance, present } = this;
    if (!scales) return;
    const [across, up] = scales, marks: SVGElement[] = [];
    if (tolerance !== undefined && up.has(tolerance)) {
      const y = up.at(tolerance);
      marks.push(s("line", { class: "limit", x1: FRAME.left, x2: FRAME.right, y1: y, y2: y }));
    }
    const { rows, columns, error } = present ?? { rows: 0, columns: 0, error: undefined };
    const panels = (rows + 1) * (columns - 1);
    if (error !== undefined && up.has(error) && across.has(panels)) {
      marks.push(s("circle", { class: "begun", r: 8, cx: across.at(panels), cy: up.at(error) }, s("title", {}, "the shell on the screen")));
    }
    this.scatter.marks.replaceChildren(...marks);
  }

  private choose(number: number): void {
    this.scatter.chooser.mark(number);
    this.picked(this.best[number]!);
  }
}
