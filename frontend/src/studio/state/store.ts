// The state of the studio: the design with its history, and what is known of it.

import type { BuiltSizes, FamilyTrial, Mendable, RefusedDrawing } from "../../shared/api-types.ts";
import type { View } from "../../shared/view.ts";
import type { DrawnSurface } from "../surface/drawn-surface.ts";
import { Left } from "./aims.ts";
import { changed } from "./changed.ts";
import { History } from "./history.ts";
import { Labels } from "./labels.ts";
import { type Home, type Named, type Work, isUnsaved, workOf } from "./named.ts";
import { Signal } from "./signal.ts";
import { keptSwitch } from "./storage.ts";
import type { CurveName, CurveTable, Curves, Design, Fault, Info, Ranges, Report, SurfaceTable, Value } from "./types.ts";

export type Proof =
  | { state: "none" }
  | { state: "waiting" }
  /** `found`: whether the report has what was proved so far. */
  | { state: "running"; share: number; what: string; found: boolean }
  /** `refusal`: panels meet before the shell locks, and what would mend it. */
  | { state: "done"; refusal: Fault | null; sizes: BuiltSizes; mendable: readonly Mendable[] }
  | { state: "failed"; fault: Fault }
  /** Its time was over: `what` was being done; `found` as above. */
  | { state: "late"; fault: Fault; what: string; found: boolean }
  | { state: "stopped" };

/** Whether the report has what was proved, all of it or the first of it. */
export function isFound(proof: Proof): boolean {
  return proof.state === "done" || ("found" in proof && proof.found);
}

/** What the shell on the screen is to the design. */
export type Freshness = "current" | "computing" | "outdated";

export class Store {
  readonly design: Signal<Design>;
  /** What was saved last. */
  readonly saved = new Signal<Work | null>(null);
  /** What was not saved when another design took its place. */
  readonly replaced = new Signal<Work | null>(null);
  /** Of the design that is open: another one where another design is opened, or brought back. */
  readonly home: Signal<Home>;
  /** The name that files get; undo brings it back with its design. */
  readonly name: Signal<string>;
  readonly view = new Signal<View | null>(null);
  readonly report = new Signal<Report | null>(null);
  readonly curves = new Signal<Curves | null>(null);
  readonly ranges = new Signal<Ranges>({});
  readonly fault = new Signal<Fault | null>(null);
  /** The drawn sheet that the fault is of. */
  readonly refused = new Signal<RefusedDrawing | null>(null);
  readonly proof = new Signal<Proof>({ state: "none" });
  readonly freshness = new Signal<Freshness>("computing");
  /** The target surface as it is drawn, and the table that it was drawn of. */
  readonly surface = new Signal<DrawnSurface | null>(null);
  readonly surfaceAt = new Signal<SurfaceTable | null>(null);
  /** A sheet is being fitted: how far that is. */
  readonly fitting = new Signal<{ share: number; what: string } | null>(null);
  /** What the families make of the target, as far as they were tried, and the one that is taken. */
  readonly trials = new Signal<{ tried: readonly FamilyTrial[]; family: string | null } | null>(null);
  /** Sizes are being chosen: what is done, in words. */
  readonly busy = new Signal<string | null>(null);
  /** A variant that is pointed at among others. */
  readonly pointed = new Signal<Design | null>(null);
  /** Whether a person stands beside the shell, for its size. */
  readonly figure = keptSwitch("orishell.figure", true);
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
  /** What the design was before it followed something else, or in another family. */
  readonly left: Left;
  private readonly history: History<Work>;

  constructor(
    readonly info: Info,
    first: Named | Work,
  ) {
    this.history = new History(workOf(first));
    this.home = new Signal(this.named.home);
    this.design = new Signal(first.design);
    this.name = new Signal(first.name);
    this.left = new Left(this.design);
    this.labels = new Labels(info.families, info.tables, () => this.design.value.shell);
    this.fault.watch((fault) => void (fault || this.refused.set(null)));
  }

  get named(): Work {
    return this.history.value;
  }

  get unsaved(): boolean {
    return isUnsaved(this.named);
  }

  get undoable(): string | null {
    return this.history.undoable;
  }

  get redoable(): string | null {
    return this.history.redoable;
  }

  /** Take a new design as a step of the history; see History.push for gestures. */
  change(design: Design, what: string, gesture = ""): void {
    if (Object.is(design, this.history.value.design)) return;
    this.push({ ...this.named, design }, what, gesture);
  }

  /** Take another design, with its own name, in place of the present one; what is no work yet is as
   * it is in a file, or in a link. */
  open(opened: Named | Work, what = `open ${opened.name}`): void {
    // A copy: the same may be replaced twice.
    if (this.unsaved) this.replaced.set({ ...this.named });
    this.push(workOf(opened), what);
  }

  /** A design, this one or an earlier one, is in a file now. */
  save(work: Work): void {
    work.home.file = work;
    this.saved.set({ ...work });
  }

  rename(name: string): void {
    if (name !== this.name.value) this.push({ ...this.named, name }, "name", "name");
  }

  rest(): void {
    this.history.rest();
  }

  undo(): void {
    this.changedAt = eventTime();
    if (this.history.undo()) this.publish();
  }

  /** Undo all that was done since the design was this one. */
  backTo(work: Work): void {
    this.changedAt = eventTime();
    if (this.history.undoTo(work)) this.publish();
  }

  redo(): void {
    this.changedAt = eventTime();
    if (this.history.redo()) this.publish();
  }

  /** Change values of the design by their keys, the tables in front of them. */
  set(values: Record<string, unknown>, what: string, gesture = ""): void {
    this.change(changed(this.design.value, values), what, gesture);
  }

  setPattern(key: string, value: Value | undefined, gesture = ""): void {
    this.set({ [`pattern.${key}`]: value }, this.labels.of(key), gesture);
  }

  setCurve(name: CurveName, table: CurveTable, what: string, gesture = ""): void {
    this.set({ [`target.${name}`]: table }, what, gesture);
  }

  private push(named: Work, what: string, gesture = ""): void {
    this.changedAt = eventTime();
    this.history.push(named, what, gesture);
    this.publish();
  }

  private publish(): void {
    // First its home and name: who hears of the design may ask for them.
    this.home.set(this.history.value.home);
    this.name.set(this.history.value.name);
    this.design.set(this.history.value.design);
    this.steps.set(this.steps.value + 1);
  }
}

function eventTime(): number {
  const event = window.event;
  return event ? event.timeStamp : performance.now();
}
