// A curve in its plane, with control points that can be dragged.

import { h, s, setAttribute } from "./dom.ts";
import { pretty, roundTo } from "./numbers.ts";
import { Plane, boxOf } from "./plane.ts";
import type { CurveName, Point } from "./types.ts";

export interface PlotEvents {
  /** A control point is moved; `gesture` names the motion for the history. */
  moved(index: number, to: Point, gesture: string): void;
  released(): void;
  added(at: Point): void;
  removed(index: number): void;
  selected(index: number | null): void;
}

/** A control point moves by this share of a grid step with an arrow key. */
const NUDGE = 1 / 20;

export class CurvePlot {
  readonly element: HTMLElement;
  private readonly svg: SVGSVGElement;
  private readonly plane = new Plane();
  private readonly grid = s("g", { class: "plot-grid" });
  private readonly labels = s("g", { class: "plot-labels" });
  private readonly line = s("path", { class: "plot-line" });
  private readonly control = s("path", { class: "plot-control" });
  private readonly handles = s("g", {});
  private circles: SVGGElement[] = [];
  private samples: Point[] = [];
  private points: Point[] = [];
  private wantsFit = true;
  private dragging: number | null = null;
  private held = false;

  constructor(
    private readonly name: CurveName,
    label: string,
    private readonly events: PlotEvents,
  ) {
    const arrow = `arrow-${name}`;
    this.line.setAttribute("marker-end", `url(#${arrow})`);
    this.svg = s(
      "svg",
      {
        class: "plot",
        role: "group",
        tabindex: 0,
        "aria-label": label,
        "data-testid": `curve-${name}`,
      },
      s(
        "defs",
        {},
        s(
          "marker",
          { id: arrow, viewBox: "0 0 8 8", refX: 6, refY: 4, markerWidth: 7, markerHeight: 7, orient: "auto" },
          s("path", { d: "M0.5 0.5 7 4 0.5 7.5Z", class: "plot-arrow" }),
        ),
      ),
      this.grid,
      this.labels,
      this.control,
      this.line,
      this.handles,
    );
    this.element = h("div", { class: `plot-frame curve-${name}` }, this.svg);
    this.listen();
    new ResizeObserver(() => this.resized()).observe(this.element);
  }

  /** Draw a curve through close samples, and its control points if it has any. */
  show(samples: Point[], points: Point[]): void {
    this.samples = samples;
    this.points = points;
    const box = boxOf(samples.length ? samples : points);
    if (box && !this.held) {
      const follow = this.wantsFit || (!points.length && !this.plane.suits(box));
      if (follow && samples.length) {
        this.plane.fit(box);
        this.wantsFit = false;
      }
    }
    this.draw();
  }

  /** Fit the view to the curve when it is drawn next. */
  refit(): void {
    this.wantsFit = true;
  }

  fit(): void {
    const box = boxOf([...this.samples, ...this.points]);
    if (box) this.plane.fit(box);
    this.draw();
  }

  zoom(factor: number, about?: Point): void {
    this.plane.zoom(factor, about);
    this.draw();
  }

  select(index: number | null): void {
    this.circles.forEach((each, i) => each.classList.toggle("selected", i === index));
  }

  focus(index: number): void {
    this.circles[index]?.focus();
  }

  private resized(): void {
    const { width, height } = this.element.getBoundingClientRect();
    if (!width || !height) return;
    const grown = width / this.plane.width;
    this.plane.width = width;
    this.plane.height = height;
    if (Math.abs(grown - 1) > 0.01) this.fit();
    else this.draw();
  }

  private draw(): void {
    const { width, height } = this.plane;
    setAttribute(this.svg, "viewBox", `0 0 ${width} ${height}`);
    this.drawGrid();
    this.line.setAttribute("d", this.path(this.samples));
    this.control.setAttribute("d", this.path(this.points));
    this.drawHandles();
  }

  private path(points: Point[]): string {
    const pixels = points.map((point) => this.plane.toPixels(point));
    return pixels.length
      ? `M${pixels.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`
      : "";
  }

  private drawGrid(): void {
    const { plane } = this;
    const { step, width, height } = plane;
    const lines: Node[] = [];
    const texts: Node[] = [];
    for (const value of plane.ticks(0, step)) {
      const [x] = plane.toPixels([value, 0]);
      const kind = Math.abs(value) < step / 1e6 ? "axis" : "";
      lines.push(s("path", { d: `M${x.toFixed(1)} 0V${height}`, class: kind }));
      if (x > 30 && x < width - 14) {
        texts.push(s("text", { x, y: height - 5, "text-anchor": "middle" }, tick(value, step)));
      }
    }
    for (const value of plane.ticks(1, step)) {
      const [, y] = plane.toPixels([0, value]);
      const kind = Math.abs(value) < step / 1e6 ? "axis" : "";
      lines.push(s("path", { d: `M0 ${y.toFixed(1)}H${width}`, class: kind }));
      if (y > 8 && y < height - 16) texts.push(s("text", { x: 5, y: y + 3.5 }, tick(value, step)));
    }
    this.grid.replaceChildren(...lines);
    this.labels.replaceChildren(...texts);
  }

