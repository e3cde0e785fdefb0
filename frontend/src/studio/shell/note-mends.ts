// What does what notes say. A change is tried when its note is read, or, where that takes long, when
// somebody asks; its button is there once it works.

import type { Mendable } from "../../shared/api-types.ts";
import { capital } from "../../shared/words.ts";
import { button } from "../parts/controls.ts";
import { h, keepFocus } from "../parts/dom.ts";
import { changeButton } from "../parts/remedy-button.ts";
import { WorkBar } from "../parts/work-bar.ts";
import { findMend } from "../server/api.ts";
import { isSlow } from "../state/aims.ts";
import { ServerFault } from "../state/faults.ts";
import { isSameShell } from "../state/sizing.ts";
import type { Store } from "../state/store.ts";

/** What stands below notes on a matter, and whether it was looked for. */
interface Slot {
  element: HTMLElement;
  slow: boolean;
  asked: boolean;
}

export class NoteMends {
  /** By what notes are about; of the shell on the screen. */
  private slots = new Map<string, Slot>();
  private about = new Map<string, string>();
  private stopping = new AbortController();
  /** Trials under way: one after the other, beside the proof of whatever comes next. */
  private turn: Promise<void> = Promise.resolve();

  constructor(private readonly store: Store) {
    store.design.watch((now, before) => void (isSameShell(now, before) || this.begin([])));
    store.proof.watch((proof) => this.begin(proof.state === "done" ? proof.mendable : []));
  }

  /** What stands below a note; null where nothing can be tried. */
  beside(note: string): HTMLElement | null {
    const about = this.about.get(note);
    // Of two notes on a matter the first has it.
    if (about === undefined || [...this.about].find(([, each]) => each === about)![0] !== note) return null;
    return this.slots.get(about)!.element;
  }

  /** Notes are read: try what is tried quickly. */
  look(): void {
    for (const [about, slot] of this.slots) if (!slot.slow) this.ask(about, slot);
  }

  private begin(mendable: readonly Mendable[]): void {
    this.stopping.abort();
    this.stopping = new AbortController();
    // What is tried is what the button does: where that is a search or a fit, so is the trial.
    const searched = isSlow(this.store.design.value) || Boolean(this.store.design.value.tolerance);
    this.about = new Map(mendable.map(({ note, about }) => [note, about]));
    this.slots = new Map(
      mendable.map(({ about, slow }): [string, Slot] => {
        const slot = { element: h("div", { class: "note-mend", "data-testid": `mend-${about.replaceAll(" ", "-")}` }), slow: slow || searched, asked: false };
        if (slot.slow) this.offer(about, slot);
        return [about, slot];
      }),
    );
  }

  /** The button that has it looked for. */
  private offer(about: string, slot: Slot): void {
    const text = "Look for what mends it";
    slot.asked = false;
    keepFocus(() => slot.element.replaceChildren(button({ label: text, text, testid: "look-for-mend", act: () => this.ask(about, slot) })));
  }

  private ask(about: string, slot: Slot): void {
    if (slot.asked) return;
    slot.asked = true;
    const { signal } = this.stopping;
    const design = this.store.design.value;
    this.turn = this.turn.then(() => (signal.aborted ? undefined : this.find(about, slot, design, signal)));
  }

  private async find(about: string, slot: Slot, design: Store["design"]["value"], signal: AbortSignal): Promise<void> {
    const own = new AbortController();
    signal.addEventListener("abort", () => own.abort());
    const work = new WorkBar("Trials", () => own.abort(), "mend-work");
    const quiet = h("span", { class: "quiet" }, "Trying what mends it\u2026");
    work.begin("trying what mends it");
    keepFocus(() => slot.element.replaceChildren(slot.slow ? work.element : quiet));
    const progressed = (share: number, what: string): void => void (own.signal.aborted || work.show(share, what));
    try {
      const found = await findMend(design, about, own.signal, progressed, slot.slow);
      if (own.signal.aborted) return;
      const none = slot.slow ? h("span", { class: "quiet" }, "Nothing that was tried mends it.") : "";
      keepFocus(() => slot.element.replaceChildren(found ? changeButton(this.store, found.changes, { text: found.text }) : none));
    } catch (error) {
      if (signal.aborted) return;
      if (own.signal.aborted) return this.offer(about, slot);
      if (!(error instanceof ServerFault)) throw error;
      slot.slow = true;
      this.offer(about, slot);
      slot.element.append(h("span", { class: "quiet" }, capital(error.fault.message)));
    }
  }
}
