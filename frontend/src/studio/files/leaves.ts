// Pictures on paper to leaf through, by buttons and by keys.

import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";

export interface Leaf {
  svg: string;
  /** What is on it, for those who do not see it. */
  says: string;
  /** What it is called beside its number, if it has a name. */
  name: string;
}

export class Leaves {
  readonly paper: HTMLElement;
  readonly turner: HTMLElement;
  private readonly picture = h("img", { class: "sheet-picture", alt: "", "data-testid": "sheet-picture" });
  private readonly place = h("span", { class: "sheet-place", "data-testid": "sheet-place", "aria-live": "polite" });
  private readonly back = button({ label: "Previous", text: "‹", testid: "sheet-back", act: () => this.turn(-1) });
  private readonly next = button({ label: "Next", text: "›", testid: "sheet-next", act: () => this.turn(1) });
  private leaves: readonly Leaf[] = [];
  private kind = "";
  private at = 0;
  private url = "";

  constructor() {
    this.paper = h("div", { class: "sheet-paper", tabindex: 0, role: "group", "aria-label": "Sheet" }, this.picture);
    this.turner = h("div", { class: "sheet-leaves" }, this.back, this.place, this.next);
    this.paper.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      this.turn(step);
    });
  }

  /** Show others, the first of them or the one in the same place; `kind` stands before its number. */
  show(leaves: readonly Leaf[], kind = "", fromFirst = false): void {
    this.leaves = leaves;
    this.paper.hidden = !leaves.length;
    this.turner.hidden = leaves.length < 2;
    this.kind = kind;
    this.go(fromFirst ? 0 : this.at);
  }

  private turn(step: number): void {
    const before = this.at;
    this.go(before + step);
    if (this.at !== before) this.paper.scrollTo(0, 0);
  }

  private go(to: number): void {
    const last = this.leaves.length - 1;
    this.at = Math.max(Math.min(to, last), 0);
    const leaf = this.leaves[this.at];
    this.place.textContent = leaf ? `${this.kind}${this.at + 1} of ${last + 1}${leaf.name && `: ${leaf.name}`}` : "";
    this.back.setAttribute("aria-disabled", String(this.at === 0));
    this.next.setAttribute("aria-disabled", String(this.at >= last));
    this.picture.alt = leaf?.says ?? "";
    this.draw(leaf?.svg ?? "");
  }

  /** A picture runs nothing, whatever is in it. */
  private draw(svg: string): void {
    if (this.url) URL.revokeObjectURL(this.url);
    this.url = svg && URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
    if (this.url) this.picture.src = this.url;
    else this.picture.removeAttribute("src");
  }
}
