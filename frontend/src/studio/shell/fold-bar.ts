// The fold: a slider over the whole motion, its named states, play and pause.

import { caught, contactOf, frameAt, Journey, nextRest, restsOf, shareOf, stepped, type Stop, stopsOf, targetShare, wayOf } from "../../shared/stops.ts";
import { drives } from "../../shared/view.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { icon } from "../parts/icons.ts";
import { clamp, pretty } from "../parts/numbers.ts";
import { Signal } from "../state/signal.ts";
import type { Store } from "../state/store.ts";

/** Seconds of the whole motion when played, about. */
const DURATION = 5;
/** Longest time between two frames that counts, in seconds. */
const SLOWEST = 0.25;
/** Seconds in which all that is put in at the target appears. */
const PUTTING = 1.2;
/** With reduced motion the shell steps this many times. */
const STEPS = 12;
/** Part of the motion that an arrow key folds, with Shift, and within which dragging is caught. */
const STEP = 0.01;
const STRIDE = 0.1;
const REACH = 0.006;
/** Shares of the motion nearer than this are the same. */
const NEAR = 1e-6;
/** Drives nearer than this are the same (degrees). */
const SAME = 1e-4;

/** By what holds the shell at its target: how that is taken out. */
const TAKEN_OUT = { ties: "Untie", gussets: "Take gussets out", plates: "Take plates out" } as const;

