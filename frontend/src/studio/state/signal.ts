// A value that can be watched.

export type Listener<T> = (value: T, before: T) => void;

export class Signal<T> {
  private readonly listeners = new Set<Listener<T>>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  set(value: T): void {
    const before = this.current;
    if (Object.is(before, value)) return;
    this.current = value;
    for (const listener of this.listeners) listener(value, before);
  }

  /** Call the listener at every change; returns a function that stops it. */
  watch(listener: Listener<T>): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** Call the listener now and at every change. */
  bind(listener: Listener<T>): () => void {
    listener(this.current, this.current);
    return this.watch(listener);
  }
}
