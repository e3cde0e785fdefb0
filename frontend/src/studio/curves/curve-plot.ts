// A curve in its plane: shown, dragged by its handles, drawn anew.

import { button } from "../parts/controls.ts";
import { h, s, setAttribute } from "../parts/dom.ts";
import { type DrawEvents, Drawing } from "./drawing.ts";
import { Plane, boxOf } from "./plane.ts";
import { gridOf, guidesOf, line } from "./plot-grid.ts";
import { ARROWS, type Handle, type HandleEvents, PlotHandles } from "./plot-handles.ts";
import { type Caught, caught } from "./snapping.ts";
import type { CurveName, Point } from "../state/types.ts";

export interface PlotEvents extends HandleEvents, DrawEvents {
  /** The curve is to be drawn anew. */
  wanted(): void;
  /** A point is wanted where the curve is nearest. */
  added(at: Point): void;
  /** What is in view with the curve. */
  beside(): Point[];
  /** What stands behind the curve. */
  backdrop(plane: Plane): Node[];
}

export interface Shown {
  /** Close samples of the curve. */
  samples: Point[];
  handles: Handle[];
  /** Whether the samples are those of an earlier curve, until the server has answered. */
  stale: boolean;
  /** Whether handles are joined by a line in their order. */
  joined: boolean;
  /** What to do where there is no curve yet, how wide the plane then is, and how high y = 0 lies in it
   * (a share). */
  blank: { words: string; width: number; level: number } | null;
}

/** From how far points are caught, in pixels. */
const REACH = { mouse: 7, touch: 12 };
const NOTHING_YET = "Nothing is drawn yet: press Draw.";
const ONE_POINT = "One point is no curve yet: press Draw, or undo.";
const HOW_TO_DRAW = matchMedia("(pointer: coarse)").matches
  ? "tap point by point, or draw a stroke."
  : "click point by point, or draw a stroke; Enter ends.";

export class CurvePlot {
  readonly element: HTMLElement;
  readonly drawing: Drawing;
  private readonly svg: SVGSVGElement;
  private readonly plane = new Plane();
  private readonly backdrop = s("g", {});
  private readonly grid = s("g", { class: "plot-grid" });
  private readonly labels = s("g", { class: "plot-labels" });
  private readonly line = s("path", { class: "plot-line" });
  private readonly control = s("path", { class: "plot-control" });
  private readonly guides = s("path", { class: "plot-guide" });
  private readonly hint = h("p", { class: "plot-hint", hidden: true });
  private readonly handles: PlotHandles;
  private shown: Shown = { samples: [], stale: false, handles: [], joined: false, blank: null };
  private wantsFit = true;
  /** Where a point is caught. */
  private words = "";

  constructor(
    name: CurveName,
    label: string,
    private readonly events: PlotEvents,
  ) {
    const arrow = `arrow-${name}`;
    this.line.setAttribute("marker-end", `url(#${arrow})`);
    const place = {
      plane: this.plane,
      pixels: (event: MouseEvent): Point => this.pixels(event),
      free: (): void => this.free(),
    };
    this.handles = new PlotHandles(name, { ...place, catch: (at, index, event) => this.catchHandle(at, index, event) }, events);
    this.svg = s(
      "svg",
      { class: "plot", role: "group", tabindex: 0, "aria-label": label, "data-testid": `curve-${name}` },
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
      this.backdrop,
      this.labels,
      this.control,
      this.line,
      this.guides,
      this.handles.element,
    );
    const turned = (on: boolean): void => {
      events.turned(on);
      this.showHint();
    };
    this.drawing = new Drawing(this.svg, { ...place, catch: (at, event) => this.catchDrawn(at, event) }, { ...events, turned });
    this.svg.append(this.drawing.element);
    const tools = h(
      "div",
      { class: "plot-tools" },
      button({ label: `Zoom in on ${name}`, icon: "plus", act: () => this.zoom(1.25) }),
      button({ label: `Zoom out of ${name}`, icon: "minus", act: () => this.zoom(0.8) }),
      button({ label: `Fit ${name} into view`, icon: "fit", act: () => this.fit() }),
    );
    this.element = h("div", { class: `plot-frame curve-${name}` }, this.svg, this.hint, tools);
    this.listen();
    new ResizeObserver(() => this.resized()).observe(this.element);
  }

