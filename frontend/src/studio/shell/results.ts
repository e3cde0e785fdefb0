// The right: verdict, crease pattern, figures.

import { renderFigures } from "../../shared/figures.ts";
import { headline, judged } from "../../shared/verdict.ts";
import { explainSigns } from "../../shared/legend.ts";
import { Pattern2D } from "../../shared/pattern2d.ts";
import { assignmentCounts } from "../../shared/view.ts";
import { button } from "../parts/controls.ts";
import { h, keepFocus, scrolledByKeys } from "../parts/dom.ts";
import { ProofCard } from "./proof-card.ts";
import type { Store } from "../state/store.ts";
import { refusedSheet } from "../surface/refused-drawing.ts";

export class Results {
  readonly element: HTMLElement;
  readonly pattern: Pattern2D;
  /** Called when the figures were written. */
  onFigures: ((figures: HTMLElement) => void) | null = null;
  private readonly figures = h("div", { class: "figures", "data-testid": "figures" });
  private readonly proof: ProofCard;
  private readonly said = h("div", { class: "sr-only", role: "status", "aria-live": "polite" });
  private readonly legend = h("div", { class: "pattern-legend", "data-testid": "pattern-legend" });
  private keepView = false;

  /** `again`: prove the shell again. */
  constructor(
    private readonly store: Store,
    again: () => void,
  ) {
    this.proof = new ProofCard(store, again);
    const sheet = h("div", { class: "sheet", "data-testid": "pattern" });
    this.element = h(
      "aside",
      { class: "results", "aria-label": "Crease pattern, verdict and figures" },
      h(
        "header",
        { class: "panel-head" },
        h("h2", {}, "Crease pattern"),
        button({ label: "Fit the crease pattern into view", icon: "fit", testid: "fit-pattern", act: () => this.pattern.fit() }),
      ),
      sheet,
      this.legend,
      this.proof.element,
      scrolledByKeys(h("div", { class: "figures-frame", role: "region", "aria-label": "Figures" }, this.figures)),
      this.said,
    );
    this.pattern = new Pattern2D(sheet, { label: "Crease pattern" });
    sheet.append(refusedSheet(store));
    store.view.bind((view) => (this.element.dataset["empty"] = String(!view)));
    store.freshness.bind((freshness) => (this.element.dataset["freshness"] = freshness));
    store.proof.watch((proof) => {
      if (proof.state !== "done") return;
      this.showFigures();
      const rows = judged(store.report.value);
      this.say(`${headline(rows)?.[0] ?? ""}: ${this.store.labels.said(rows[0]?.finding ?? "")}. ${this.summary()}`);
    });
  }

  /** Show the row of the verdict on a subject. */
  openRow(subject: string): void {
    this.proof.open(subject);
  }

  draw(): void {
    const view = this.store.view.value;
    if (!view) return;
    this.pattern.show(view, this.keepView);
    this.keepView = true;
    this.legend.replaceChildren();
    explainSigns(this.legend, assignmentCounts(view));
    this.showFigures();
  }

  /** Show the whole of the next sheet. */
  forgetView(): void {
    this.keepView = false;
  }

  showFigures(): void {
    const view = this.store.view.value;
    if (!view) return;
    keepFocus(() => {
      renderFigures(this.figures, view, (text) => this.store.labels.said(text));
      this.onFigures?.(this.figures);
    });
  }

  private summary(): string {
    const report = this.store.report.value;
    if (!report) return "";
    const sheet = report.verdict.find(({ subject }) => subject === "sheet")?.finding ?? "";
    return `${report.rows} rows, ${report.columns} columns; the flat sheet is ${sheet}.`;
  }

  private say(text: string): void {
    this.said.textContent = text;
  }
}
