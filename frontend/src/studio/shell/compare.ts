// A design that is pinned: its shape as glass, its pattern as thin lines, its figures beside the present ones.

import { renderFigures } from "../../shared/figures.ts";
import { Ghost3D } from "../../shared/ghost3d.ts";
import { outlines, type View } from "../../shared/view.ts";
import { button } from "../parts/controls.ts";
import { differences } from "../../shared/differences.ts";
import { h, setAttribute } from "../parts/dom.ts";
import type { Results } from "./results.ts";
import type { Stage } from "./stage.ts";
import type { Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";

/** Of larger sheets only the outline is drawn. */
const MANY = 6000;

interface Pinned {
  name: string;
  design: Design;
  view: View;
  figures: HTMLElement;
}

export class Compare {
  readonly button: HTMLButtonElement;
  private pinned: Pinned | null = null;
  private readonly ghost: Ghost3D;
  private readonly redraw: () => void;
  /** The design that was shown last as it is. */
  private shown: Design;

  constructor(
    private readonly store: Store,
    private readonly stage: Stage,
    private readonly results: Results,
    /** Writes the page's own figures, too. */
    private readonly more: (figures: HTMLElement, view: View) => void,
  ) {
    this.button = button({ label: "Pin", icon: "pin", testid: "pin", act: () => this.toggle(), class: "button icon-only" });
    this.ghost = new Ghost3D(stage.shell.uniforms);
    this.redraw = stage.shell.add(this.ghost);
    results.pattern.layers.sheet.push((pen, at, theme) => this.drawFlat(pen, at, theme.text("--ghost")));
    this.shown = store.design.value;
    store.view.watch(() => this.explain());
    store.freshness.bind((now) => {
      if (now === "current") this.shown = store.design.value;
    });
    this.dress();
  }

  /** Put what has changed since the pinned design beside the figures. */
  annotate(figures: HTMLElement): void {
    if (!this.pinned) return;
    if (isPinned(this.pinned.design, this.store)) this.takeAgain(this.pinned);
    for (const row of figures.querySelectorAll<HTMLElement>("[data-figure]")) {
      const key = row.dataset["figure"]!;
      const text = (of: HTMLElement): string => of.querySelector(`[data-figure="${key}"] .orishell-number`)?.textContent ?? "";
      const change = differences(text(figures), text(this.pinned.figures));
      if (change) row.querySelector("dd")!.append(h("span", { class: "pinned-figure", "data-testid": `change-${key}`, title: `pinned: ${text(this.pinned.figures)}` }, change));
    }
    figures.prepend(h("p", { class: "pinned-note" }, h("span", { class: "pinned-key" }), `Against ${this.pinned.name}, pinned`));
  }

  private toggle(): void {
    const view = this.store.view.value;
    if (this.pinned) this.pinned = null;
    else if (view) {
      const { name, design, freshness } = this.store;
      this.pinned = { name: name.value, design: freshness.value === "outdated" ? this.shown : design.value, view, figures: this.figuresOf(view) };
    }
    this.drawGhost();
    this.dress();
    this.results.showFigures();
  }

  private figuresOf(view: View): HTMLElement {
    const figures = h("div");
    renderFigures(figures, view, (text) => this.store.labels.said(text));
    this.more(figures, view);
    return figures;
  }

  /** The pinned design is on the screen: by now more may be known of it, and its shell may be another. */
  private takeAgain(pinned: Pinned): void {
    const view = this.store.view.value!;
    pinned.figures = this.figuresOf(view);
    if (pinned.view === view) return;
    pinned.view = view;
    this.drawGhost();
  }

  /** Whether the pinned shell is seen beside the present one. */
  private get ghostly(): boolean {
    return this.pinned !== null && this.pinned.view !== this.store.view.value;
  }

  private explain(): void {
    this.stage.shell.explainMark("pinned", this.ghostly);
  }

  private drawGhost(): void {
    this.ghost.set(this.pinned?.view ?? null);
    this.redraw();
    this.explain();
    this.results.pattern.refresh(true);
  }

  private dress(): void {
    const label = this.pinned ? "Unpin the design" : "Pin this design, to compare others with it";
    setAttribute(this.button, "aria-label", label);
    setAttribute(this.button, "aria-pressed", String(this.pinned !== null));
    this.button.title = label;
  }

  /** About the middle of the present sheet. */
  private drawFlat(pen: CanvasRenderingContext2D, at: (x: number, y: number) => [number, number], ink: string): void {
    const present = this.store.view.value;
    const view = this.pinned?.view;
    if (!this.ghostly || !view?.flat.length || !present?.flat.length) return;
    const [u, v] = middle(present.flat), [x, y] = middle(view.flat);
    const place = (vertex: number): [number, number] => at(view.flat[2 * vertex]! - x + u, view.flat[2 * vertex + 1]! - y + v);
    pen.strokeStyle = ink;
    pen.lineWidth = 1;
    pen.beginPath();
    if (view.edges.length / 2 <= MANY) {
      for (let e = 0; e < view.edges.length; e += 2) {
        pen.moveTo(...place(view.edges[e]!));
        pen.lineTo(...place(view.edges[e + 1]!));
      }
    } else {
      for (const rim of outlines(view)) {
        rim.forEach((vertex, k) => pen[k ? "lineTo" : "moveTo"](...place(vertex)));
        pen.closePath();
      }
    }
    pen.stroke();
  }
}

/** Whether the shell on the screen is that of a design. */
export function isPinned(design: Design, store: Pick<Store, "design" | "freshness">): boolean {
  return store.freshness.value === "current" && store.design.value === design;
}

/** Middle of the box of points (n, 2). */
function middle(flat: Float32Array): [number, number] {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (let i = 0; i < flat.length; i++) {
    low[i & 1] = Math.min(low[i & 1]!, flat[i]!);
    high[i & 1] = Math.max(high[i & 1]!, flat[i]!);
  }
  return [(low[0]! + high[0]!) / 2, (low[1]! + high[1]!) / 2];
}
