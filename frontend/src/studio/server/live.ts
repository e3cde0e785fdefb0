// Keeps the shell on the screen up with the design: requests as flights.ts lets them begin, the newest
// one waiting; when the design rests, its ranges and its proof.

import { decodeView } from "../../shared/view.ts";
import { aimOf, inFamily, isAuto, isFitted, isSlow } from "../state/aims.ts";
import { compareFamilies, decodeBytes, decodeFloats, fetchRanges, fitView, verify } from "./api.ts";
import { isWhole } from "../curves/curve-table.ts";
import { fetchView } from "./early-view.ts";
import { ServerFault, faultOf } from "../state/faults.ts";
import { Flights } from "./flights.ts";
import { leaveOpen } from "./left-open.ts";
import { isSameShell, settled } from "../state/sizing.ts";
import { isOfFile } from "../state/stale.ts";
import { STATES, allStates, liveStates } from "./states.ts";
import { isFound, type Store } from "../state/store.ts";
import type { Design, Report, Verified } from "../state/types.ts";

/** Rest after which ranges and the proof are asked for, in milliseconds. */
const REST = 400;
/** Rest after which a sheet is fitted to its surface anew, in milliseconds: a fit takes seconds. */
const PAUSE = 250;
/** A server that does not answer is asked again after so many milliseconds. */
const AGAIN = 2000;

interface Pending {
  design: Design;
  changedAt: number;
  states: number;
  /** Not to be asked for before. */
  from: number;
}

export class Live {
  /** From the input event to the frame that shows its shell, in milliseconds, newest last. */
  readonly latencies: number[] = [];
  private readonly flights = new Flights();
  private pending: Pending | null = null;
  private turn = 0;
  private sequence = 0;
  /** The newest that has been drawn, or refused. */
  private drawn = 0;
  private timer = 0;
  private resting = false;
  /** What was proved last, or was to be. */
  private proved: Pending | null = null;
  /** Whether the next proof has more time. */
  private patient = false;
  private design = new AbortController();
  private rested = new AbortController();

  constructor(
    private readonly store: Store,
    /** Draws the store's view; resolves when its frame has been drawn. */
    private readonly draw: () => Promise<void>,
  ) {
    store.design.watch((design, before) => {
      if (!isSameShell(design, before)) this.changed();
    });
  }

  /** Nothing is under way or waiting. */
  get idle(): boolean {
    return !this.flights.under && !this.pending && !this.timer && !this.resting;
  }

  /** The design has changed, or is to be computed again. */
  changed(): void {
    this.sequence++;
    this.design.abort();
    this.stopResting();
    this.patient = false;
    const { store } = this;
    store.proof.set({ state: "none" });
    store.busy.set(null);  // a search for sizes is broken off
    store.fitting.set(null);  // and so is a fit
    store.trials.set(null);
    if (!isWhole(store.design.value)) {
      // A curve is being drawn: there is no shell.
      store.report.set(null);
      store.view.set(null);
    }
    if (!isWhole(store.design.value) || store.design.value.tolerance) {
      // A curve is being drawn; or sizes are chosen, at the user's word: the search takes seconds.
      this.pending = null;
      store.fault.set(null);
      store.freshness.set("outdated");
      return;
    }
    const design = store.design.value;
    this.request({ design, changedAt: store.changedAt, states: liveStates(design), from: isSlow(design) ? performance.now() + PAUSE : 0 });
  }

  /** Fit the sheet again, after it was stopped. */
  again(): void {
    const design = this.store.design.value;
    this.sequence++;
    this.request({ design, changedAt: performance.now(), states: liveStates(design), from: 0 });
  }

  /** Choose rows and columns by the tolerance. */
  choose(): void {
    this.sequence++;
    this.stopResting();
    this.store.busy.set("Choosing rows and columns");
    this.request({ design: this.store.design.value, changedAt: performance.now(), states: STATES, from: 0 });
  }

  /** Break off what is under way. */
  cancel(): void {
    this.sequence++;
    this.pending = null;
    this.design.abort();
    this.store.busy.set(null);
    this.store.fitting.set(null);
    this.store.freshness.set("outdated");
  }

  /** Break off the proof; the shell stays. */
  stopProof(): void {
    this.stopResting();
    this.store.proof.set({ state: "stopped" });
  }

  /** Prove the shell that is shown, after that was stopped, or took too long: then it has more time. */
  proveAgain(): void {
    this.patient = this.store.proof.value.state === "late";
    this.restLater(this.proved);
  }

  private request(pending: Pending): void {
    this.pending = pending;
    this.store.freshness.set("computing");
    void this.advance();
  }

