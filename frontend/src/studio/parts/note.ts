// A line below a target: what was read, or what is wrong with it.

import { sentence } from "../../shared/words.ts";
import { h } from "./dom.ts";
import { icon } from "./icons.ts";

export class Note {
  readonly element = h("p", { class: "note", hidden: true });

  say(text: string, wrong = false): void {
    this.element.replaceChildren(...(wrong ? [icon("warning"), text] : [text]));
    this.element.hidden = !text;
    this.element.classList.toggle("error", wrong);
  }

  /** Says a fault, or takes one back that is mended. */
  showFault(fault: string | null): void {
    if (fault !== null) this.say(sentence(fault), true);
    else if (this.element.classList.contains("error")) this.say("");
  }
}
