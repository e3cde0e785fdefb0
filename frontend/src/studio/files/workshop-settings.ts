// The table [workshop] of the design file as controls; what says nothing new is left out of it.

import { numberBox, numberIn, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import { tableOf } from "../state/changed.ts";
import type { Store } from "../state/store.ts";
import type { Parameter, Value } from "../state/types.ts";
import { isIdle } from "./workshop-words.ts";

/** Settings that stand behind a word. */
const SELDOM = /hinge|^tie_|_price$/;

type Show = (value: Value | null) => void;
interface Control {
  element: HTMLElement;
  show: Show;
}

export class WorkshopSettings {
  readonly element: HTMLElement;
  private readonly rows: { parameter: Parameter; element: HTMLElement; show: Show }[];
  private keys: readonly string[] = [];
  /** What is not asked of everybody. */
  private readonly seldom = h("details", { class: "workshop-seldom", "data-testid": "workshop-seldom" }, h("summary", {}, "Hinges, ties and prices"));
  private readonly units: [HTMLElement, Parameter][] = [];

  constructor(private readonly store: Store) {
    this.rows = store.info.workshop.map((parameter) => this.row(parameter));
    this.element = h("div", { class: "workshop-settings", role: "group", "aria-label": "Workshop" }, ...this.rows.map(({ element }) => element), this.seldom);
    store.design.bind(() => this.show());
  }

  /** Show the settings with these keys, in this order, and no others. */
  only(keys: readonly string[]): void {
    // What is put in anew loses the focus.
    if (keys === this.keys) return;
    this.keys = keys;
    const row = (key: string): HTMLElement => this.rows.find(({ parameter }) => parameter.key === key)!.element;
    this.element.append(...keys.filter((key) => !SELDOM.test(key)).map(row), this.seldom);
    this.seldom.append(...keys.filter((key) => SELDOM.test(key)).map(row));
    this.show();
  }

  private row(parameter: Parameter): { parameter: Parameter; element: HTMLElement; show: Show } {
    const id = `workshop-${parameter.key}`;
    const { element: control, show } = this.control(parameter, id);
    const unit = h("span", { class: "unit" });
    this.units.push([unit, parameter]);
    const element = h(
      "div",
      { class: "parameter-head", title: parameter.help, "data-key": parameter.key },
      h("label", { for: id }, parameter.label),
      control,
      unit,
    );
    return { parameter, element, show };
  }

  private control(parameter: Parameter, id: string): Control {
    switch (parameter.kind) {
      case "choice":
        return this.choice(parameter, id);
      case "switch":
        return this.switch(parameter, id);
      case "size":
        return this.size(parameter, id);
      default:
        return this.number(parameter, id);
    }
  }

  private choice({ key, choices }: Parameter, id: string): Control {
    const words = this.store.info.tables["workshop"]!.keys[key]!.choices;
    const select = h(
      "select",
      { id, "data-testid": id, onchange: () => this.set(key, select.value) },
      ...choices.map((choice) => h("option", { value: choice }, words[choice] ?? choice)),
    );
    const show: Show = (value) => {
      const text = String(value);
      // A palette of one's own, which only the command line opens.
      if (!choices.includes(text)) select.append(h("option", { value: text }, text));
      select.value = text;
    };
    return { element: select, show };
  }

  private switch({ key }: Parameter, id: string): Control {
    const box = h("input", { type: "checkbox", id, "data-testid": id, onchange: () => this.set(key, box.checked) });
    return { element: box, show: (value) => (box.checked = value === true) };
  }

  private number({ key, auto }: Parameter, id: string): Control {
    const box = this.box({ id, "data-testid": id, placeholder: auto ? "auto" : null }, () => {
      if (!box.value || Number.isFinite(numberIn(box))) this.set(key, box.value ? numberIn(box) : undefined);
    });
    return { element: box, show: (value) => setNumber(box, typeof value === "number" ? short(value, 8) : "") };
  }

  private size({ key, label }: Parameter, id: string): Control {
    const set = (): void => {
      const sides = boxes.map(numberIn);
      if (sides.every(Number.isFinite)) this.set(key, sides);
      else if (boxes.every((box) => !box.value)) this.set(key, undefined);
    };
    const boxes = ["width", "height"].map((side, i) =>
      this.box({ id: i ? null : id, "data-testid": `${id}-${side}`, "aria-label": `${label}: ${side}`, placeholder: side }, set),
    );
    const show: Show = (value) => {
      const sides = Array.isArray(value) ? value : [];
      // What is typed into one box waits for the other.
      if (!sides.length && boxes.some((box) => box.contains(document.activeElement) || box.matches(".waiting"))) return;
      boxes.forEach((box, i) => setNumber(box, sides.length ? short(Number(sides[i]), 8) : ""));
    };
    this.store.home.watch(() => {
      boxes.forEach((box) => box.classList.remove("waiting"));
      show(this.value(key));
    });
    return { element: h("span", { class: "workshop-size" }, boxes[0]!, "×", boxes[1]!), show };
  }

  /** A box that is read when it is left or Enter is pressed: half a number may not fit the sheet. */
  private box(attributes: Record<string, string | null>, changed: () => void): HTMLInputElement {
    const box = numberBox({ step: "any", min: 0, ...attributes }, () => undefined);
    box.addEventListener("change", () => {
      box.classList.toggle("waiting", box.value !== "");
      changed();
    });
    return box;
  }

  private value(key: string): Value | null {
    const parameter = this.store.info.workshop.find((each) => each.key === key)!;
    return this.store.design.value.workshop?.[key] ?? parameter.default;
  }

  private set(key: string, value: Value | undefined): void {
    const parameter = this.store.info.workshop.find((each) => each.key === key)!;
    const given = value === parameter.default ? undefined : value;
    const workshop = tableOf({ ...this.store.design.value.workshop, [key]: given });
    this.store.set({ workshop }, parameter.label.toLowerCase());
  }

  private show(): void {
    for (const { parameter, element, show } of this.rows) {
      show(this.value(parameter.key));
      element.hidden = !this.keys.includes(parameter.key) || isIdle(parameter.key, (key) => this.value(key));
    }
    this.seldom.hidden = this.rows.every(({ element }) => element.hidden || !this.seldom.contains(element));
    const { unit } = this.store.design.value.shell;
    for (const [element, parameter] of this.units) {
      element.textContent = parameter.unit === "length" ? unit : parameter.unit;
    }
  }
}