  /** Ask for what is waiting, as soon as another request may begin. */
  private async advance(): Promise<void> {
    clearTimeout(this.turn);
    if (!this.pending) return;
    const now = performance.now();
    const wait = Math.max(this.flights.wait(now), this.pending.from - now);
    if (wait > 0) {
      if (wait < Infinity) this.turn = window.setTimeout(() => void this.advance(), wait);
      return;
    }
    const next = this.pending;
    this.pending = null;
    this.flights.begin(performance.now());
    try {
      await this.compute(next, this.sequence);
    } finally {
      this.flights.end();
    }
    void this.advance();
  }

  private async compute(next: Pending, sequence: number): Promise<void> {
    const { store } = this;
    // A quick request runs to its end, so that a drag shows every answer that comes in time; the
    // search for sizes is broken off by the next change.
    this.design = new AbortController();
    const signal = next.design.tolerance || isSlow(next.design) ? this.design.signal : undefined;
    try {
      const bytes = await this.answered(next, signal);
      if (this.overtaken(next, sequence)) return;
      this.drawn = sequence;
      this.take(bytes);
      if (!isOfFile(store.fault.value)) store.fault.set(null);
      store.busy.set(null);
      store.fitting.set(null);
      const newest = sequence === this.sequence;
      if (newest) {
        store.freshness.set("current");
        this.restLater(next);
      }
      // Waited for: where painting is slow, requests keep its pace.
      await this.draw();
      this.latencies.push(performance.now() - next.changedAt);
      if (this.latencies.length > 1000) this.latencies.shift();
    } catch (error) {
      if (signal?.aborted || sequence !== this.sequence) return;
      this.drawn = sequence;
      this.failed(error);
    }
  }

  /** The view of a design, in the best family if that is to be chosen. */
  private async answered(asked: Pending, signal?: AbortSignal): Promise<ArrayBuffer> {
    if (!isAuto(asked.design)) return this.viewed(asked, signal);
    const { trials, fitting, info } = this.store;
    fitting.set({ share: 0, what: "trying the families" });
    trials.set({ tried: [], family: null });
    const { tried, family } = await compareFamilies(
      asked.design,
      signal!,
      (share, what) => signal!.aborted || fitting.set({ share, what }),
      (tried) => signal!.aborted || trials.set({ tried, family: null }),
    );
    if (signal!.aborted) throw signal!.reason;
    trials.set({ tried, family });
    return this.viewed({ ...asked, design: inFamily(info, asked.design, family) }, signal);
  }

  /** The view of a design; of one that is fitted, coarser ones are drawn on the way. */
  private async viewed({ design, states }: Pending, signal?: AbortSignal): Promise<ArrayBuffer> {
    const { store } = this;
    if (!isFitted(design)) {
      const begun = performance.now();
      const { bytes, server } = await fetchView(design, states, signal);
      this.flights.answered(performance.now() - begun, server);
      return bytes;
    }
    store.fitting.set({ share: 0, what: "fitting the sheet" });
    return fitView(
      design,
      states,
      signal!,
      (share, what) => signal!.aborted || store.fitting.set({ share, what }),
      (coarse) => {
        if (signal!.aborted) return;
        this.take(coarse);
        void this.draw();
      },
    );
  }

  private take(bytes: ArrayBuffer): void {
    const { store } = this;
    const view = decodeView(bytes);
    store.curves.set(view.header.curves ?? store.curves.value);
    leaveOpen(view);
    store.report.set(view.header.report as Report);
    store.view.set(view);
  }

  /** An answer to an older design is still drawn during a drag, but not once things have moved on
   * by other means (another family, an opened file), where it would flash up. */
  private overtaken(next: Pending, sequence: number): boolean {
    if (sequence === this.sequence) return false;
    if (sequence < this.drawn) return true;
    const now = this.store.design.value;
    return (
      now.shell !== next.design.shell ||
      aimOf(now) !== aimOf(next.design) ||
      now.tolerance !== next.design.tolerance ||
      this.store.design.value.pattern["rows"] !== next.design.pattern["rows"] ||
      this.store.design.value.pattern["columns"] !== next.design.pattern["columns"]
    );
  }

  private failed(error: unknown): void {
    const { store } = this;
    store.busy.set(null);
    store.fitting.set(null);
    store.freshness.set("outdated");
    if (error instanceof ServerFault && error.curves) store.curves.set(error.curves);
    const fault = faultOf(error);
    store.refused.set(error instanceof ServerFault ? error.drawing : null);
    store.fault.set(fault);
    // What would be admissible is worth knowing just then.
    if (fault.kind === "design") this.restLater(null);
    if (fault.kind === "network") this.tryAgain(this.sequence);
  }

  /** Ask until the server is back, or the design changes. */
  private tryAgain(sequence: number): void {
    window.setTimeout(() => {
      if (sequence !== this.sequence) return;
      // Older requests have not ended yet.
      if (this.flights.under) return this.tryAgain(sequence);
      const design = this.store.design.value;
      if (design.tolerance) return this.choose();
      this.request({ design, changedAt: performance.now(), states: liveStates(design), from: 0 });
    }, AGAIN);
  }