export class FoldBar {
  readonly element: HTMLElement;
  readonly share = new Signal(1);
  /** How much of what is put in at the target is there: flaps, gussets. */
  readonly put = new Signal(1);
  /** What holds the shell at its target was taken out. */
  readonly untied = new Signal(false);
  private stops: Stop[] = [
    { name: "flat", label: "Flat", share: 0 },
    { name: "target", label: "Target", share: 1 },
  ];
  /** Where it rests: at the stops, and where panels touch. */
  private rests = [0, 1];
  private journey = new Journey(this.stops);
  private time = 0;
  private readonly slider: HTMLInputElement;
  private readonly readout = h("output", { class: "readout", "data-testid": "drive" });
  private readonly play: HTMLButtonElement;
  /** One for every stop; the one on the way stands below its mark. */
  private readonly ends = [
    this.end("end", () => this.stops[0]),
    this.end("end on-the-way", () => (this.stops.length > 2 ? this.stops[1] : undefined)),
    this.end("end", () => this.stops.at(-1)),
  ];
  private readonly tick = h("span", { class: "stop-mark", "data-testid": "target-mark" });
  private readonly untie = h("button", { type: "button", class: "button untie", "data-testid": "untie", hidden: true, onclick: () => this.untied.set(!this.untied.value) });
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
      "data-testid": "fold-slider",
    });
    let dragged = false;
    this.slider.addEventListener("pointerdown", () => (dragged = true));
    for (const name of ["pointerup", "pointercancel"]) this.slider.addEventListener(name, () => (dragged = false));
    this.slider.addEventListener("input", () => {
      this.stop();
      const share = this.slider.valueAsNumber;
      this.share.set(dragged ? caught(this.rests, share, REACH) : share);
    });
    this.slider.addEventListener("keydown", (event) => {
      if (this.key(event)) event.preventDefault();
    });
    this.play = h("button", {
      type: "button",
      class: "button play",
      "data-testid": "play",
      onclick: () => (this.playing ? this.stop() : this.start()),
    });
    const [first, between, last] = this.ends.map(({ element }) => element);
    this.element = h(
      "div",
      { class: "fold-bar" },
      this.play,
      first,
      h("div", { class: "fold-track" }, this.slider, this.tick, between, this.mark),
      last,
      this.untie,
      this.readout,
      this.touch,
    );
    this.dress();
    this.name();
    this.share.bind(() => this.refresh());
    this.untied.watch(() => {
      this.put.set(this.usual);
      this.refresh();
    });
    store.view.watch(() => this.follow());
    store.proof.watch(() => this.follow());
  }

  /** Number of the frame nearest to the screen. */
  frameOf(frames: number): number {
    return frameAt(this.stops, this.share.value, frames);
  }

  /** Stay at the target, or move again. */
  hold(on: boolean): void {
    if (on) this.toTarget();
    this.element.inert = on;
  }

  toTarget(): void {
    this.show(targetShare(this.stops));
  }

  /** Go to a share of the motion. */
  show(share: number): void {
    this.stop();
    this.share.set(share);
  }

  toggle(): void {
    if (this.element.inert) return;
    if (this.playing) this.stop();
    else this.start();
  }

  /** Fold by a key, if it means that. */
  key(event: KeyboardEvent): boolean {
    if (this.element.inert || event.ctrlKey || event.metaKey || event.altKey) return false;
    const share = this.share.value;
    const size = event.shiftKey ? STRIDE : STEP;
    const keys: Record<string, () => number> = {
      ArrowLeft: () => stepped(this.rests, share, -size),
      ArrowRight: () => stepped(this.rests, share, size),
      PageDown: () => nextRest(this.rests, share, false),
      PageUp: () => nextRest(this.rests, share, true),
      Home: () => 0,
      End: () => 1,
    };
    const wanted = keys[event.key];
    if (!wanted) return false;
    this.show(wanted());
    return true;
  }

  private end(kind: string, stop: () => Stop | undefined): { element: HTMLButtonElement; stop: () => Stop | undefined } {
    const jump = (): void => this.show(stop()!.share);
    return { element: h("button", { type: "button", class: kind, onclick: jump }), stop };
  }

  private start(): void {
    const share = this.share.value, target = targetShare(this.stops);
    const anew = share >= this.farthest - 0.001;
    if (anew) this.untied.set(false);
    this.journey = this.way();
    this.time = this.journey.timeOf(anew ? 0 : share);
    if ((anew || share < target - NEAR) && this.hasParts) this.put.set(0);
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    let last = performance.now();
    this.playing = true;
    this.dress();
    const tick = (now: number): void => {
      if (!this.playing) return;
      // Where frames are slow the motion slows down rather than jumps.
      const seconds = Math.min(Math.max(0, now - last) / 1000, SLOWEST);
      // What is put in at the target is there before the shell goes on.
      const putting = this.put.value < 1 && this.share.value === target;
      if (putting) this.put.set(still ? 1 : Math.min(1, this.put.value + seconds / PUTTING));
      else this.time = Math.min(this.journey.length, this.time + seconds / DURATION);
      last = now;
      const at = this.journey.shareAt(this.time);
      const rest = this.rests.find((each) => Math.abs(each - at) < NEAR);
      this.share.set(rest ?? (still ? Math.floor(at * STEPS + 1e-9) / STEPS : at));
      if (this.time < this.journey.length || (this.put.value < 1 && rest === target)) this.frame = requestAnimationFrame(tick);
      else this.stop();
    };
    this.frame = requestAnimationFrame(tick);
  }

  /** What keeps the shell from going on beyond its target. */
  private get holding(): keyof typeof TAKEN_OUT | null {
    const { opening } = this.store.view.value?.header.report.deployment ?? {};
    return targetShare(this.stops) < 1 ? (opening ?? null) : null;
  }

  /** How much is put in while nothing is played: nothing where that was taken out. */
  private get usual(): number {
    return this.untied.value && this.holding !== "ties" ? 0 : 1;
  }

  /** Where a motion that is played ends. */
  private get farthest(): number {
    return this.holding && !this.untied.value ? targetShare(this.stops) : 1;
  }

  /** Whether anything is put in at the target. */
  private get hasParts(): boolean {
    return this.store.view.value?.clipped.some(({ header }) => header.drives_deg.length <= 1) ?? false;
  }

  private way(): Journey {
    return new Journey(this.rests.filter((each) => each <= this.farthest + NEAR).map((each) => ({ share: each })));
  }

  private stop(): void {
    if (!this.playing) return;
    this.playing = false;
    this.put.set(this.usual);
    cancelAnimationFrame(this.frame);
    this.dress();
  }

  private dress(): void {
    const label = this.playing ? "Pause" : "Play the folding";
    this.play.replaceChildren(icon(this.playing ? "pause" : "play"));
    this.play.title = `${label} (Space)`;
    setAttribute(this.play, "aria-label", label);
  }

  /** Another shell: what stands at a stop stays there; where the motion goes another way now, the
   * target is shown. */
  private follow(): void {
    const view = this.store.view.value;
    if (view) {
      const share = this.share.value;
      const stood = this.stops.find((stop) => stop.share === share);
      const [before] = this.stops;
      this.stops = stopsOf(view);
      const stands = this.stops.find(({ name }) => name === stood?.name);
      const turned = this.stops[0]?.name !== before?.name;
      this.rests = restsOf(view);
      this.journey = this.way();
      this.time = this.journey.timeOf(share);
      if (stands || turned) this.share.set(stands?.share ?? targetShare(this.stops));
      this.name();
    }
    this.refresh();
  }

  private name(): void {
    for (const { element, stop } of this.ends) {
      const { name, label, share } = stop() ?? {};
      element.textContent = label ?? "";
      setAttribute(element, "data-testid", name);
      element.style.setProperty("--at", String(share));
      element.hidden = !name;
    }
    this.tick.hidden = this.stops.length < 3;
    this.tick.style.setProperty("--at", String(targetShare(this.stops)));
    setAttribute(this.slider, "aria-label", wayOf(this.stops));
  }

  private refresh(): void {
    const share = this.share.value;
    if (this.slider.valueAsNumber !== share) this.slider.value = String(share);
    this.slider.style.setProperty("--share", String(share));
    const { holding } = this;
    this.untie.hidden = !holding || Math.abs(share - targetShare(this.stops)) > NEAR;
    this.untie.textContent = this.untied.value ? "Put back" : holding ? TAKEN_OUT[holding] : "";
    this.untie.title = this.untied.value ? "It is held again" : "What holds the shell here is taken out: it can go on";
    const view = this.store.view.value;
    const known = view?.header.drives_deg.every((drive) => drive !== null) ?? false;
    const all = view && known ? drives(view) : null;
    const drive = all && all[0]! + share * (all.at(-1)! - all[0]!);
    const text = drive === null ? `${Math.round(share * 100)} %` : `${drive.toFixed(1)}°`;
    this.readout.textContent = text;
    this.readout.title = "drive angle";
    setAttribute(this.slider, "aria-valuetext", drive === null ? text : `drive ${drive.toFixed(1)} degrees`);
    const contact = view && contactOf(view);
    this.mark.hidden = this.touch.hidden = !contact || !all;
    if (!contact || !all || drive === null) return;
    this.mark.style.setProperty("--at", String(clamp(shareOf(all, contact.drive_deg), 0, 1)));
    this.touch.textContent = `touches at ${pretty(contact.drive_deg, 4)}°`;
    this.touch.classList.toggle("reached", drive >= contact.drive_deg - SAME);
  }
}
