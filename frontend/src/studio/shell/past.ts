// The last designs that worked and rested, as small pictures to go back to.

import { button } from "../parts/controls.ts";
import { h, keepFocus, setAttribute } from "../parts/dom.ts";
import type { Stage } from "./stage.ts";
import type { Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";

const MOST = 8;
/** Pixels of a picture, of which the page shows half. */
const WIDTH = 208;
const HEIGHT = 136;

interface Past {
  design: Design;
  button: HTMLButtonElement;
}

export class PastDesigns {
  readonly button = button({ label: "Earlier designs", icon: "past", testid: "past", act: () => this.show(this.element.hidden) });
  readonly element = h("div", { class: "past", role: "group", "aria-label": "Earlier designs", "data-testid": "past-strip", hidden: true });
  private designs: Past[] = [];

  constructor(
    private readonly store: Store,
    private readonly stage: Stage,
  ) {
    store.proof.watch((proof) => {
      if (proof.state === "done" && !proof.refusal) this.keep();
    });
    store.design.watch(() => this.mark());
    this.element.append(h("p", { class: "quiet" }, "Designs that work and rest for a moment come here."));
    this.show(false);
  }

  show(on: boolean): void {
    this.element.hidden = !on;
    setAttribute(this.button, "aria-expanded", String(on));
  }

  private keep(): void {
    const work = this.store.named, { name, design } = work;
    if (!this.store.view.value || this.designs.at(-1)?.design === design) return;
    const { rows, columns } = this.store.report.value!;
    const words = `${name}, ${rows} rows, ${columns} columns`;
    const back = (): void => {
      if (design !== this.store.design.value) this.store.open(work, "earlier design");
    };
    const known = this.designs.find((each) => each.design === design);
    const picture = known ? null : this.stage.shell.picture(WIDTH, HEIGHT);
    if (picture) setAttribute(picture, "aria-hidden", "true");
    const made = known?.button ?? h("button", { type: "button", class: "past-design", title: words, "aria-label": `Back to ${words}`, onclick: back }, picture);
    this.designs = [...this.designs.filter((each) => each.design !== design), { design, button: made }].slice(-MOST);
    keepFocus(() => this.element.replaceChildren(...this.designs.map((each) => each.button)));
    this.mark();
  }

  private mark(): void {
    for (const { design, button: made } of this.designs) setAttribute(made, "aria-current", design === this.store.design.value ? "true" : null);
  }
}
