// The crease pattern: the flat sheet seen from +z. Zoom by wheel, pinch and keys; pan by drag.

import { roundLength } from "./camera.ts";
import { themeOf, type Theme } from "./colours.ts";
import { length } from "./quantities.ts";
import { PatternGestures } from "./gestures.ts";
import { Assignment, outlines, type View } from "./view.ts";

/** Lines by assignment: colour, width in pixels. Borders come last, on top. */
const STROKES: [code: number, colour: string, width: number][] = [
  [Assignment.unfolded, "--unfolded", 0.9],
  [Assignment.valley, "--valley", 1.5],
  [Assignment.mountain, "--mountain", 1.5],
  [Assignment.cut, "--border-crease", 1.7],
  [Assignment.border, "--border-crease", 1.7],
];
/** Valleys are dashed where they are so long on the screen; gaps are no shorter (pixels). */
const DASHED = 6;
const GAP = 2;
/** A dash with its gap, about (pixels). */
const PERIOD = 8;
const MARGIN = 22;
/** Below the sheet stands the scale. */
const FOOT = 34;
/** Lines drawn at a stroke: longer paths take canvases out of their stride. */
const STROKE = 1500;

/** What else is drawn on the sheet: `at` says where a point of it is in the picture. */
export type Layer = (pen: CanvasRenderingContext2D, at: (x: number, y: number) => [number, number], theme: Theme) => void;

export class Pattern2D {
  /** Drawn with the sheet, and drawn above it, which is cheap to ask for. */
  readonly layers: { sheet: Layer[]; top: Layer[] } = { sheet: [], top: [] };
  onHover: ((panel: number | null) => void) | null = null;
  private readonly base = document.createElement("canvas");
  private readonly top = document.createElement("canvas");
  private readonly note = document.createElement("div");
  private readonly scale = document.createElement("div");
  private readonly observer: ResizeObserver;
  private readonly gestures: PatternGestures;
  private view: View | null = null;
  private rims: Uint32Array[] = [];
  private box = { x: 0, y: 0, width: 1, height: 1 };
  /** How far creases are from each other, on average. */
  private apart = 1;
  private chosen: number | null = null;
  private request = 0;
  private whole = true;
  /** Middle of the picture in the sheet, pixels per unit of length. */
  private x = 0;
  private y = 0;
  private zoom = 1;
  /** Size of the picture (pixels of the style sheet): asking the page for it makes it lay itself out. */
  private width = 0;
  private height = 0;

  constructor(private readonly container: HTMLElement, options: { label?: string } = {}) {
    container.classList.add("orishell-pattern");
    this.base.tabIndex = 0;
    this.base.setAttribute("role", "application");
    this.base.setAttribute("aria-label", `${options.label ?? "Crease pattern"}. Arrow keys pan, plus and minus zoom, 0 shows all.`);
    this.top.className = "orishell-pattern-top";
    this.note.className = "orishell-note";
    this.scale.className = "orishell-bar";
    container.append(this.base, this.top, this.note, this.scale);
    this.gestures = new PatternGestures(this.base, {
      pan: (dx, dy) => this.pan(dx, dy),
      zoom: (factor, x, y) => this.zoomBy(factor, x, y),
      fit: () => this.fit(),
      hover: (x, y) => this.hover(x, y),
    });
    document.addEventListener("themechange", this.invalidate);
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(container);
    this.resize();
  }

  show(view: View, keepView = false): void {
    const first = this.view === null;
    this.view = view;
    this.box = boxOf(view.flat);
    this.apart = distanceOfCreases(view);
    this.chosen = null;
    this.rims = view.flat.length ? outlines(view) : [];
    this.note.textContent = view.flat.length ? "" : "Folded states only: there is no flat sheet to draw.";
    if (first || !keepView || this.whole) this.fit();
    this.invalidate();
  }

  get canvas(): HTMLCanvasElement {
    return this.base;
  }

  /** Draw the layers anew. */
  refresh(sheet = false): void {
    if (sheet) this.invalidate();
    else this.drawTop();
  }

  /** What lies under a place of the window: the panel, and the point of the sheet. */
  under(x: number, y: number): { panel: number; point: [number, number] } | null {
    const box = this.base.getBoundingClientRect();
    const point = this.sheetPoint(x - box.left, y - box.top);
    const panel = this.panelAt(...point);
    return panel === null ? null : { panel, point };
  }

  /** Where a point of the sheet is in the window. */
  onScreen(x: number, y: number): [number, number] {
    const box = this.base.getBoundingClientRect();
    return [box.left + this.px(x), box.top + this.py(y)];
  }

  highlight(panel: number | null): void {
    if (panel === this.chosen) return;
    this.chosen = panel;
    this.drawTop();
  }

