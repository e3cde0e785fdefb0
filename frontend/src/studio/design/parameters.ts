// All parameters of the family, and what else the design file says about the pattern.

import { sentence } from "../../shared/words.ts";
import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { patternKeysOf } from "../state/faults.ts";
import { aimOf } from "../state/aims.ts";
import type { Live } from "../server/live.ts";
import { wordsOfSize } from "./panel-count.ts";
import { ParameterRow } from "./parameter-row.ts";
import { Sizes } from "./sizes.ts";
import type { Store } from "../state/store.ts";
import type { Parameter, Range, Value } from "../state/types.ts";

const SIZES = ["rows", "columns"];

export class Parameters {
  readonly element: HTMLElement;
  private readonly sizeRows = h("div", { class: "parameter-list" });
  private readonly count = h("p", { class: "note", "data-testid": "panel-count" });
  private readonly list = h("div", { class: "parameter-list" });
  private readonly advanced = h("div", { class: "parameter-list" });
  private readonly more = h("details", { class: "more" }, h("summary", { "data-testid": "more" }, "More"), this.advanced);
  private readonly others = h("div", { class: "others" });
  private rows = new Map<string, ParameterRow>();
  private family = "";

  constructor(
    private readonly store: Store,
    live: Live,
  ) {
    const sizes = new Sizes(store, live, this.sizeRows);
    this.element = h(
      "section",
      { class: "parameters", "aria-labelledby": "parameters-title" },
      h("h2", { id: "parameters-title" }, "Pattern"),
      sizes.element,
      this.count,
      this.list,
      this.more,
      this.others,
    );
    for (const signal of [store.design, store.report, store.ranges, store.fault]) {
      (signal as { watch(listener: () => void): void }).watch(() => this.refresh());
    }
    this.refresh();
  }

  focus(key: string): void {
    const row = this.rows.get(key);
    if (row && this.advanced.contains(row.element)) this.more.open = true;
    row?.focus();
  }

  private refresh(): void {
    const { design, report, ranges, fault } = this.store;
    const { shell, pattern } = design.value;
    const parameters = this.store.info.families[shell.family]?.parameters ?? [];
    if (this.family !== shell.family) this.build(shell.family, parameters);
    const named = patternKeysOf(fault.value);
    const aim = aimOf(design.value);
    for (const { key, only } of parameters) {
      this.rows.get(key)!.element.hidden = only !== null && only !== aim;
      const taken = report.value?.parameters[key] ?? report.value?.[key as "rows" | "columns"];
      this.rows.get(key)!.show({
        value: pattern[key],
        taken: report.value?.family === shell.family ? taken : undefined,
        range: this.said(ranges.value[key]),
        unit: shell.unit,
        fault: named.includes(key) ? sentence(this.store.labels.said(fault.value!.what)) : "",
      });
    }
    const advanced = parameters.filter((each) => each.advanced);
    if (advanced.some(({ key }) => named.includes(key))) this.more.open = true;
    this.more.hidden = advanced.every(({ key }) => this.rows.get(key)!.element.hidden);
    this.showOthers(pattern, parameters, named);
    this.countPanels();
  }

  private countPanels(): void {
    const { design, report, view, info } = this.store;
    const { rows, columns } = { ...report.value, ...design.value.pattern };
    // The sheet says whether its flaps are part of it.
    const flapped = view.value?.header.grid?.[1] !== report.value?.columns;
    const flaps = info.families[design.value.shell.family]?.borders ?? "";
    this.count.textContent = view.value ? wordsOfSize(Number(rows), Number(columns), flapped ? flaps : "") : "";
    this.count.hidden = !this.count.textContent;
  }

  private said(range: Range | undefined): Range | undefined {
    const { labels } = this.store;
    return range && { ...range, below: labels.said(range.below), above: labels.said(range.above) };
  }

  private build(family: string, parameters: Parameter[]): void {
    this.family = family;
    this.rows = new Map();
    const elements: Record<"sizes" | "rest" | "advanced", HTMLElement[]> = { sizes: [], rest: [], advanced: [] };
    for (const parameter of parameters) {
      const { key } = parameter;
      const row = new ParameterRow(parameter, {
        changed: (value, gesture) => this.store.setPattern(key, value, gesture),
        released: () => this.store.rest(),
      });
      this.rows.set(key, row);
      elements[SIZES.includes(key) ? "sizes" : parameter.advanced ? "advanced" : "rest"].push(row.element);
    }
    this.sizeRows.replaceChildren(...elements.sizes);
    this.list.replaceChildren(...elements.rest);
    this.advanced.replaceChildren(...elements.advanced);
  }

  /** Keys of the file that have no control here: shown, kept, and removable. */
  private showOthers(
    pattern: Record<string, Value>,
    parameters: Parameter[],
    faulty: string[],
  ): void {
    const known = new Set(parameters.map(({ key }) => key));
    const keys = Object.keys(pattern).filter((key) => !known.has(key) && !SIZES.includes(key));
    this.others.hidden = !keys.length;
    this.others.replaceChildren(
      h("h3", {}, "Also in the file"),
      ...keys.map((key) =>
        h(
          "div",
          { class: faulty.includes(key) ? "other faulty" : "other" },
          h("code", { title: JSON.stringify(pattern[key]) }, `${key} = ${JSON.stringify(pattern[key])}`),
          button({
            label: `Remove ${key} from the design`,
            icon: "close",
            act: () => this.store.setPattern(key, undefined),
          }),
        ),
      ),
    );
  }
}
