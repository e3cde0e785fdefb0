// What is wrong with the design, in words, and the nearest value that works.

import { sentence } from "../../shared/words.ts";
import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { patternKeysOf, wordsOfRemedies } from "../state/faults.ts";
import { icon } from "../parts/icons.ts";
import type { Labels } from "../state/labels.ts";
import { patternKeys, remedyButton } from "../parts/remedy-button.ts";
import type { Store } from "../state/store.ts";
import type { Fault } from "../state/types.ts";

export interface BannerEvents {
  /** Go to the control that a fault is about. */
  goTo(key: string): void;
  /** Show the family's own example. */
  example(family: string): void;
}

const TITLES: Record<string, string> = {
  input: "Not usable yet",
  design: "This shell cannot be made",
  limit: "Too large",
  time: "Takes too long",
  network: "No answer",
  fault: "A fault of the program",
};

export class Banner {
  readonly element: HTMLElement;

  constructor(
    private readonly store: Store,
    private readonly events: BannerEvents,
  ) {
    this.element = h("div", { class: "banner", "data-testid": "banner", role: "status", "aria-live": "polite", hidden: true });
    store.fault.bind((fault) => this.show(fault));
  }

  private show(fault: Fault | null): void {
    this.element.hidden = !fault;
    if (!fault) return this.element.replaceChildren();
    this.element.dataset["kind"] = fault.kind;
    this.element.replaceChildren(
      h("div", { class: "banner-mark" }, icon("warning")),
      h(
        "div",
        { class: "banner-body" },
        h("p", { class: "banner-title" }, TITLES[fault.kind] ?? "Something went wrong"),
        h("p", {}, sentence(this.store.labels.said(fault.what))),
        fault.detail ? h("pre", {}, fault.detail) : null,
        this.actions(fault),
        facts(fault, this.store.labels),
      ),
    );
  }

  private actions(fault: Fault): HTMLElement {
    const { labels } = this.store;
    const { family } = this.store.design.value.shell;
    const keys = patternKeys(this.store);
    const key = patternKeysOf(fault).find((each) => keys.includes(each));
    return h(
      "div",
      { class: "banner-actions" },
      remedyButton(this.store, fault),
      key ? button({ label: `Go to ${labels.of(key)}`, text: `Go to ${labels.of(key)}`, act: () => this.events.goTo(key) }) : null,
      fault.kind === "design"
        ? button({ label: "Show an example of this family", text: "Example of this family", act: () => this.events.example(family) })
        : null,
    );
  }
}

function facts(fault: Fault, labels: Labels): HTMLElement | null {
  const rows: [string, string][] = [
    ["Where", fault.place],
    ["Found", fault.got],
    ["Expected", fault.expected],
    ["By how much", fault.size],
    ["Remedy", fault.remedy],
    ["Nearest found that works", wordsOfRemedies(fault, (remedy) => labels.remedy(remedy))],
  ];
  const known = rows.filter(([, text]) => text);
  if (!known.length) return null;
  return h("dl", {}, ...known.flatMap(([name, text]) => [h("dt", {}, name), h("dd", {}, name.startsWith("Nearest") ? text : labels.said(text))]));
}
