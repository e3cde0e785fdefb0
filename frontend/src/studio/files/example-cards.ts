// The examples as cards with pictures, in a window of their own.

import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { theme } from "../parts/theme.ts";
import type { Example } from "./example-list.ts";

/** Addresses of the pictures by their files: one of each example for light and for dark colours. */
const PICTURES = import.meta.glob<string>("./pictures/*.webp", { eager: true, query: "?url", import: "default" });

export class ExampleCards {
  readonly element: HTMLDialogElement;

  constructor(examples: Example[], take: (example: Example) => void) {
    this.element = h(
      "dialog",
      { class: "dialog examples", "aria-labelledby": "examples-title", "data-testid": "examples-window" },
      h(
        "header",
        { class: "panel-head" },
        h("h2", { id: "examples-title" }, "Examples"),
        button({ label: "Close", icon: "close", testid: "examples-close", act: () => this.element.close() }),
      ),
      h("ul", { class: "example-cards" }, ...examples.map((example) => h("li", {}, this.card(example, take)))),
    );
    this.element.addEventListener("click", (event) => event.target === this.element && this.element.close());
  }

  open(): void {
    this.element.showModal();
  }

  private card(example: Example, take: (example: Example) => void): HTMLElement {
    const { name, title, what } = example;
    const picture = h("img", { class: "example-picture", alt: "", loading: "lazy", width: 336, height: 224 });
    theme.bind((colours) => (picture.src = PICTURES[`./pictures/${name}-${colours}.webp`] ?? ""));
    return h(
      "button",
      {
        type: "button",
        class: "example-card",
        "data-testid": `example-${name}`,
        onclick: () => {
          this.element.close();
          take(example);
        },
      },
      picture,
      h("span", { class: "example-title" }, title),
      h("span", { class: "example-what" }, what),
    );
  }
}
