// Undo and redo over values that are replaced, never changed.

/** Changes of one gesture (a drag, a slider's motion, typing in a box) are one step. */
const PAUSE = 1000;
const DEPTH = 200;

interface Step<T> {
  value: T;
  what: string;
}

export class History<T> {
  private readonly past: Step<T>[] = [];
  private readonly future: Step<T>[] = [];
  private gesture = "";
  private last = 0;

  constructor(private present: T) {}

  get value(): T {
    return this.present;
  }

  /** What undo would take back, or null. */
  get undoable(): string | null {
    return this.past.at(-1)?.what ?? null;
  }

  get redoable(): string | null {
    return this.future.at(-1)?.what ?? null;
  }

  /**
   * Take a new value.
   *
   * `gesture` names what the user is at: changes with the same name that follow each other
   * within a second are one step; a name that ends in "!" holds until `rest`.
   */
  push(value: T, what: string, gesture = "", now = performance.now()): void {
    const held = gesture.endsWith("!");
    const same = gesture !== "" && gesture === this.gesture && (held || now - this.last < PAUSE);
    if (!same) {
      this.past.push({ value: this.present, what });
      if (this.past.length > DEPTH) this.past.shift();
    }
    this.present = value;
    this.future.length = 0;
    this.gesture = gesture;
    this.last = now;
  }

  /** The gesture is over: the next change is a step of its own. */
  rest(): void {
    this.gesture = "";
  }

  undo(): boolean {
    return this.move(this.past, this.future);
  }

  /** Undo until a value is the present one again, if it was. */
  undoTo(value: T): boolean {
    if (!this.past.some((step) => step.value === value)) return false;
    while (this.present !== value) this.undo();
    return true;
  }

  redo(): boolean {
    return this.move(this.future, this.past);
  }

  private move(from: Step<T>[], to: Step<T>[]): boolean {
    const step = from.pop();
    if (!step) return false;
    to.push({ value: this.present, what: step.what });
    this.present = step.value;
    this.rest();
    return true;
  }
}
