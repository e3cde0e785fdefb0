// Rows and columns, or the tolerance by which the program chooses them.

import { button, numberBox, segmented, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { aimOf } from "../state/aims.ts";
import { short } from "../parts/numbers.ts";
import type { Live } from "../server/live.ts";
import { roundUp, toleranceOf, withTolerance } from "./front.ts";
import { sized } from "../state/sizing.ts";
import type { Store } from "../state/store.ts";
import { TradeoffCard } from "./tradeoff.ts";
import type { Tolerance } from "../state/types.ts";

/** The tolerance that is offered first and what takes its place are one step of the history. */
const OFFER = "offer!";
type Mode = "sizes" | "tolerance";
const LENGTHS = ["surface", "panel_min", "panel_max"] as const;
const OF_BOARDS = ["least_share", "steepest_chamfer_deg"] as const;

export class Sizes {
  readonly element: HTMLElement;
  private readonly mode = segmented<Mode>(
    "How the number of panels is given",
    [
      { value: "sizes", text: "Rows and columns", testid: "mode-sizes" },
      { value: "tolerance", text: "Tolerance", testid: "mode-tolerance", title: "the program chooses rows and columns" },
    ],
    (mode) => (mode === "tolerance" ? this.toTolerance() : this.toSizes()),
  );
  private readonly boxes = new Map<keyof Tolerance, HTMLInputElement>();
  private readonly labelled = new Map<keyof Tolerance, HTMLElement>();
  private readonly units: HTMLElement[] = [];
  private readonly chosen = h("p", { class: "note" });
  private readonly choose = button({
    label: "Choose rows and columns",
    text: "Choose",
    class: "button primary",
    testid: "choose",
    act: () => (this.store.busy.value ? this.live.cancel() : this.live.choose()),
  });
  private readonly keep = button({
    label: "Keep these rows and columns and go on by hand",
    text: "Keep",
    testid: "keep",
    act: () => this.toSizes(),
  });
  private readonly tradeoff: TradeoffCard;
  private readonly fields: HTMLElement;
  /** The tolerance that the design had last. */
  private remembered: Tolerance | null = null;

  constructor(
    private readonly store: Store,
    private readonly live: Live,
    private readonly rows: HTMLElement,
  ) {
    this.tradeoff = new TradeoffCard(store);
    this.fields = h(
      "div",
      { class: "tolerance" },
      ...LENGTHS.map((key) => this.field(key)),
      ...OF_BOARDS.map((key) => this.field(key)),
      h("div", { class: "actions" }, this.choose, this.keep),
      this.chosen,
    );
    this.element = h("div", { class: "sizes" }, this.mode.element, this.rows, this.fields, this.tradeoff.element);
    store.design.watch((now, before) => {
      // Another surface, or another unit: the distance means something else.
      if (now.shell !== before.shell || now.target !== before.target) this.remembered = null;
    });
    store.design.bind(() => this.refresh());
    store.report.bind(() => this.refresh());
    store.busy.bind(() => this.refresh());
    store.freshness.bind(() => this.refresh());
  }

  private field(key: keyof Tolerance): HTMLElement {
    const { label, help } = this.store.info.tables["tolerance"]!.keys[key]!;
    const box = numberBox({ step: "any", min: 0, "data-testid": `tolerance-${key}` }, (value) =>
      this.set(key, value),
    );
    box.addEventListener("change", () => {
      if (!box.value && key !== "surface") this.set(key, undefined);
    });
    this.boxes.set(key, box);
    const unit = h("span", { class: "unit" }, key === "steepest_chamfer_deg" ? "°" : "");
    if (LENGTHS.some((each) => each === key)) this.units.push(unit);
    const field = h("label", { class: "parameter-head", title: help }, h("span", {}, label), box, unit);
    this.labelled.set(key, field);
    return field;
  }

  private set(key: keyof Tolerance, value: number | undefined): void {
    if (this.store.design.value.tolerance) this.store.set({ [`tolerance.${key}`]: value }, this.store.labels.of(key), `type-${key}`);
  }

  private toTolerance(): void {
    const { store } = this;
    if (this.remembered) {
      store.change(withTolerance(store.design.value, this.remembered), "tolerance");
      return this.tradeoff.find();
    }
    const offered = this.guess();
    store.change(withTolerance(store.design.value, { surface: offered }), "tolerance", OFFER);
    this.tradeoff.find((trial) => {
      const { design } = store;
      // What was typed meanwhile stays.
      if (design.value.tolerance?.surface !== offered) return;
      store.change(withTolerance(design.value, { ...design.value.tolerance, surface: toleranceOf(trial) }), "tolerance", OFFER);
    });
  }

  /** A distance that the present shell keeps, until it is known what others can. */
  private guess(): number {
    const { deviation, deployed } = this.store.report.value ?? {};
    return roundUp(deviation?.surface?.max ?? 0.05 * (deployed?.width ?? 10), 2);
  }

  private toSizes(): void {
    const { design, report, freshness } = this.store;
    const chosen = freshness.value === "current" ? sized(design.value, report.value) : design.value;
    const size = { rows: report.value?.rows ?? 9, columns: report.value?.columns ?? 11 };
    this.store.set({ tolerance: null, pattern: { ...size, ...chosen.pattern } }, "rows and columns");
  }

  private refresh(): void {
    const { design, report, busy, freshness } = this.store;
    const { tolerance } = design.value;
    if (tolerance) this.remembered = tolerance;
    this.mode.set(tolerance ? "tolerance" : "sizes");
    // A tolerance is measured from f and g.
    this.mode.element.hidden = aimOf(design.value) !== "curves";
    this.rows.hidden = !!tolerance;
    this.fields.hidden = !tolerance;
    if (!tolerance) return;
    for (const [key, box] of this.boxes) {
      const value = tolerance[key];
      setNumber(box, value === undefined ? "" : short(value, 8));
    }
    // What is asked of boards stays in sight where panels have none any more, or it could not be removed.
    const { thickness, construction } = design.value.panel ?? {};
    const idle = { least_share: !thickness, steepest_chamfer_deg: !thickness || construction !== "bevel" };
    for (const key of OF_BOARDS) this.labelled.get(key)!.hidden = idle[key] && tolerance[key] === undefined;
    for (const unit of this.units) unit.textContent = design.value.shell.unit;
    const current = freshness.value === "current";
    this.choose.textContent = busy.value ? "Stop" : "Choose";
    this.choose.title = busy.value ? "Stop the search" : "Choose rows and columns";
    this.choose.setAttribute("aria-label", this.choose.title);
    this.keep.hidden = !current;
    const { rows, columns } = report.value ?? {};
    this.chosen.textContent = busy.value
      ? "Trying designs; this takes some seconds."
      : current
        ? `Chosen: ${rows} ${rows === 1 ? "row" : "rows"}, ${columns} columns.`
        : "Press Choose to find the fewest panels within the tolerance.";
  }
}