  private drawHandles(): void {
    while (this.circles.length > this.points.length) this.circles.pop()!.remove();
    while (this.circles.length < this.points.length) this.addHandle(this.circles.length);
    this.points.forEach((point, i) => {
      const [x, y] = this.plane.toPixels(point);
      const handle = this.circles[i]!;
      handle.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
      const place = `x ${pretty(point[0], 4)}, y ${pretty(point[1], 4)}`;
      handle.setAttribute("aria-label", `${this.name}, point ${i + 1} of ${this.points.length}: ${place}`);
    });
  }

  private addHandle(index: number): void {
    const handle = s(
      "g",
      {
        class: "handle",
        tabindex: 0,
        role: "button",
        "aria-roledescription": "control point",
        "data-testid": `point-${this.name}-${index}`,
      },
      s("circle", { r: 13, class: "handle-reach" }),
      s("circle", { r: 5.5, class: "handle-dot" }),
    );
    handle.addEventListener("focus", () => this.events.selected(index));
    handle.addEventListener("keydown", (event) => this.pressed(event, index));
    handle.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.stopPropagation();
      event.preventDefault();
      handle.focus({ preventScroll: true });
      this.dragging = index;
      this.held = true;
      handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener("pointermove", (event) => {
      if (this.dragging !== index) return;
      const to = this.plane.fromPixels(this.pixels(event));
      const fine = 1 / this.plane.scale;
      this.events.moved(index, [roundTo(to[0], fine), roundTo(to[1], fine)], `drag-${this.name}-${index}!`);
    });
    const release = (): void => {
      if (this.dragging !== index) return;
      this.dragging = null;
      this.held = false;
      this.events.released();
    };
    handle.addEventListener("pointerup", release);
    handle.addEventListener("lostpointercapture", release);
    this.circles.push(handle);
    this.handles.append(handle);
  }

  private pressed(event: KeyboardEvent, index: number): void {
    const direction = ARROWS[event.key];
    if (direction && !event.ctrlKey && !event.metaKey) {
      const step = this.plane.step * NUDGE * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
      const [x, y] = this.points[index]!;
      const to: Point = [roundTo(x + direction[0] * step, step), roundTo(y + direction[1] * step, step)];
      this.events.moved(index, to, `nudge-${this.name}-${index}`);
    } else if (event.key === "Delete" || event.key === "Backspace") {
      this.events.removed(index);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  private listen(): void {
    const { svg } = this;
    let from: Point | null = null;
    svg.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 && event.button !== 1) return;
      from = [event.clientX, event.clientY];
      svg.setPointerCapture(event.pointerId);
    });
    svg.addEventListener("pointermove", (event) => {
      if (!from) return;
      this.plane.pan(event.clientX - from[0], event.clientY - from[1]);
      from = [event.clientX, event.clientY];
      this.draw();
    });
    const release = (): void => void (from = null);
    svg.addEventListener("pointerup", release);
    svg.addEventListener("lostpointercapture", release);
    svg.addEventListener("dblclick", (event) => {
      event.preventDefault();
      this.events.added(this.plane.fromPixels(this.pixels(event)));
    });
    svg.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        const lines = event.deltaMode === 1 ? 16 : 1;
        this.zoom(Math.exp(-event.deltaY * lines * 0.0015), this.pixels(event));
      },
      { passive: false },
    );
    svg.addEventListener("keydown", (event) => {
      if (event.target !== svg) return;
      const direction = ARROWS[event.key];
      if (direction) this.plane.pan(-24 * direction[0], 24 * direction[1]);
      else if (event.key === "+" || event.key === "=") this.plane.zoom(1.25);
      else if (event.key === "-") this.plane.zoom(0.8);
      else if (event.key === "0" || event.key === "Home") return this.fit();
      else return;
      event.preventDefault();
      this.draw();
    });
  }

  private pixels(event: MouseEvent): Point {
    const box = this.svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
}

const ARROWS: Record<string, Point> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

function tick(value: number, step: number): string {
  return pretty(roundTo(value, step), 5);
}
