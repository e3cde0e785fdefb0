// How the shell is deployed: the table [deployment] of the design file.

import type { KeyWords } from "../../shared/api-types.ts";
import { numberBox, type Segmented, segmented, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import { tableOf } from "../state/changed.ts";
import type { Store } from "../state/store.ts";
import type { Value } from "../state/types.ts";
import { put, TypedLines } from "../parts/typed.ts";
import { listed, rowsIn, tiesAt } from "./row-list.ts";

const CHOICES = ["from", "flap_attachment", "ties"];
const WIDEST = 180;

export class DeploymentControls {
  readonly element: HTMLElement;
  private readonly choices = new Map<string, Segmented<string>>();
  private readonly hinges: HTMLInputElement;
  private readonly tied: HTMLInputElement;
  private readonly tiedRows: HTMLElement;
  private readonly note = h("p", { class: "note" });

  constructor(private readonly store: Store) {
    const { label, keys } = store.info.tables["deployment"]!;
    const hinges = keys["largest_fold_deg"]!;
    this.hinges = numberBox(
      { min: 0, max: WIDEST, step: "any", id: "hinges", "data-testid": "deployment-largest_fold_deg" },
      (value) => this.set("largest_fold_deg", value === WIDEST ? undefined : value, "type-largest_fold_deg"),
    );
    const { label: rows, help } = store.info.tables["deployment.ties"]!.keys["folds"]!;
    this.tied = new TypedLines((gesture) => this.tie(gesture)).line("number", "deployment-ties-rows", rows, "type-ties");
    this.tied.placeholder = "all";
    this.tiedRows = h("div", { class: "parameter-head", title: help }, h("span", {}, rows), this.tied);
    this.element = h(
      "section",
      { class: "deployment", "aria-labelledby": "deployment-title" },
      h("h2", { id: "deployment-title" }, label),
      ...CHOICES.map((key) => this.choice(key, keys[key]!)),
      this.tiedRows,
      h(
        "div",
        { class: "parameter-head", title: hinges.help },
        h("label", { for: "hinges" }, hinges.label),
        this.hinges,
        h("span", { class: "unit" }, "\u00b0"),
      ),
      this.note,
    );
    store.design.bind(({ deployment }) => this.show(deployment ?? {}));
  }

  private choice(key: string, { label, help, choices }: KeyWords): HTMLElement {
    const values = Object.entries(choices);
    const choice = segmented<string>(
      label,
      values.map(([value, text]) => ({ value, text, testid: `deployment-${key}-${value}` })),
      // The first is what a file means that says nothing.
      (value) => this.set(key, value === values[0]![0] ? undefined : value),
    );
    this.choices.set(key, choice);
    return h("div", { class: "parameter-head", title: help }, h("span", {}, label), choice.element);
  }

  private tie(gesture: string): void {
    const rows = rowsIn(this.tied.value);
    this.tied.classList.toggle("unfinished", !rows);
    if (rows && this.tied.value !== listed(rowsOf(this.ties))) this.set("ties", tiesAt(rows), gesture);
  }

  private get ties(): unknown {
    return this.store.design.value.deployment?.["ties"];
  }

  /** Other keys of the table stay; what says nothing new is left out. */
  private set(key: string, value: unknown, gesture = ""): void {
    // A pack has clipped flaps, said or not.
    const clipped = key === "from" ? { flap_attachment: undefined } : {};
    const deployment = tableOf({ ...this.store.design.value.deployment, [key]: value, ...clipped });
    this.store.set({ deployment }, this.store.labels.of(key), gesture);
  }

  private show(table: Record<string, Value>): void {
    const packed = table["from"] === "pack";
    const ties = table["ties"] ?? "none";
    this.choices.get("from")!.set(packed ? "pack" : "flat");
    this.choices.get("flap_attachment")!.set(String(table["flap_attachment"] ?? (packed ? "clipped" : "folded")));
    const tied = rowsOf(ties);
    this.choices.get("ties")!.set(tied ? "folds" : String(ties));
    this.tiedRows.hidden = !tied;
    put(this.tied, listed(tied));
    this.tied.classList.remove("unfinished");
    for (const input of this.choices.get("flap_attachment")!.element.querySelectorAll("input")) input.disabled = packed;
    setNumber(this.hinges, short(Number(table["largest_fold_deg"] ?? WIDEST)));
    const words = [
      packed ? "Flaps of the sheet would keep it from closing into a pack." : "",
      Array.isArray(ties) ? `Ties: ${ties.length} listed in the file.` : "",
    ].filter(Boolean);
    this.note.textContent = words.join(" ");
    this.note.hidden = !words.length;
  }
}

/** The rows across whose folds ties go: none named where it is all of them; null without such ties. */
function rowsOf(ties: unknown): number[] | null {
  if (ties === "folds") return [];
  return typeof ties === "object" && !Array.isArray(ties) ? (ties as { folds: number[] }).folds : null;
}
