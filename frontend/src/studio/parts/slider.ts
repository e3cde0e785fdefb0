// A slider whose track shows which values are admissible.

import { h, setAttribute } from "./dom.ts";
import { clamp, niceAbove } from "./numbers.ts";
import type { Parameter, Range } from "../state/types.ts";

export class Slider {
  readonly input: HTMLInputElement;
  private low: number;
  private high: number;
  private held = false;

  constructor(
    private readonly parameter: Parameter,
    changed: (value: number) => void,
    released: () => void,
  ) {
    [this.low, this.high] = parameter.slider ?? [0, 1];
    this.input = h("input", {
      type: "range",
      class: "slider",
      "aria-label": `${parameter.label}, slider`,
      "data-testid": `slider-${parameter.key}`,
    });
    this.input.addEventListener("input", () => changed(this.input.valueAsNumber));
    this.input.addEventListener("change", released);
    this.input.addEventListener("pointerdown", () => (this.held = true));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
      this.input.addEventListener(end, () => (this.held = false));
    }
  }

  /** Show a value and the admissible intervals; the ends move if they must, but not in a drag. */
  show(value: number | null, range: Range | undefined): void {
    if (!this.held) this.span(value, range);
    const { input } = this;
    const step = this.parameter.step ?? niceAbove((this.high - this.low) / 500);
    setAttribute(input, "min", this.low);
    setAttribute(input, "max", this.high);
    setAttribute(input, "step", this.parameter.kind === "integer" ? step : "any");
    if (value !== null && input.valueAsNumber !== value) input.value = String(value);
    input.classList.toggle("unknown", value === null);
    input.style.setProperty("--track", this.track(range));
  }

  private span(value: number | null, range: Range | undefined): void {
    const given = this.parameter.slider ?? [0, 1];
    let [low, high] = given;
    if (this.parameter.unit === "length") {
      // A length's scale is the design's own.
      const limit = Math.min(range?.intervals.at(-1)?.[1] ?? 0, range?.span[1] ?? 0);
      const wanted = Math.max(2 * (value ?? 0), 1.25 * limit, 0.05 * (range?.span[1] ?? 0));
      if (wanted > 0) [low, high] = [0, niceAbove(wanted)];
    }
    if (value !== null) [low, high] = [Math.min(low, value), Math.max(high, value)];
    [this.low, this.high] = [low, high];
  }

  private track(range: Range | undefined): string {
    if (!range) return "none";
    // The thumb's centre runs from 8 pixels to 8 pixels before the end.
    const place = (value: number): string => {
      const share = clamp((value - this.low) / (this.high - this.low), 0, 1);
      if (share === 0) return "0px";
      if (share === 1) return "100%";
      return `calc(8px + (100% - 16px) * ${share.toFixed(4)})`;
    };
    const stops = ["var(--refused) 0px"];
    for (const [low, high] of range.intervals) {
      stops.push(`var(--refused) ${place(low)}`, `var(--admissible) ${place(low)}`);
      stops.push(`var(--admissible) ${place(high)}`, `var(--refused) ${place(high)}`);
    }
    stops.push("var(--refused) 100%");
    return `linear-gradient(to right, ${stops.join(", ")})`;
  }
}
