// Work that takes a while: how far it is, in words, and a button that stops it.

import { capital } from "../../shared/words.ts";
import { button } from "./controls.ts";
import { h } from "./dom.ts";

export class WorkBar {
  readonly element: HTMLElement;
  private readonly words = h("span", { class: "work-words" });
  private readonly bar: HTMLProgressElement;

  constructor(label: string, stop: () => void, testid: string) {
    this.bar = h("progress", { max: 1, "aria-label": label });
    this.element = h(
      "div",
      { class: "work", hidden: true, "data-testid": testid },
      h("div", { class: "work-head" }, this.words, button({ label: `Stop ${label.toLowerCase()}`, text: "Stop", testid: `${testid}-stop`, act: stop })),
      this.bar,
    );
  }

  show(share: number, what: string): void {
    this.element.hidden = false;
    this.words.textContent = `${capital(what)}… ${Math.round(100 * share)} %`;
    this.bar.value = share;
  }

  begin(what: string): void {
    this.element.hidden = false;
    this.words.textContent = `${capital(what)}…`;
    this.bar.removeAttribute("value");
  }

  hide(): void {
    this.element.hidden = true;
  }
}
