// What may change in a search: its numbers with their ends, its lists, and a choice of further ones.

import { button, numberBox, setNumber } from "../parts/controls.ts";
import { h, keepFocus, uniqueId } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { SearchTable, Variable } from "../state/types.ts";
import { type Candidate, isNumeric, otherwise } from "./numbers.ts";
import { listed } from "./table.ts";

type Variables = SearchTable["variables"];
type Show = (allowed: Variable) => void;

export class VariableList {
  readonly element: HTMLElement;
  private readonly list = h("div", { class: "search-variables" });
  private readonly add = h("select", { "aria-label": "Add a variable", "data-testid": "search-add", onchange: () => this.added() });
  private rows = new Map<string, Show>();
  private built = "";
  private offered = "";
  private variables: Variables = {};
  private from: Candidate[] = [];

  constructor(
    private readonly changed: (variables: Variables, gesture: string) => void,
    private readonly label: (key: string) => string,
  ) {
    this.element = h("div", { class: "search-group" }, h("h3", {}, "Variables"), this.list, this.add);
  }

  show(variables: Variables, from: Candidate[]): void {
    [this.variables, this.from] = [variables, from];
    const kinds = Object.entries(variables).map(([key, each]) => [key, Array.isArray(each) && (isNumeric(each) ? 1 : 2)]);
    const shape = JSON.stringify(kinds);
    if (shape !== this.built) keepFocus(() => this.build(variables));
    this.built = shape;
    for (const [key, show] of this.rows) show(variables[key]!);
    this.offer();
  }

  private build(variables: Variables): void {
    this.rows = new Map();
    this.list.replaceChildren(...Object.entries(variables).map(([key, allowed]) => this.row(key, allowed)));
  }

  private row(key: string, allowed: Variable): HTMLElement {
    const label = this.label(key);
    const [box, show] = Array.isArray(allowed) ? this.choices(key, label) : this.ends(key, label);
    this.rows.set(key, show);
    const other = Array.isArray(allowed) ? "range" : "list";
    const turned = !Array.isArray(allowed) || isNumeric(allowed);
    return h(
      "div",
      { class: "search-variable", role: "group", "aria-label": label, "data-testid": `search-variable-${key}` },
      h(
        "div",
        { class: "search-variable-head" },
        h("span", { class: "search-name" }, label),
        turned &&
          button({
            label: `Give ${label} as a ${other}`,
            text: other === "list" ? "List" : "Range",
            class: "end",
            testid: `search-turn-${key}`,
            act: () => this.set(key, otherwise(this.variables[key]!, this.from.find((each) => each.key === key))),
          }),
        button({ label: `${label} does not change`, icon: "close", testid: `search-remove-${key}`, act: () => this.remove(key) }),
      ),
      box,
    );
  }

  private ends(key: string, label: string): [HTMLElement, Show] {
    const boxes = (["low", "high"] as const).map((end) => {
      const words = end === "low" ? "from" : "to";
      const input = numberBox(
        { step: "any", "aria-label": `${label} ${words}`, "data-testid": `search-${end}-${key}` },
        (value) => this.set(key, { ...(this.variables[key] as { low: number; high: number }), [end]: value }, `type-${end}-${key}`),
      );
      return { end, words, input };
    });
    const step = h("span", { class: "unit" });
    const element = h("div", { class: "search-ends" }, ...boxes.flatMap(({ words, input }) => [h("span", { class: "unit" }, words), input]), step);
    return [
      element,
      (allowed) => {
        const range = allowed as { low: number; high: number; step?: number };
        for (const { end, input } of boxes) {
          setNumber(input, short(range[end]));
          input.classList.toggle("unfinished", !(range.low < range.high));
        }
        step.textContent = range.step ? `by ${short(range.step)}` : "";
      },
    ];
  }

  private choices(key: string, label: string): [HTMLElement, Show] {
    const id = uniqueId("values");
    const input: HTMLInputElement = h("input", {
      class: "formula", type: "text", id, autocomplete: "off", spellcheck: "false",
      "aria-label": `${label}, values between commas`, "data-testid": `search-values-${key}`,
      oninput: () => this.set(key, listed(input.value), `type-values-${key}`),
    });
    return [
      h("div", { class: "search-ends" }, h("label", { class: "unit", for: id }, "one of"), input),
      (allowed) => {
        if (JSON.stringify(listed(input.value)) !== JSON.stringify(allowed)) input.value = (allowed as unknown[]).join(", ");
      },
    ];
  }

  private set(key: string, allowed: Variable, gesture = ""): void {
    this.changed({ ...this.variables, [key]: allowed }, gesture);
  }

  private remove(key: string): void {
    const { [key]: _, ...rest } = this.variables;
    this.changed(rest, "");
    this.add.focus();
  }

  private added(): void {
    const found = this.from.find(({ key }) => key === this.add.value);
    this.add.value = "";
    if (found) this.set(found.key, found.allowed);
  }

  private offer(): void {
    const left = this.from.filter(({ key }) => !(key in this.variables));
    const offered = left.map(({ key, label }) => key + label).join();
    if (offered === this.offered) return;
    this.offered = offered;
    const sections = [...new Set(left.map(({ section }) => section))];
    this.add.replaceChildren(
      h("option", { value: "" }, "Add a variable\u2026"),
      ...sections.map((section) =>
        h("optgroup", { label: section }, ...left.filter((each) => each.section === section).map(({ key, label }) => h("option", { value: key }, label))),
      ),
    );
  }
}
