// The fold slider and its motion from flat to locked and back.

import { element } from "./elements.ts";

/** Time from flat to locked (ms). */
const DURATION = 6000;

export class Player {
  readonly bar = element("div", "player", { role: "group", "aria-label": "Fold" });
  private readonly button = element("button", "play", { type: "button" });
  private readonly slider = element("input", "", { type: "range", min: "0", max: "1", step: "0.001" });
  private readonly reading = element("output", "reading");
  private request = 0;
  private time = 0;
  private direction = 1;
  private last = 0;
  private share = 1;

  /** `end` names the state at the slider's right end. */
  constructor(end: string, private readonly fold: (share: number) => void) {
    this.slider.setAttribute("aria-label", `Fold, from flat to ${end}`);
    this.bar.append(this.button, element("span", "end", { "aria-hidden": "true" }, "flat"), this.slider,
      element("span", "end", { "aria-hidden": "true" }, end), this.reading);
    this.slider.addEventListener("input", () => {
      this.stop();
      this.set(Number(this.slider.value));
    });
    this.button.addEventListener("click", () => this.toggle());
    this.name();
  }

  set(share: number): void {
    this.share = share;
    this.slider.value = String(share);
    this.slider.style.setProperty("--share", String(share));
    this.fold(share);
  }

  say(text: string): void {
    this.reading.textContent = text;
    this.slider.setAttribute("aria-valuetext", text);
  }

  toggle(): void {
    if (this.request) {
      this.stop();
      return;
    }
    // From where it stands, towards the farther end if it stands at one.
    this.direction = this.share >= 1 ? -1 : 1;
    this.time = timeOf(this.share);
    this.last = 0;
    this.request = requestAnimationFrame(this.step);
    this.name();
  }

  stop(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
    this.name();
  }

  private readonly step = (now: number): void => {
    const passed = this.last ? Math.min(now - this.last, 100) : 0;
    this.last = now;
    this.time += (this.direction * passed) / DURATION;
    // A moment's rest at either end.
    if (this.time > 1.08) this.direction = -1;
    if (this.time < -0.08) this.direction = 1;
    this.set(shareAt(Math.min(1, Math.max(0, this.time))));
    this.request = requestAnimationFrame(this.step);
  };

  private name(): void {
    this.button.classList.toggle("playing", this.request !== 0);
    this.button.setAttribute("aria-label", this.request ? "Pause" : "Play");
    this.button.title = this.request ? "Pause" : "Play";
  }
}

/** Slow at both ends. */
function shareAt(time: number): number {
  return 0.5 - 0.5 * Math.cos(Math.PI * time);
}

function timeOf(share: number): number {
  return Math.acos(1 - 2 * Math.min(1, Math.max(0, share))) / Math.PI;
}
