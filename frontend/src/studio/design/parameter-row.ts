// One parameter: its name, number box, slider, "auto", and in words which values work.

import { sentence } from "../../shared/words.ts";
import { numberBox, numberIn, setNumber } from "../parts/controls.ts";
import { h, uniqueId } from "../parts/dom.ts";
import { icon } from "../parts/icons.ts";
import { clamp, pretty, short } from "../parts/numbers.ts";
import { Slider } from "../parts/slider.ts";
import type { Parameter, Range, Value } from "../state/types.ts";

export interface RowEvents {
  changed(value: Value, gesture: string): void;
  released(): void;
}

export interface RowState {
  /** What the design says; undefined if it leaves the key out. */
  value: Value | undefined;
  /** What the program took, as far as the report says. */
  taken: unknown;
  range: Range | undefined;
  unit: string;
  /** What is wrong with the value, in words. */
  fault: string;
}

export class ParameterRow {
  readonly element: HTMLElement;
  private readonly note = h("p", { class: "note", id: uniqueId("note") });
  private readonly unit = h("span", { class: "unit" });
  private readonly controls: ((state: RowState) => void)[] = [];

  constructor(
    private readonly parameter: Parameter,
    private readonly events: RowEvents,
  ) {
    const { key, label, help } = parameter;
    const id = uniqueId("parameter");
    const head = h(
      "div",
      { class: "parameter-head" },
      h("label", { for: id, title: help }, label),
    );
    this.element = h("div", { class: "parameter", "data-key": key }, head);
    switch (parameter.kind) {
      case "choice":
        head.append(this.choice(id));
        break;
      case "angles4":
        this.auto(head);
        this.element.append(this.angles(id));
        break;
      default:
        this.auto(head);
        this.number(id, head);
    }
    this.element.append(this.note);
  }

  show(state: RowState): void {
    for (const update of this.controls) update(state);
    this.unit.textContent = this.parameter.unit === "deg" ? "°" : this.parameter.unit ? state.unit : "";
    this.element.classList.toggle("faulty", !!state.fault);
    const words = state.fault ? [icon("warning"), state.fault] : this.words(state);
    this.note.replaceChildren(...words);
    this.note.title = state.fault ? "" : [state.range?.below, state.range?.above].filter(Boolean).join("\n");
    this.note.classList.toggle("error", !!state.fault);
    this.note.hidden = !words.length;
  }

  focus(): void {
    this.element.querySelector<HTMLElement>("input:not([disabled]), select")?.focus();
  }

  /** Which values work, and why not others. */
  private words({ range, value, taken }: RowState): string[] {
    if (!range || !isNumeric(this.parameter)) return [];
    const { intervals, beyond, below, above } = range;
    if (!intervals.length) return [sentence(`No value works${below ? `: ${below}` : ""}`)];
    const low = intervals[0]![0];
    const high = intervals.at(-1)![1];
    const sign = this.parameter.unit === "deg" ? "°" : "";
    const parts = intervals.map(([a, b], k) => {
      if (a === b) return `at ${pretty(a, 4)}${sign} only`;
      // No end was found.
      const [from, to] = [k === 0 && beyond[0] ? "at most " : "", k === intervals.length - 1 && beyond[1] ? "at least " : ""];
      return `from ${from}${pretty(a, 4)} to ${to}${pretty(b, 4)}${sign}`;
    });
    const at = Number(value === "auto" ? taken : (value ?? taken));
    // The reason on the side where the value is; both where it is in the middle of nowhere.
    const middle = (low + high) / 2;
    const reasons: string[] = [];
    if (below && (at < middle || !above)) reasons.push(`Below: ${sentence(below)}`);
    if (above && (!(at < middle) || !below)) reasons.push(`Above: ${sentence(above)}`);
    return [`Works ${parts.join(" and ")}. ${reasons.join(" ")}`];
  }

  private auto(head: HTMLElement): void {
    if (!this.parameter.auto) return;
    const { key, label } = this.parameter;
    const input = h("input", { type: "checkbox", "data-testid": `auto-${key}`, "aria-label": `${label}: automatic` });
    let latest: RowState | null = null;
    input.addEventListener("change", () => {
      this.events.changed(input.checked ? "auto" : (this.manual(latest) ?? 0), "");
    });
    this.controls.push((state) => {
      latest = state;
      input.checked = (state.value ?? this.parameter.default) === "auto";
    });
    head.append(h("label", { class: "auto", title: "let the program choose" }, input, h("span", {}, "auto")));
  }