  fit(): void {
    const { width, height } = this;
    this.whole = true;
    this.x = this.box.x + this.box.width / 2;
    this.y = this.box.y + this.box.height / 2;
    const margin = Math.min(MARGIN, width / 8, height / 8), foot = Math.min(FOOT, height / 5);
    this.zoom = Math.min((width - 2 * margin) / this.box.width, (height - margin - foot) / this.box.height) || 1;
    this.y -= (foot - margin) / 2 / this.zoom;
    this.invalidate();
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.observer.disconnect();
    this.gestures.dispose();
    document.removeEventListener("themechange", this.invalidate);
    this.container.replaceChildren();
  }

  private pan(dx: number, dy: number): void {
    this.whole = false;
    this.x = within(this.x - dx / this.zoom, this.box.x, this.box.x + this.box.width);
    this.y = within(this.y + dy / this.zoom, this.box.y, this.box.y + this.box.height);
    this.invalidate();
  }

  /** Zoom about a point of the picture; about its middle if none is given. */
  private zoomBy(factor: number, x = this.width / 2, y = this.height / 2): void {
    const [u, v] = this.sheetPoint(x, y);
    const all = Math.min(this.width / this.box.width, this.height / this.box.height);
    const zoom = within(this.zoom * factor, 0.4 * all, 400 * all);
    const share = this.zoom / zoom;
    this.whole = false;
    this.x = u + (this.x - u) * share;
    this.y = v + (this.y - v) * share;
    this.zoom = zoom;
    this.invalidate();
  }

  private sheetPoint(x: number, y: number): [number, number] {
    return [
      this.x + (x - this.width / 2) / this.zoom,
      this.y - (y - this.height / 2) / this.zoom,
    ];
  }

  private resize(): void {
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    this.width = this.container.clientWidth;
    this.height = this.container.clientHeight;
    for (const canvas of [this.base, this.top]) {
      canvas.width = Math.max(1, Math.round(this.width * ratio));
      canvas.height = Math.max(1, Math.round(this.height * ratio));
    }
    if (this.whole) this.fit();
    cancelAnimationFrame(this.request);
    this.draw();
  }

  private readonly invalidate = (): void => {
    this.request ||= requestAnimationFrame(this.draw);
  };

  private readonly draw = (): void => {
    this.request = 0;
    const pen = this.pen(this.base);
    if (!this.view || !pen) return;
    const theme = themeOf(this.container);
    this.drawSheet(pen, this.view, theme);
    for (const layer of this.layers.sheet) layer(pen, this.at, theme);
    this.drawScale();
    this.drawTop();
  };

  private drawSheet(pen: CanvasRenderingContext2D, view: View, theme: Theme): void {
    const { flat, edges, assignment } = view;
    const thin = within((this.apart * this.zoom) / 14, 0.25, 1);
    const [west, north] = this.sheetPoint(0, 0);
    const [east, south] = this.sheetPoint(this.width, this.height);
    pen.beginPath();
    for (const rim of this.rims) this.trace(pen, view.flat, rim);
    pen.fillStyle = theme.text("--panel-front");
    pen.globalAlpha = theme.number("--paper");
    pen.fill();
    pen.globalAlpha = 1;
    for (const [code, colour, width] of STROKES) {
      pen.strokeStyle = theme.text(colour);
      pen.lineWidth = width * Math.max(thin, 0.5);
      pen.globalAlpha = Math.min(1, 2 * thin);
      // Dashes fit into their crease: those of about the same length are drawn together.
      const lines = new Map<number, number[]>();
      for (let e = 0; e < assignment.length; e++) {
        if (assignment[e] !== code) continue;
        const a = 2 * edges[2 * e]!, b = 2 * edges[2 * e + 1]!;
        const ax = flat[a]!, ay = flat[a + 1]!, bx = flat[b]!, by = flat[b + 1]!;
        if ((ax < west && bx < west) || (ax > east && bx > east) || (ay > north && by > north) || (ay < south && by < south)) continue;
        const size = code === Assignment.valley ? Math.hypot(bx - ax, by - ay) * this.zoom : 0;
        const key = size < DASHED ? 0 : Math.round(2 * Math.log2(size));
        if (!lines.has(key)) lines.set(key, []);
        lines.get(key)!.push(this.px(ax), this.py(ay), this.px(bx), this.py(by));
      }
      for (const [key, ends] of lines) {
        pen.setLineDash(key ? dashes(2 ** (key / 2)) : []);
        pen.lineCap = key ? "butt" : "round";
        for (let k = 0; k < ends.length; k += 4 * STROKE) strokeLines(pen, ends.slice(k, k + 4 * STROKE));
      }
    }
    pen.setLineDash([]);
    pen.globalAlpha = 1;
  }

