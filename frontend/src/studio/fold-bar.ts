// The fold: a slider from flat to lock, play and pause.

import { h, setAttribute } from "./dom.ts";
import { icon } from "./icons.ts";
import { clamp, pretty } from "./numbers.ts";
import { Signal } from "./signal.ts";
import type { Store } from "./store.ts";

/** Seconds from flat to lock when played. */
const DURATION = 5;
/** Longest time between two frames that counts, in seconds. */
const SLOWEST = 0.25;
/** With reduced motion the shell steps this many times. */
const STEPS = 12;

export class FoldBar {
  readonly element: HTMLElement;
  readonly share = new Signal(1);
  private readonly slider: HTMLInputElement;
  private readonly readout = h("output", { class: "readout", "data-testid": "drive" });
  private readonly play: HTMLButtonElement;
  private readonly mark = h("span", { class: "contact-mark", hidden: true });
  private readonly touch = h("span", { class: "touch", "data-testid": "contact", hidden: true });
  private frame = 0;
  private playing = false;

  constructor(private readonly store: Store) {
    this.slider = h("input", {
      type: "range",
      class: "fold",
      min: 0,
      max: 1,
      step: 0.001,
      value: 1,
      "aria-label": "Fold, from flat to locked",
      "data-testid": "fold-slider",
    });
    this.slider.addEventListener("input", () => {
      this.stop();
      this.share.set(this.slider.valueAsNumber);
    });
    this.play = h("button", {
      type: "button",
      class: "button play",
      "data-testid": "play",
      onclick: () => (this.playing ? this.stop() : this.start()),
    });
    this.element = h(
      "div",
      { class: "fold-bar" },
      this.play,
      h("button", { type: "button", class: "end", "data-testid": "flat", onclick: () => this.jump(0) }, "Flat"),
      h("div", { class: "fold-track" }, this.slider, this.mark),
      h("button", { type: "button", class: "end", "data-testid": "locked", onclick: () => this.jump(1) }, "Locked"),
      this.readout,
      this.touch,
    );
    this.dress();
    this.share.bind(() => this.refresh());
    store.view.watch(() => this.refresh());
    store.proof.watch(() => this.refresh());
  }

  toggle(): void {
    if (this.playing) this.stop();
    else this.start();
  }

  jump(share: number): void {
    this.stop();
    this.share.set(share);
  }

  private start(): void {
    let share = this.share.value >= 0.999 ? 0 : this.share.value;
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    let last = performance.now();
    this.playing = true;
    this.dress();
    const tick = (now: number): void => {
      if (!this.playing) return;
      // Where frames are slow the motion slows down rather than jumps.
      const seconds = Math.min(Math.max(0, now - last) / 1000, SLOWEST);
      share = Math.min(1, share + seconds / DURATION);
      last = now;
      this.share.set(still ? Math.floor(share * STEPS + 1e-9) / STEPS : share);
      if (share < 1) this.frame = requestAnimationFrame(tick);
      else this.stop();
    };
    this.frame = requestAnimationFrame(tick);
  }

  private stop(): void {
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.frame);
    this.dress();
  }

  private dress(): void {
    const label = this.playing ? "Pause" : "Play the folding";
    this.play.replaceChildren(icon(this.playing ? "pause" : "play"));
    this.play.title = `${label} (Space)`;
    setAttribute(this.play, "aria-label", label);
  }

  private refresh(): void {
    const share = this.share.value;
    if (this.slider.valueAsNumber !== share) this.slider.value = String(share);
    this.slider.style.setProperty("--share", String(share));
    const header = this.store.view.value?.header;
    const [first, last] = [header?.drives_deg[0], header?.drives_deg.at(-1)];
    const known = typeof first === "number" && typeof last === "number";
    const drive = known ? first + share * (last - first) : null;
    const text = drive === null ? `${Math.round(share * 100)} %` : `${drive.toFixed(1)}°`;
    this.readout.textContent = text;
    this.readout.title = "drive angle";
    setAttribute(this.slider, "aria-valuetext", drive === null ? text : `drive ${drive.toFixed(1)} degrees`);
    const contact = header?.contact;
    this.mark.hidden = this.touch.hidden = !contact || !known;
    if (!contact || !known) return;
    const at = clamp((contact.drive_deg - first) / (last - first), 0, 1);
    this.mark.style.setProperty("--at", String(at));
    this.touch.textContent = `touches at ${pretty(contact.drive_deg, 4)}°`;
    this.touch.classList.toggle("reached", share >= at - 1e-6);
  }
}
