// What is proved about the motion: that nothing touches on the way, or what does.

import { capital, sentence } from "../../shared/words.ts";
import { h } from "../parts/dom.ts";
import { wordsOfRemedies } from "../state/faults.ts";
import { icon } from "../parts/icons.ts";
import { type Tone, wordsOfLock } from "./lock.ts";
import { remedyButton } from "../parts/remedy-button.ts";
import type { Proof, Store } from "../state/store.ts";
import type { Fault } from "../state/types.ts";

export class ProofCard {
  readonly element: HTMLElement;
  private readonly text = h("span", { class: "proof-text" });
  private readonly mark = h("span", { class: "proof-mark" });
  private readonly refusal = h("div", { class: "proof-refusal", "data-testid": "refusal", hidden: true });
  private readonly bar = h("progress", { max: 1, "aria-label": "Verification" });

  constructor(private readonly store: Store) {
    this.element = h(
      "div",
      { class: "proof", "data-testid": "verify-status" },
      this.mark,
      h("div", { class: "proof-body" }, this.text, this.bar, this.refusal),
    );
    store.proof.bind((proof) => this.show(proof));
    for (const signal of [store.freshness, store.view]) {
      (signal as { watch(listener: () => void): void }).watch(() => this.show(store.proof.value));
    }
  }

  private show(proof: Proof): void {
    const [text, tone] = this.words(proof);
    this.text.textContent = text;
    this.element.dataset["state"] = proof.state;
    this.element.dataset["tone"] = tone;
    this.mark.replaceChildren(...(tone === "quiet" ? [] : [icon(tone === "good" ? "done" : "warning")]));
    this.refuse(proof.state === "done" ? proof.refusal : null);
    this.bar.hidden = proof.state !== "running";
    if (proof.state === "running" && proof.share > 0) this.bar.value = proof.share;
    else this.bar.removeAttribute("value");
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

  private words(proof: Proof): [string, Tone] {
    switch (proof.state) {
      case "none":
        return [
          this.store.freshness.value !== "outdated"
            ? "Computing…"
            : this.store.view.value
              ? "Not verified. Pattern and figures are those of the last shell that worked."
              : "There is no shell yet.",
          "quiet",
        ];
      case "waiting":
        return ["Verifying…", "quiet"];
      case "running":
        return [`${capital(proof.what)}…${proof.share > 0 ? ` ${Math.round(100 * proof.share)} %` : ""}`, "quiet"];
      case "failed":
        return [sentence(this.store.labels.said(proof.fault.message)), "bad"];
      case "done":
        return wordsOfLock(this.store.report.value);
    }
  }
}