  show(shown: Shown): void {
    this.shown = shown;
    const { samples, stale, handles, blank } = shown;
    const box = boxOf([...(samples.length ? samples : handles.map(({ at }) => at)), ...this.events.beside()]);
    if (blank) {
      if (this.wantsFit) this.plane.spread(blank.width, blank.level);
      this.wantsFit = false;
    } else if (box && !stale && !this.handles.held && !this.drawing.active) {
      const follow = this.wantsFit || (!handles.length && !this.plane.suits(box));
      if (follow && samples.length) {
        this.plane.fit(box);
        this.wantsFit = false;
      }
    }
    this.showHint();
    this.draw();
  }

  /** Fit the view to the curve when it is drawn next. */
  refit(): void {
    this.wantsFit = true;
  }

  fit(): void {
    const { samples, handles } = this.shown;
    const box = boxOf([...samples, ...handles.map(({ at }) => at), ...this.events.beside()]);
    if (box) this.plane.fit(box);
    this.draw();
  }

  zoom(factor: number, about?: Point): void {
    this.plane.zoom(factor, about);
    this.draw();
  }

  select(index: number | null): void {
    this.handles.select(index);
  }

  takeFocus(): void {
    this.svg.focus({ preventScroll: true });
  }

  focus(index: number): void {
    this.handles.focus(index);
  }

  draw(): void {
    const { width, height } = this.plane;
    setAttribute(this.svg, "viewBox", `0 0 ${width} ${height}`);
    const { lines, texts } = gridOf(this.plane);
    this.grid.replaceChildren(...lines);
    this.labels.replaceChildren(...texts);
    this.backdrop.replaceChildren(...this.events.backdrop(this.plane));
    const { samples, handles, joined } = this.shown;
    this.line.setAttribute("d", line(...samples.map((point) => this.plane.toPixels(point))));
    this.control.setAttribute("d", joined ? line(...handles.map(({ at }) => this.plane.toPixels(at))) : "");
    this.handles.draw(handles);
    this.drawing.draw();
  }

  private resized(): void {
    const { width, height } = this.svg.getBoundingClientRect();
    if (!width || !height) return;
    const grown = width / this.plane.width;
    this.plane.width = width;
    this.plane.height = height;
    if (this.shown.blank) this.wantsFit = true;
    if (this.shown.blank) this.show(this.shown);
    else if (Math.abs(grown - 1) > 0.01) this.fit();
    else this.draw();
  }

  private catchHandle(at: Point, index: number, event: PointerEvent): Caught {
    const { handles } = this.shown;
    const { kind } = handles[index]!;
    const points = handles.filter((each) => each.kind === "point").map((each) => each.at);
    const inner = kind === "point" && index > 0 && index < points.length - 1;
    const middle = inner ? (points[0]![0] + points.at(-1)![0]) / 2 : null;
    return this.caught(at, kind === "point" ? points.toSpliced(index, 1) : [], middle, event);
  }

  private catchDrawn(at: Point, event: { altKey: boolean }): Caught {
    const begun = this.events.last() !== null;
    return this.caught(at, begun ? this.shown.handles.map((each) => each.at) : [], null, event);
  }

  private caught(at: Point, others: Point[], middle: number | null, event: { altKey: boolean; pointerType?: string }): Caught {
    const reach = (event.pointerType === "touch" ? REACH.touch : REACH.mouse) / this.plane.scale;
    const found = event.altKey ? { at, guides: [], words: "" } : caught(at, { others, middle, step: this.plane.step, reach });
    this.guides.setAttribute("d", guidesOf(this.plane, found.guides));
    this.words = found.words;
    this.showHint();
    return found;
  }

  private free(): void {
    this.guides.setAttribute("d", "");
    this.words = "";
    this.showHint();
  }

  private showHint(): void {
    const { words } = this;
    const { blank, handles } = this.shown;
    const single = handles.length === 1 && !this.drawing.active;
    const waiting = this.drawing.active && this.events.last() === null;
    const text = words || (waiting ? `${blank?.words ?? "A new curve:"} ${HOW_TO_DRAW}` : blank ? NOTHING_YET : single ? ONE_POINT : "");
    this.hint.textContent = text;
    this.hint.hidden = !text;
    this.hint.classList.toggle("waiting", !words);
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
      else if (event.key === "d" && !event.ctrlKey && !event.metaKey) this.events.wanted();
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
