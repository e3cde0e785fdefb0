// Sheets of many sizes, and which of them to take: arithmetic of the trade-off, without the page.

import type { Tradeoff, Trial } from "../../shared/api-types.ts";
import { Scale } from "../../shared/plot.ts";
import { changed } from "../state/changed.ts";
import type { Design, Tolerance } from "../state/types.ts";

/** Round up, so that what comes that near still does. */
export function roundUp(value: number, digits: number): number {
  const near = value.toExponential(digits - 1);
  if (!(Number(near) < value)) return Number(near);
  const [lead, power] = near.split("e");
  const next = Number(lead!.replace(".", "")) + 1;
  return Number(`${next}e${Number(power) - digits + 1}`);
}

/** The tolerance that a sheet meets. */
export function toleranceOf(trial: Trial): number {
  return roundUp(trial.error, 3);
}

/** Number of the trial whose panels are nearest to a number of panels. */
export function nearestTo(panels: number, best: readonly Trial[]): number {
  const away = best.map((trial) => Math.abs(Math.log(trial.panels / Math.max(panels, 1))));
  return away.indexOf(Math.min(...away));
}

/** What a search for sizes depends on: a design that only differs in others keeps what was found. */
export function keyOf(design: Design): string {
  const { rows: _rows, columns: _columns, ...pattern } = design.pattern;
  const { surface: _surface, ...edges } = design.tolerance ?? {};
  return JSON.stringify([design.shell, design.target, pattern, edges]);
}

/** The design with the sizes of a trial in place of a tolerance. */
export function withSizes(design: Design, trial: Trial, settled: Tradeoff["settled"]): Design {
  const { rows, columns } = trial;
  return changed(design, { tolerance: null, pattern: { ...settled, ...design.pattern, rows, columns } });
}

/** The design with a tolerance in place of rows and columns. */
export function withTolerance(design: Design, tolerance: Tolerance): Design {
  return changed(design, { "pattern.rows": null, "pattern.columns": null, tolerance });
}

/** A logarithmic scale from values to places. */
export class LogScale extends Scale {
  /** The scale that shows all values with some room. */
  static override of(values: readonly number[], from: number, to: number): LogScale {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const room = Math.max(high / low, 2) ** 0.06;
    return new LogScale(low / room, high * room, from, to);
  }

  override at(value: number): number {
    const share = Math.log(value / this.low) / Math.log(this.high / this.low);
    return this.from + share * (this.to - this.from);
  }

  /** 1, 2 and 5 times powers of ten; only the powers where that would be too many. */
  override ticks(most = 7): number[] {
    const found = (leads: number[]): number[] => {
      const ticks: number[] = [];
      for (let power = Math.floor(Math.log10(this.low)); power <= Math.log10(this.high); power++) {
        for (const lead of leads) {
          const tick = Number(`${lead}e${power}`);
          if (tick >= this.low && tick <= this.high) ticks.push(tick);
        }
      }
      return ticks;
    };
    const all = found([1, 2, 5]);
    return all.length <= most ? all : found([1]);
  }
}
