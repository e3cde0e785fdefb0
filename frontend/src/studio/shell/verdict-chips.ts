// The verdict on the canvas: a chip for every row that judges the shell itself. A click lights what it is about,
// and opens the row.

import { Vector3 } from "three";
import { Chosen3D } from "../../shared/moving3d.ts";
import type { Motion } from "../../shared/rigid.ts";
import { cornersOf } from "../../shared/ties.ts";
import { MEANS, PENDING, SIGNS, type Shown } from "../../shared/verdict.ts";
import { capital, sentence } from "../../shared/words.ts";
import { h, keepFocus } from "../parts/dom.ts";
import { Signal } from "../state/signal.ts";
import type { Store } from "../state/store.ts";
import type { Stage } from "./stage.ts";
import { placeOf } from "./verdict-place.ts";
import { rowsNow } from "./verdict-rows.ts";

/** What a shell goes through, in that order: the chips keep their places. */
const SUBJECTS = ["folds", "locks", "held", "packs", "stands"];
/** The chip of a proof that failed. */
const FAILED = "verdict";

export class VerdictChips {
  readonly element = h("div", { class: "verdict-chips", role: "group", "aria-label": "Verdict", "data-testid": "chips" });
  /** The subject whose place is lit. */
  readonly lit = new Signal<string | null>(null);

  /** `open` shows the row of a subject. */
  constructor(
    private readonly store: Store,
    private readonly stage: Stage,
    private readonly open: (subject: string) => void,
  ) {
    const { shell } = stage;
    const redraw = shell.add(new Chosen3D(shell.uniforms, "--accent", (motion) => this.marks(motion)));
    for (const signal of [store.proof, store.report, store.freshness, store.view]) {
      (signal as { watch(listener: () => void): void }).watch(() => this.show());
    }
    store.design.watch(() => this.lit.set(null));
    this.lit.watch((subject) => {
      const view = store.view.value, place = view && subject ? placeOf(subject, view) : null;
      shell.explainMark("verdict", place !== null && [place.panels, place.ties, place.feet].some((each) => each.length > 0));
      redraw();
      this.show();
    });
    this.show();
  }

  private show(): void {
    const { proof, view } = this.store;
    const rows = rowsNow(this.store);
    const shown = proof.value.state === "failed"
      ? [{ subject: FAILED, sign: "fails" as const, words: "not verified", row: null }]
      : SUBJECTS.flatMap((subject) => rows.find((row) => row.subject === subject) ?? []);
    this.element.hidden = !view.value || !shown.length;
    keepFocus(() => this.element.replaceChildren(...shown.map((row) => this.chip(row))));
  }

  private chip({ subject, sign, words }: Shown): HTMLElement {
    const said = this.store.labels.said(words).trim();
    const known = sign !== "pending" && !said.startsWith("not ");
    const short = known ? MEANS[sign] : said.split(/[:;]/)[0]!;
    return h(
      "button",
      {
        type: "button",
        class: "verdict-chip",
        "data-testid": `chip-${subject}`,
        "data-sign": sign,
        "data-known": String(known),
        "aria-pressed": String(this.lit.value === subject),
        title: sentence(said),
        onclick: () => this.press(subject),
      },
      h("span", { class: "verdict-mark", "aria-hidden": "true" }, sign === "pending" ? PENDING : SIGNS[sign]),
      h("b", {}, capital(subject)),
      " ",
      h("small", {}, short),
    );
  }

  private press(subject: string): void {
    const view = this.store.view.value;
    if (this.lit.value === subject || !view) return this.lit.set(null);
    const { share, load } = placeOf(subject, view);
    this.stage.loads.want(load);
    this.stage.fold.show(share);
    this.lit.set(subject);
    this.open(subject);
  }

  /** Outlines of panels, lines of ties, dots at feet. */
  private marks(motion: Motion): { lines: Vector3[]; dots: Vector3[] } {
    const view = this.store.view.value, subject = this.lit.value;
    if (!view || !subject) return { lines: [], dots: [] };
    const { panels, ties, feet } = placeOf(subject, view);
    const corners = cornersOf(motion.faces, view);
    const at = (corner: number): Vector3 => motion.at(corner, new Vector3());
    return {
      lines: [
        ...panels.filter((panel) => panel < motion.panels).flatMap((panel) => [0, 1, 1, 2, 2, 3, 3, 0].map((k) => at(4 * panel + k))),
        ...ties.flatMap((ends) => ends.map((vertex) => at(corners[vertex]!))),
      ],
      dots: feet.map((vertex) => at(corners[vertex]!)),
    };
  }
}