  private drawTop(): void {
    const pen = this.pen(this.top);
    if (!pen || !this.view?.flat.length) return;
    const theme = themeOf(this.container);
    for (const layer of this.layers.top) {
      pen.save();
      layer(pen, this.at, theme);
      pen.restore();
    }
    if (this.chosen === null) return;
    const colour = theme.text("--hover");
    pen.beginPath();
    this.trace(pen, this.view.flat, this.view.faces.subarray(4 * this.chosen, 4 * this.chosen + 4));
    pen.fillStyle = pen.strokeStyle = colour;
    pen.globalAlpha = 0.45;
    pen.fill();
    pen.globalAlpha = 1;
    pen.lineWidth = 2;
    pen.stroke();
  }

  private drawScale(): void {
    const step = roundLength(90 / this.zoom);
    this.scale.style.width = `${step * this.zoom}px`;
    this.scale.textContent = this.view!.flat.length ? length(step, this.view!.header.unit) : "";
    this.scale.hidden = !this.view!.flat.length;
  }

  private trace(pen: CanvasRenderingContext2D, flat: Float32Array, loop: Uint32Array): void {
    for (let i = 0; i < loop.length; i++) {
      const v = 2 * loop[i]!;
      const x = this.px(flat[v]!), y = this.py(flat[v + 1]!);
      if (i) pen.lineTo(x, y);
      else pen.moveTo(x, y);
    }
    pen.closePath();
  }

  private readonly at = (x: number, y: number): [number, number] => [this.px(x), this.py(y)];

  private px(x: number): number {
    return (x - this.x) * this.zoom + this.width / 2;
  }

  private py(y: number): number {
    return (this.y - y) * this.zoom + this.height / 2;
  }

  private pen(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
    const pen = canvas.getContext("2d");
    if (!pen) return null;
    const ratio = canvas.width / Math.max(1, this.width);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, canvas.width, canvas.height);
    return pen;
  }

  private hover(x: number | null, y = 0): void {
    const panel = x === null ? null : this.panelAt(...this.sheetPoint(x, y));
    if (panel === this.chosen) return;
    this.highlight(panel);
    this.onHover?.(panel);
  }

  private panelAt(x: number, y: number): number | null {
    if (!this.view?.flat.length) return null;
    const { faces, flat } = this.view;
    for (let f = 0; f < faces.length; f += 4) {
      let inside = false;
      for (let i = 0, j = 3; i < 4; j = i++) {
        const a = 2 * faces[f + i]!, b = 2 * faces[f + j]!;
        const ay = flat[a + 1]!, by = flat[b + 1]!;
        if (ay > y !== by > y && x < ((flat[b]! - flat[a]!) * (y - ay)) / (by - ay) + flat[a]!) inside = !inside;
      }
      if (inside) return f / 4;
    }
    return null;
  }
}

/** Dash and gap of a line, which begins and ends with a dash. */
export function dashes(size: number): [number, number] {
  const gaps = Math.max(1, Math.round(size / PERIOD - 0.6));
  const gap = Math.max(GAP, (0.4 * size) / (gaps + 0.6));
  return [(size - gaps * gap) / (gaps + 1), gap];
}

function strokeLines(pen: CanvasRenderingContext2D, ends: readonly number[]): void {
  pen.beginPath();
  for (let k = 0; k < ends.length; k += 4) {
    pen.moveTo(ends[k]!, ends[k + 1]!);
    pen.lineTo(ends[k + 2]!, ends[k + 3]!);
  }
  pen.stroke();
}

function within(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}

/** Of squares it is their side: their area, shared among the edges of the sheet. */
function distanceOfCreases({ flat, faces, edges }: View): number {
  const across = (a: number, b: number): [number, number] => [flat[2 * b]! - flat[2 * a]!, flat[2 * b + 1]! - flat[2 * a + 1]!];
  let area = 0, length = 0;
  for (let f = 0; f < faces.length; f += 4) {
    const [u, v] = across(faces[f]!, faces[f + 2]!), [x, y] = across(faces[f + 1]!, faces[f + 3]!);
    area += Math.abs(u * y - v * x) / 2;
  }
  for (let e = 0; e < edges.length; e += 2) length += Math.hypot(...across(edges[e]!, edges[e + 1]!));
  return (2 * area) / (length || 1) || 1;
}

function boxOf(points: Float32Array): { x: number; y: number; width: number; height: number } {
  let west = Infinity, east = -Infinity, south = Infinity, north = -Infinity;
  for (let i = 0; i < points.length; i += 2) {
    west = Math.min(west, points[i]!);
    east = Math.max(east, points[i]!);
    south = Math.min(south, points[i + 1]!);
    north = Math.max(north, points[i + 1]!);
  }
  if (!points.length) return { x: 0, y: 0, width: 1, height: 1 };
  return { x: west, y: south, width: east - west || 1, height: north - south || 1 };
}
