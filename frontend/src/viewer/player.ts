// The fold slider, its named states, and the motion through them and back.

import { Journey, type Stop, targetShare, wayOf } from "../shared/stops.ts";
import { element } from "./elements.ts";

/** Time of the whole motion (ms), about. */
const DURATION = 6000;
/** A moment's rest at either end, as a part of it. */
const REST = 0.08;

export class Player {
  readonly bar = element("div", "player", { role: "group", "aria-label": "Fold" });
  private readonly button = element("button", "play", { type: "button" });
  private readonly slider = element("input", "", { type: "range", min: "0", max: "1", step: "0.001" });
  private readonly reading = element("output", "reading");
  private readonly journey: Journey;
  private request = 0;
  private time = 0;
  private direction = 1;
  private last = 0;
  share = 1;

  constructor(private readonly stops: Stop[], private readonly fold: (share: number) => void) {
    this.journey = new Journey(stops);
    this.slider.setAttribute("aria-label", wayOf(stops));
    const ends = stops.map((stop) => this.end(stop));
    const track = element("div", "track");
    track.append(this.slider);
    if (ends.length > 2) {
      const mark = element("span", "stop-mark");
      track.append(mark, ends[1]!);
      track.style.setProperty("--at", String(stops[1]!.share));
    }
    this.bar.append(this.button, ends[0]!, track, ends.at(-1)!, this.reading);
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

  /** Stay at the target, or move again. */
  hold(on: boolean): void {
    if (on) {
      this.stop();
      this.set(targetShare(this.stops));
    }
    this.bar.inert = on;
  }

  toggle(): void {
    if (this.bar.inert) return;
    if (this.request) {
      this.stop();
      return;
    }
    // From where it stands, towards the farther end if it stands at one.
    this.direction = this.share >= 1 ? -1 : 1;
    this.time = this.journey.timeOf(this.share);
    this.last = 0;
    this.request = requestAnimationFrame(this.step);
    this.name();
  }

  stop(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
    this.name();
  }

  private end({ label, share }: Stop): HTMLElement {
    const button = element("button", "end", { type: "button" }, label);
    button.addEventListener("click", () => {
      this.stop();
      this.set(share);
    });
    return button;
  }

  private readonly step = (now: number): void => {
    const passed = this.last ? Math.min(now - this.last, 100) : 0;
    this.last = now;
    this.time += (this.direction * passed) / DURATION;
    if (this.time > this.journey.length + REST) this.direction = -1;
    if (this.time < -REST) this.direction = 1;
    this.set(this.journey.shareAt(this.time));
    this.request = requestAnimationFrame(this.step);
  };

  private name(): void {
    this.button.classList.toggle("playing", this.request !== 0);
    this.button.setAttribute("aria-label", this.request ? "Pause" : "Play");
    this.button.title = this.request ? "Pause" : "Play";
  }
}
