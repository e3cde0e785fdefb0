// A page of variants: a slider for each variable; the shell is that of the nearest design that was made.

import type { Variant, VariantsPage } from "../shared/api-types.ts";
import { threeDigits } from "../shared/quantities.ts";
import { inflated } from "../shared/packed.ts";
import { decodeView, type View } from "../shared/view.ts";
import { written } from "../shared/written.ts";
import { element } from "./elements.ts";
import { nearest, numbered } from "./nearest.ts";
import { Viewer } from "./panel.ts";

export class Variants extends Viewer {
  /** Number of the design shown. */
  chosen: number;
  /** Nothing is being unpacked. */
  idle = true;
  private readonly at: number[];
  private readonly sliders: HTMLInputElement[] = [];
  private readonly said = element("p", "variant-said", { role: "status" });
  private readonly told = element("dl", "variant-figures");
  private readonly views: Map<number, View>;

  constructor(root: HTMLElement, private readonly page: VariantsPage, first: View, host: HTMLElement) {
    super(root, first, host);
    root.classList.add("orishell-variants");
    this.chosen = page.first;
    this.views = new Map([[page.first, first]]);
    this.at = [...page.variants[page.first]!.at];
    const box = element("section", "variants", { "aria-label": "Variants" });
    const sliders = element("div", "variant-sliders");
    page.variables.forEach((_, k) => sliders.append(this.sliderOf(k)));
    box.append(sliders, this.said, this.told, element("p", "variant-note", {}, page.said));
    this.head.after(box);
    this.explain();
  }

  private sliderOf(k: number): HTMLElement {
    const { label, values } = this.page.variables[k]!;
    const slider = element("input", "", { type: "range", min: "0", max: String(values.length - 1), step: "1", value: String(this.at[k]!) });
    const name = element("label", "variant"), value = element("output", "variant-value");
    const say = (): void => {
      value.textContent = this.wordsOf(k, this.at[k]!);
      slider.setAttribute("aria-valuetext", value.textContent);
      slider.style.setProperty("--share", String(values.length > 1 ? this.at[k]! / (values.length - 1) : 1));
    };
    slider.disabled = values.length < 2;
    slider.addEventListener("input", () => {
      this.at[k] = Number(slider.value);
      say();
      void this.choose(k);
    });
    this.sliders.push(slider);
    say();
    name.append(element("span", "variant-name", {}, label), slider, value);
    return name;
  }

  private wordsOf(variable: number, number: number): string {
    const { unit, values } = this.page.variables[variable]!;
    const text = written(values[number]);
    return unit === "\u00b0" ? text + unit : unit ? `${text}\u00a0${unit}` : text;
  }

  /** Show the design that is nearest to the sliders, of those that have a shell. */
  private async choose(moved: number): Promise<void> {
    const chosen = nearest(this.page, this.at, moved);
    this.chosen = chosen;
    this.idle = false;
    if (!this.views.has(chosen)) this.views.set(chosen, decodeView(await inflated(this.page.variants[chosen]!.view!)));
    if (this.chosen !== chosen) return;
    const view = this.views.get(chosen)!;
    if (view !== this.view) this.show(view);
    this.explain();
    this.idle = true;
  }

  private explain(): void {
    const { variables, variants, figures } = this.page;
    const shown = variants[this.chosen]!;
    const asked = numbered(this.page, this.at);
    const words = (variant: Variant): string => variables.map(({ label }, k) => `${label} ${this.wordsOf(k, variant.at[k]!)}`).join(", ");
    this.said.textContent = asked === shown ? "" : `${why(asked)} Shown is the nearest: ${words(shown)}.`;
    this.said.hidden = asked === shown;
    const { deployed } = this.view.header.report;
    const told: [string, string][] = shown.figures.map((value, k) => [figures[k]!, written(value)]);
    if (deployed) told.unshift([`size (${this.view.header.unit})`, [deployed.width, deployed.depth, deployed.height].map(threeDigits).join(" \u00d7 ")]);
    this.told.replaceChildren(...told.map(([name, value]) => {
      const pair = element("div", "");
      pair.append(element("dt", "", {}, name), element("dd", "", {}, value));
      return pair;
    }));
  }
}

function why(asked: Variant | undefined): string {
  if (!asked) return "This design was not tried.";
  if (asked.figures.length) return "This design is not drawn here.";
  return `This design does not work: ${asked.missing.replace(/\.$/, "")}.`;
}
