// How fine to draw: everything at rest, less while a slow machine moves things.

export interface Quality {
  /** Share of the screen's pixels along each side. */
  density: number;
  /** Samples of the shadow; 0 for none. */
  taps: number;
}

const QUALITIES: Quality[] = [
  { density: 0.5, taps: 0 },
  { density: 0.6, taps: 1 },
  { density: 0.75, taps: 2 },
  { density: 1, taps: 4 },
  { density: 1, taps: 12 },
];
const FINEST = QUALITIES.length - 1;
/** Frames that take longer (ms) are slow; frames farther apart belong to no motion. */
const SLOW = 26;
const PAUSE = 1500;

export class Pace {
  /** Times between the latest frames of a motion (ms). */
  readonly times: number[] = [];
  private last = -Infinity;
  private mean = 0;
  private run = 0;
  private moving = FINEST;
  private applied = FINEST;
  private timer = 0;

  /** `apply` sets the quality, `rest` draws once more at the finest. */
  constructor(private readonly apply: (quality: Quality) => void, private readonly rest: () => void) {}

  /** To be called at the begin of every frame. */
  step(now: number): void {
    const took = now - this.last;
    this.last = now;
    if (took < PAUSE) {
      this.times.push(took);
      if (this.times.length > 240) this.times.shift();
      this.run++;
      // The first frame after a rest pays for what was put off.
      if (this.run > 1) this.mean = this.mean ? 0.7 * this.mean + 0.3 * took : took;
      if (this.run > 3 && this.mean > SLOW && this.moving > 0) {
        this.moving = Math.max(0, this.moving - (this.mean > 4 * SLOW ? 2 : 1));
        this.run = 0;
        this.mean = 0;
      }
    } else {
      this.run = 0;
      this.mean = 0;
    }
    this.use(this.moving);
    clearTimeout(this.timer);
    if (this.applied !== FINEST) this.timer = window.setTimeout(this.settle, 250);
  }

  stop(): void {
    clearTimeout(this.timer);
  }

  private readonly settle = (): void => {
    this.use(FINEST);
    this.last = -Infinity;
    this.rest();
  };

  private use(quality: number): void {
    if (quality === this.applied) return;
    this.applied = quality;
    this.apply(QUALITIES[quality]!);
  }
}
