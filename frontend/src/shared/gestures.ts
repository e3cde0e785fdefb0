// Pointer, wheel and keys on a plane picture.

export interface Gestures {
  pan(dx: number, dy: number): void;
  zoom(factor: number, x?: number, y?: number): void;
  fit(): void;
  hover(x: number | null, y?: number): void;
}

export class PatternGestures {
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private readonly end = new AbortController();

  constructor(private readonly element: HTMLElement, private readonly act: Gestures) {
    element.style.touchAction = "none";
    const options = { signal: this.end.signal };
    element.addEventListener("pointerdown", (event) => {
      element.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, this.place(event));
      if (event.pointerType === "touch") this.act.hover(...this.pair(event));
    }, options);
    element.addEventListener("pointermove", (event) => this.move(event), options);
    for (const name of ["pointerup", "pointercancel"] as const) {
      element.addEventListener(name, (event) => this.pointers.delete(event.pointerId), options);
    }
    element.addEventListener("pointerleave", () => act.hover(null), options);
    element.addEventListener("dblclick", () => act.fit(), options);
    element.addEventListener("wheel", (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      act.zoom(Math.exp(-0.0016 * lines * event.deltaY), ...this.pair(event));
    }, { ...options, passive: false });
    element.addEventListener("keydown", (event) => this.key(event), options);
  }

  dispose(): void {
    this.end.abort();
  }

  private move(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    const now = this.place(event);
    if (!before) {
      this.act.hover(now.x, now.y);
      return;
    }
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      const was = Math.hypot(before.x - other.x, before.y - other.y), is = Math.hypot(now.x - other.x, now.y - other.y);
      this.act.zoom(is / Math.max(was, 1), (now.x + other.x) / 2, (now.y + other.y) / 2);
      this.act.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    } else {
      this.act.pan(now.x - before.x, now.y - before.y);
    }
    this.pointers.set(event.pointerId, now);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const pans: Record<string, [number, number]> = {
      ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40],
    };
    const pan = pans[event.key];
    if (pan) this.act.pan(...pan);
    else if (event.key === "+" || event.key === "=") this.act.zoom(1.25);
    else if (event.key === "-") this.act.zoom(0.8);
    else if (event.key === "0" || event.key === "Home") this.act.fit();
    else return;
    event.preventDefault();
  }

  private place(event: MouseEvent): { x: number; y: number } {
    const box = this.element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private pair(event: MouseEvent): [number, number] {
    const { x, y } = this.place(event);
    return [x, y];
  }
}