  private restLater(shown: Pending | null): void {
    if (shown) this.store.proof.set({ state: "waiting" });
    this.proved = shown;
    this.stopResting();
    this.timer = window.setTimeout(() => void this.rest(shown), REST);
  }

  private stopResting(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    this.rested.abort();
    this.resting = false;
  }

  /** The design has rested: all states, the ranges, the proof. */
  private async rest(shown: Pending | null): Promise<void> {
    this.timer = 0;
    this.resting = true;
    this.rested = new AbortController();
    const { signal } = this.rested;
    const design = this.store.design.value;
    const all = allStates(design);
    const refined = shown && !design.tolerance && !isSlow(design) && shown.states < all ? this.refine(design, all, signal) : null;
    try {
      await Promise.all([
        // Of a fitted sheet every value that is tried would be a fit.
        design.tolerance || isSlow(design) ? this.store.ranges.set({}) : this.findRanges(design, signal),
        refined,
        shown ? this.prove(settled(this.store.info, design, this.store.report.value), signal) : this.mend(design, signal),
      ]);
    } finally {
      if (!signal.aborted) this.resting = false;
    }
  }

  private async refine(design: Design, states: number, signal: AbortSignal): Promise<void> {
    const before = this.store.view.value;
    try {
      const view = decodeView((await fetchView(design, states, signal)).bytes);
      // The proof may have come first, with a shell of its own: other flaps, or boards as cut.
      if (signal.aborted || this.store.view.value !== before) return;
      leaveOpen(view);
      // The proof may have come first: what it found is kept.
      if (isFound(this.store.proof.value)) {
        view.header.report = this.store.report.value!;
        view.header.contact = this.store.view.value!.header.contact;
        const known = this.store.view.value!.distance;
        if (known) view.distance = known;
      }
      this.store.view.set(view);
      await this.draw();
    } catch (error) {
      if (!(error instanceof ServerFault) && !signal.aborted) throw error;
      // The shell with fewer states stays: it is exact, only its motion is coarser.
    }
  }

  private async findRanges(design: Design, signal: AbortSignal): Promise<void> {
    try {
      const ranges = await fetchRanges(design, signal);
      if (!signal.aborted) this.store.ranges.set(ranges);
    } catch (error) {
      if (signal.aborted) return;
      if (!(error instanceof ServerFault)) throw error;
      this.store.ranges.set({});
    }
  }

  /** Of a design that cannot be made: find what would work, by trying it. */
  private async mend(design: Design, signal: AbortSignal): Promise<void> {
    const { fault } = this.store, asked = fault.value;
    // What no family makes, has a reason for each.
    if (!asked || isOfFile(asked) || isAuto(design)) return;
    fault.set({ ...asked, searching: true });
    try {
      await verify(design, signal, () => undefined);
      if (!signal.aborted) fault.set({ ...asked, searching: false });
    } catch (error) {
      if (signal.aborted) return;
      if (!(error instanceof ServerFault)) throw error;
      fault.set(error.fault.kind === "design" ? error.fault : { ...asked, searching: false });
    }
  }

  private async prove(design: Design, signal: AbortSignal): Promise<void> {
    const { store } = this;
    let found = false, what = "verifying";
    const running = (share: number): void => store.proof.set({ state: "running", share, what, found });
    running(0);
    try {
      const result = await verify(
        design,
        signal,
        (share, now) => {
          what = now;
          if (!signal.aborted) running(share);
        },
        (known) => {
          if (signal.aborted) return;
          void this.show(known);
          found = true;
          running(0);
        },
        this.patient,
      );
      if (signal.aborted) return;
      await this.show(result);
      if (signal.aborted) return;
      const { refusal, sizes, mendable } = result;
      store.proof.set({ state: "done", sizes, mendable, refusal: refusal && { ...refusal, searching: false } });
    } catch (error) {
      if (signal.aborted) return;
      const fault = faultOf(error);
      store.proof.set(fault.kind === "time" ? { state: "late", fault, what, found } : { state: "failed", fault });
      if (fault.kind === "network") this.tryAgain(this.sequence);
    }
  }

  /** Show what is known of the shell. */
  private async show(known: Verified): Promise<void> {
    const { store } = this;
    // Flaps that the program chooses may have become narrower: then there is another shell.
    const other = known.view ? decodeView(decodeBytes(known.view)) : null;
    const view = other ?? store.view.value!;
    view.header.report = known.report;
    view.header.contact = known.contact;
    if (known.distance) view.distance = decodeFloats(known.distance);
    store.report.set(known.report);
    if (!other) return;
    store.view.set(other);
    await this.draw();
  }
}
