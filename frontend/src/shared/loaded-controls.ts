// The choice of a load case, of what colours mean, and of how large displacements are drawn.

import { SIGNS } from "./verdict.ts";
import { threeDigits } from "./quantities.ts";
import { deflectionOf, scalesOf, usesStrength, type Deflection, type Measure } from "./loaded.ts";
import type { Shell3D } from "./shell3d.ts";
import type { Loaded, View } from "./view.ts";

const NONE = "";

export class LoadedControls {
  /** Hidden where the shell was not analysed. */
  readonly element = document.createElement("div");
  private readonly cases = document.createElement("select");
  private readonly measures = document.createElement("select");
  private readonly slider = document.createElement("input");
  private readonly reading = document.createElement("output");
  private loaded: Loaded | null = null;
  private deflection: Deflection | null = null;
  private scales: number[] = [1];
  /** The case that was chosen, also while the shell on the screen is not analysed yet. */
  private wanted = NONE;
  /** What colours were asked to mean. */
  private meaning = "";

  /** `hold`: a case belongs to the target, so the fold is to stay there while one is shown. */
  constructor(private readonly shell: Shell3D, private readonly hold: (on: boolean) => void) {
    const { element, cases, measures, slider, reading } = this;
    element.className = "orishell-loads";
    element.setAttribute("role", "group");
    element.setAttribute("aria-label", "Loads");
    cases.setAttribute("aria-label", "Load case");
    cases.dataset["testid"] = "load-case";
    measures.setAttribute("aria-label", "Colours of the loaded shell");
    measures.dataset["testid"] = "load-measure";
    Object.assign(slider, { type: "range", min: "0", step: "1", title: "How many times as large displacements are drawn" });
    slider.setAttribute("aria-label", "Displacements are multiplied by");
    slider.dataset["testid"] = "load-scale";
    cases.addEventListener("change", () => {
      this.wanted = cases.value;
      this.choose();
    });
    measures.addEventListener("change", () => {
      this.meaning = measures.value;
      this.draw();
    });
    slider.addEventListener("input", () => this.draw());
    element.append(cases, measures, slider, reading);
    element.hidden = true;
  }

  /** The shell of another view: the same case, if it has one of that name and was not folded away
   * from it meanwhile. */
  show(view: View): void {
    if (!this.shell.atTarget) this.wanted = NONE;
    const { wanted } = this;
    this.loaded = view.loaded ?? null;
    const cases = this.loaded?.cases ?? [];
    const names = cases.map(({ name }) => name);
    const options = cases.map(({ name, sign }) => {
      const option = new Option(sign === "says" ? name : `${SIGNS[sign]} ${name}`, name);
      option.style.color = `var(--${sign})`;
      return option;
    });
    this.cases.replaceChildren(new Option("Without loads", NONE), ...options);
    this.cases.value = names.includes(wanted) ? wanted : NONE;
    this.element.hidden = !this.loaded;
    const kinds: Measure[] = this.loaded && usesStrength(this.loaded) ? ["utilisation", "displacement", "stress"] : ["displacement", "stress"];
    this.measures.replaceChildren(...kinds.map((kind) => new Option(kind, kind)));
    this.choose();
  }

  /** Show a case, as soon as there is one of that name; null: without loads. */
  want(name: string | null): void {
    this.wanted = name ?? NONE;
    if (name !== null && !this.shell.atTarget) this.hold(true);  // to the target
    this.cases.value = [...this.cases.options].some(({ value }) => value === this.wanted) ? this.wanted : NONE;
    this.choose();
  }

  private choose(): void {
    const { loaded, cases } = this;
    const number = loaded && cases.value !== NONE ? cases.selectedIndex - 1 : -1;
    this.deflection = number < 0 ? null : deflectionOf(loaded!, number);
    if (this.deflection) {
      this.scales = scalesOf(this.deflection.scale);
      this.slider.max = String(this.scales.length - 1);
      this.slider.value = String(this.scales.indexOf(this.deflection.scale));
      const kinds = [...this.measures.options].map(({ value }) => value);
      const meaning = kinds.includes(this.meaning) ? this.meaning : kinds[0]!;
      this.measures.value = this.deflection.balanced ? meaning : "displacement";
    }
    this.hold(this.deflection !== null);
    this.draw();
  }

  private draw(): void {
    const { deflection, measures, slider, reading } = this;
    for (const each of [measures, slider]) each.hidden = !deflection;
    // What moves freely has no stresses, and goes as far as one likes.
    measures.disabled = reading.hidden = !deflection?.balanced;
    const scale = this.scales[slider.valueAsNumber] ?? 1;
    reading.textContent = `\u00d7 ${threeDigits(scale)}`;
    slider.setAttribute("aria-valuetext", `${threeDigits(scale)} times`);
    this.shell.setLoaded(deflection && { deflection, measure: measures.value as Measure, scale });
  }
}
