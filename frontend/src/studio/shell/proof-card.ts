// The verdict on the shell: rows, worst first, the progress of the proof, and what would mend a contact.

import { headline, judged, type Missing, signOf, type Tone, Verdict } from "../../shared/verdict.ts";
import { capital, sentence } from "../../shared/words.ts";
import { button } from "../parts/controls.ts";
import { h, keepFocus } from "../parts/dom.ts";
import { wordsOfRemedies } from "../state/faults.ts";
import { changeButton, remedyButton } from "../parts/remedy-button.ts";
import { missingOf } from "./verdict-rows.ts";
import { isFound, type Proof, type Store } from "../state/store.ts";
import { NoteMends } from "./note-mends.ts";
import type { Fault } from "../state/types.ts";

export class ProofCard {
  readonly element: HTMLElement;
  private readonly text = h("span", { class: "proof-text" });
  private readonly mark = h("span", { class: "proof-mark" });
  private readonly refusal = h("div", { class: "proof-refusal", "data-testid": "refusal", hidden: true });
  private readonly bar = h("progress", { max: 1, "aria-label": "Verification" });
  private readonly verdict: Verdict;
  private readonly mends: NoteMends;

  constructor(
    private readonly store: Store,
    /** Prove the shell again, with more time. */
    private readonly again: () => void,
  ) {
    const { labels } = store;
    this.mends = new NoteMends(store);
    this.verdict = new Verdict(
      (text) => labels.said(text),
      ({ changes }) => (Object.keys(changes).length ? changeButton(store, changes) : null),
      (note) => this.mends.beside(note),
    );
    // "toggle" does not bubble.
    this.verdict.element.addEventListener("toggle", ({ target }) => this.opened(target as HTMLDetailsElement), { capture: true });
    this.element = h(
      "section",
      { class: "proof", "data-testid": "verify-status", "aria-labelledby": "verdict-title" },
      h("h2", { id: "verdict-title" }, this.mark, this.text),
      this.bar,
      this.verdict.element,
      this.refusal,
    );
    store.proof.bind((proof) => this.show(proof));
    for (const signal of [store.freshness, store.view, store.report]) {
      (signal as { watch(listener: () => void): void }).watch(() => this.show(store.proof.value));
    }
  }

  /** Open the row of a subject, where it is read; its head where there is none. */
  open(subject: string): void {
    const row = this.verdict.open(subject) ?? this.element;
    row.scrollIntoView({ block: "nearest" });
  }

  private show(proof: Proof): void {
    const report = this.store.report.value;
    const [text, tone] = this.words(proof);
    this.text.textContent = text;
    this.element.dataset["state"] = proof.state;
    this.element.dataset["tone"] = tone ?? "quiet";
    this.mark.replaceChildren(...(tone ? [signOf(tone)] : []));
    keepFocus(() => {
      this.verdict.show(proof.state === "failed" ? null : report, this.missing(proof), isFound(proof));
      this.refuse(proof.state === "done" ? proof.refusal : proof.state === "failed" ? proof.fault : null);
    });
    this.bar.hidden = proof.state !== "running";
    if (proof.state === "running" && proof.share > 0) this.bar.value = proof.share;
    else this.bar.removeAttribute("value");
  }

  /** Of notes that are read it is looked for what mends them. */
  private opened(row: HTMLDetailsElement): void {
    if (row.open && row.querySelector(".note-mend")) this.mends.look();
  }

  /** What is said of rows that are not known; where time was over, with what looks again. */
  private missing({ state }: Proof): Missing | null {
    const missing = missingOf(this.store);
    if (!missing || state !== "late") return missing;
    const mend = (): HTMLElement => button({ label: "Retry, with more time", text: "Retry, with more time", class: "button primary", testid: "retry", act: this.again });
    return { ...missing, mend };
  }

  /** What would keep the panels apart. */
  private refuse(fault: Fault | null): void {
    const { labels } = this.store;
    const found = fault ? wordsOfRemedies(fault, (remedy) => labels.remedy(remedy)) : "";
    const words = found ? `Nearest found that works: ${found}.` : sentence(labels.said(fault?.remedy ?? ""));
    this.refusal.hidden = !words;
    if (!fault || !words) return this.refusal.replaceChildren();
    this.refusal.replaceChildren(h("p", {}, words), remedyButton(this.store, fault) ?? "");
  }

  private words(proof: Proof): [string, Tone | null] {
    switch (proof.state) {
      case "none":
        return [
          this.store.freshness.value !== "outdated"
            ? "Computing\u2026"
            : this.store.view.value
              ? "Not verified. Pattern and figures are those of the last shell that worked."
              : "There is no shell yet.",
          null,
        ];
      case "waiting":
        return ["Verifying\u2026", null];
      case "running":
        return [`${capital(proof.what)}\u2026${proof.share > 0 ? ` ${Math.round(100 * proof.share)} %` : ""}`, null];
      case "stopped":
        return ["Stopped: not verified.", null];
      case "late":
        return [sentence(`Not finished in time: ${proof.what}`), "warns"];
      case "failed":
        return [sentence(this.store.labels.said(proof.fault.message)), "fails"];
      case "done":
        return headline(judged(this.store.report.value)) ?? ["Not verified.", null];
    }
  }
}