  /** The value to go on with when "auto" is switched off. */
  private manual(state: RowState | null): Value | undefined {
    const taken = state?.taken;
    if (typeof taken === "number") return Number(short(taken, 6));
    if (Array.isArray(taken)) return taken.map((each) => Number(short(Number(each), 7)));
    const { default: usual } = this.parameter;
    if (usual !== null && usual !== "auto") return usual;
    if (this.parameter.kind === "angles4") return [85, 80, 95, 100];
    const [low, high] = this.parameter.slider ?? [0, 1];
    return (low + high) / 2;
  }

  private number(id: string, head: HTMLElement): void {
    const { key, kind, slider, step } = this.parameter;
    const integer = kind === "integer";
    const attributes = {
      id,
      step: integer ? (step ?? 1) : "any",
      "data-testid": `param-${key}`,
      "aria-describedby": this.note.id,
    };
    const box = numberBox(attributes, (value) => {
      if (!integer || Number.isInteger(value)) this.events.changed(value, `type-${key}`);
    });
    box.addEventListener("change", () => this.events.released());
    let value: number | null = null;
    const nudge = (direction: number): void => {
      const [low, high] = slider ?? [-Infinity, Infinity];
      this.events.changed(clamp((value ?? 0) + direction * (step ?? 1), low, high), `step-${key}`);
    };
    const stepper = (direction: -1 | 1): HTMLElement =>
      h(
        "button",
        { type: "button", class: "stepper", tabindex: -1, "aria-label": `${direction < 0 ? "fewer" : "more"}: ${this.parameter.label}`, "data-testid": `${direction < 0 ? "less" : "more"}-${key}`, onclick: () => nudge(direction) },
        icon(direction < 0 ? "minus" : "plus"),
      );
    head.append(integer ? h("span", { class: "stepped" }, stepper(-1), box, stepper(1)) : box);
    if (!integer) head.append(this.unit);
    const bar =
      slider || this.parameter.unit === "length"
        ? new Slider(
            this.parameter,
            (to) => this.events.changed(Number(short(to, 4)), `slide-${key}!`),
            () => this.events.released(),
          )
        : null;
    if (bar) this.element.append(bar.input);
    this.controls.push((state) => {
      const auto = (state.value ?? this.parameter.default) === "auto";
      value = numeric(auto ? state.taken : (state.value ?? this.parameter.default));
      box.classList.toggle("automatic", auto);
      box.placeholder = auto ? "auto" : "";
      setNumber(box, value === null ? "" : short(value, auto ? 5 : 10));
      bar?.show(value, state.range);
      this.element.classList.toggle("is-auto", auto);
    });
  }

  private angles(id: string): HTMLElement {
    const { key, label } = this.parameter;
    const names = ["α", "β", "γ", "δ"];
    const boxes = names.map((name, i) =>
      numberBox(
        { id: i ? null : id, step: "any", "aria-label": `${label} ${name}`, "data-testid": `param-${key}-${i}` },
        () => {
          const values = boxes.map(numberIn);
          if (values.every(Number.isFinite)) this.events.changed(values, `type-${key}-${i}`);
        },
      ),
    );
    this.controls.push((state) => {
      const auto = (state.value ?? this.parameter.default) === "auto";
      const values = (auto ? state.taken : state.value) as number[] | undefined;
      boxes.forEach((box, i) => {
        box.classList.toggle("automatic", auto);
        const value = Array.isArray(values) ? Number(values[i]) : NaN;
        setNumber(box, Number.isFinite(value) ? short(value, 7) : "");
      });
    });
    return h(
      "div",
      { class: "angles", role: "group", "aria-label": label },
      ...names.map((name, i) => h("label", {}, name, boxes[i]!)),
    );
  }

  private choice(id: string): HTMLElement {
    const { key, choices } = this.parameter;
    const select = h(
      "select",
      { id, "data-testid": `param-${key}`, onchange: () => this.events.changed(select.value, "") },
      ...choices.map((choice) => h("option", { value: choice }, choice)),
    );
    this.controls.push(({ value }) => {
      const now = value ?? this.parameter.default;
      const text = typeof now === "string" ? now : JSON.stringify(now);
      if (![...select.options].some((option) => option.value === text)) {
        // What the file says, in a form that this list does not offer.
        select.append(h("option", { value: text, disabled: true }, text));
      }
      select.value = text;
    });
    return select;
  }
}

function isNumeric(parameter: Parameter): boolean {
  return parameter.kind === "number" || parameter.kind === "integer";
}

function numeric(value: unknown): number | null {
  return typeof value === "number" && Number.isFinite(value) ? value : null;
}
