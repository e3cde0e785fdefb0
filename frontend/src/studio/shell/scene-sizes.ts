// Sizes at the shell itself: lines that measure it, with boxes that are typed into. What a size does is what the
// table of sizes does.

import { fitOf, fitTable, measuredSizes, type Side, sideOf, type Size } from "../design/fit-table.ts";
import { button, numberBox, numberIn, setNumber } from "../parts/controls.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import { aimOf } from "../state/aims.ts";
import type { Signal } from "../state/signal.ts";
import type { Store } from "../state/store.ts";
import { DimensionLines, type Measure, MEASURES } from "./dimension-lines.ts";
import type { Pinned } from "./pinned.ts";
import type { Stage } from "./stage.ts";

/** Of what each is, and as which size. */
const OF: Record<Measure, [Side, Size]> = {
  width: ["outside", "width"], depth: ["outside", "depth"], height: ["outside", "height"], headroom: ["inside", "height"],
};
const HELP: Record<Measure, string> = {
  width: "along x, of all that is built", depth: "along y, of all that is built", height: "of all that is built",
  headroom: "clear above the middle of the plan, along or across",
};

/** Half of what a box takes (pixels). */
const ROOM = [70, 16] as const;

interface Box {
  element: HTMLElement;
  input: HTMLInputElement;
  unit: HTMLElement;
}

export class SceneSizes {
  private readonly boxes: Record<Measure, Box>;
  private readonly lines: DimensionLines;
  private readonly redraw: () => void;

  constructor(
    private readonly store: Store,
    stage: Stage,
    pinned: Pinned,
    /** Whether sizes and handles are shown at the shell. */
    private readonly on: Signal<boolean>,
  ) {
    const { shell } = stage;
    this.lines = new DimensionLines(shell.uniforms, () => shell.eye.arm);
    this.redraw = shell.add(this.lines);
    this.boxes = Object.fromEntries(MEASURES.map((each) => [each, this.box(each)])) as Record<Measure, Box>;
    for (const each of MEASURES) pinned.add(this.boxes[each].element, () => (shell.load || !this.known(each) ? null : this.lines.middles.get(each) ?? null), ROOM);
    shell.onFrame.add(() => this.lines.turned && this.redraw());
    const shown = button({ label: "Sizes and handles at the shell", icon: "sizes", testid: "sizes", act: () => on.set(!on.value) });
    stage.tools.append(shown);
    on.bind((seen) => {
      setAttribute(shown, "aria-pressed", String(seen));
      this.show();
      shell.refit();
    });
    for (const signal of [store.design, store.report, store.proof, store.freshness, store.fault]) {
      (signal as { watch(listener: () => void): void }).watch(() => this.show());
    }
  }

  private box(measure: Measure): Box {
    const [side, size] = OF[measure];
    const name = measure[0]!.toUpperCase() + measure.slice(1);
    const input = numberBox(
      { min: 0, step: "any", "aria-label": `${name} of the shell`, title: `${name}, ${HELP[measure]}; empty: as the target has it`, "data-testid": `size-${measure}` },
      () => undefined,
    );
    // Read when it is left or Enter is pressed: every size is a search.
    input.addEventListener("change", () => {
      if (!input.value || Number.isFinite(numberIn(input))) this.ask(side, size, measure, input.value ? numberIn(input) : undefined);
    });
    input.addEventListener("focus", () => input.select());
    input.addEventListener("blur", () => this.show());
    input.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      input.value = short(this.value(measure) ?? NaN, 4);
      input.blur();
    });
    const unit = h("span", { class: "unit" });
    return { element: h("div", { class: "scene-size", "data-measure": measure }, h("span", { "aria-hidden": "true" }, name), input, unit), input, unit };
  }

  /** Sizes are of the box outside or of the room inside: those of the other kind are no longer asked for. */
  private ask(side: Side, size: Size, measure: Measure, value: number | undefined): void {
    const { store } = this;
    const table = fitOf(store.design.value), now = sideOf(table);
    if (value === undefined && now !== side) return this.show();
    const other = now !== null && now !== side;
    store.set({ "target.fit": fitTable({ ...(other ? {} : table), [size]: value }, side) }, measure, `type-size-${measure}`);
    if (other) store.said.set(side === "inside" ? "The headroom is asked for in place of sizes outside" : "Sizes outside are asked for in place of the headroom");
  }

  /** What is asked for, or else measured. */
  private value(measure: Measure): number | undefined {
    const [side, size] = OF[measure];
    const table = fitOf(this.store.design.value);
    const asked = sideOf(table) === side ? table[size] : undefined;
    return asked === undefined ? measuredSizes(this.store, side)[size] : Number(asked);
  }

  private known(measure: Measure): boolean {
    return Boolean(this.value(measure)) && aimOf(this.store.design.value) !== "none";
  }

  private show(): void {
    const { design, fault } = this.store;
    const table = fitOf(design.value);
    for (const measure of MEASURES) {
      const { element, input, unit } = this.boxes[measure];
      const [side, size] = OF[measure];
      unit.textContent = design.value.shell.unit;
      element.dataset["asked"] = String(sideOf(table) === side && table[size] !== undefined);
      element.classList.toggle("faulty", sideOf(table) === side && (fault.value?.keys ?? []).includes(`target.fit.${size}`));
      if (document.activeElement !== input) setNumber(input, short(this.value(measure) ?? NaN, 4));
    }
    this.lines.setVisible(this.on.value && (["width", "depth", "height"] as const).some((each) => this.known(each)));
    this.lines.setRoom(this.known("headroom") ? this.value("headroom")! : 0);
    this.redraw();
  }
}
