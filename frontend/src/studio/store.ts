// The state of the studio: the design with its history, and what is known of it.

import type { View } from "../shared/view.ts";
import { History } from "./history.ts";
import { Labels } from "./labels.ts";
import { Signal } from "./signal.ts";
import type { CurveName, CurveTable, Curves, Design, Fault, Info, Ranges, Report, Value } from "./types.ts";

export type Proof =
  | { state: "none" }
  | { state: "waiting" }
  | { state: "running"; share: number; what: string }
  /** `refusal`: panels meet before the shell locks, and what would mend it. */
  | { state: "done"; refusal: Fault | null }
  | { state: "failed"; fault: Fault };

/** What the shell on the screen is to the design. */
export type Freshness = "current" | "computing" | "outdated";

export class Store {
  readonly design: Signal<Design>;
  /** The design as it is in a file: as it was opened or saved last. */
  readonly saved: Signal<Design>;
  /** The name that files get. */
  readonly name = new Signal("shell");
  readonly view = new Signal<View | null>(null);
  readonly report = new Signal<Report | null>(null);
  readonly curves = new Signal<Curves | null>(null);
  readonly ranges = new Signal<Ranges>({});
  readonly fault = new Signal<Fault | null>(null);
  readonly proof = new Signal<Proof>({ state: "none" });
  readonly freshness = new Signal<Freshness>("computing");
  /** Sizes are being chosen: what is done, in words. */
  readonly busy = new Signal<string | null>(null);
  /** What was done, in a few words, for a moment. */
  readonly said = new Signal("");
  /** Files that are being read or written. */
  readonly files = new Signal(0);
  /** Changes when undo or redo become possible or impossible. */
  readonly steps = new Signal(0);
  /** Time stamp of the input event that made the present design. */
  changedAt = performance.now();

  /** Keys in the words of the page. */
  readonly labels: Labels;
  private readonly history: History<Design>;

  constructor(
    readonly info: Info,
    first: Design,
  ) {
    this.history = new History(first);
    this.design = new Signal(first);
    this.saved = new Signal(first);
    this.labels = new Labels(info.families, () => this.design.value.shell.family);
  }

  /** Whether the design is in no file. */
  get unsaved(): boolean {
    return !Object.is(this.design.value, this.saved.value);
  }

  get undoable(): string | null {
    return this.history.undoable;
  }

  get redoable(): string | null {
    return this.history.redoable;
  }

  /** Take a new design as a step of the history; see History.push for gestures. */
  change(design: Design, what: string, gesture = ""): void {
    if (Object.is(design, this.history.value)) return;
    this.changedAt = eventTime();
    this.history.push(design, what, gesture);
    this.publish();
  }

  rest(): void {
    this.history.rest();
  }

  undo(): void {
    this.changedAt = eventTime();
    if (this.history.undo()) this.publish();
  }

  redo(): void {
    this.changedAt = eventTime();
    if (this.history.redo()) this.publish();
  }

  setPattern(key: string, value: Value | undefined, gesture = ""): void {
    const design = this.design.value;
    const pattern = { ...design.pattern };
    if (value === undefined) delete pattern[key];
    else pattern[key] = value;
    this.change({ ...design, pattern }, this.labels.of(key), gesture);
  }

  setCurve(name: CurveName, table: CurveTable, what: string, gesture = ""): void {
    const design = this.design.value;
    this.change({ ...design, target: { ...design.target, [name]: table } }, what, gesture);
  }

  private publish(): void {
    this.design.set(this.history.value);
    this.steps.set(this.steps.value + 1);
  }
}

function eventTime(): number {
  const event = window.event;
  return event ? event.timeStamp : performance.now();
}
