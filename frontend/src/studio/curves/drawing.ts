// Drawing a curve: a stroke from one end to the other, or click by click; with keys, a cross hair.

import { s } from "../parts/dom.ts";
import type { Plane } from "./plane.ts";
import { line } from "./plot-grid.ts";
import { ARROWS } from "./plot-handles.ts";
import type { Caught } from "./snapping.ts";
import { distance } from "./spline.ts";
import type { Point } from "../state/types.ts";

export interface DrawEvents {
  /** A point is put at the end of what is drawn. */
  clicked(at: Point): void;
  /** A stroke was drawn, from its first place to its last. */
  stroked(points: Point[]): void;
  /** Drawing has begun or ended. */
  turned(on: boolean): void;
  /** Where the last point is. */
  last(): Point | null;
}

export interface DrawPlace {
  plane: Plane;
  pixels(event: MouseEvent): Point;
  catch(at: Point, event: { altKey: boolean }): Caught;
  free(): void;
}

/** A pointer that moves less is a click; a click as near to the last point ends the drawing. */
const CLICK = 6;

export class Drawing {
  readonly element = s("g", { class: "plot-drawing" });
  private readonly stroke = s("path", { class: "plot-stroke" });
  private readonly cross = s("path", { class: "plot-cross" });
  /** From the last point to where the next would be. */
  private readonly band = s("path", { class: "plot-band" });
  private on = false;
  private track: Point[] = [];
  private pointer: number | null = null;
  private at: Point | null = null;

  constructor(
    private readonly svg: SVGSVGElement,
    private readonly place: DrawPlace,
    private readonly events: DrawEvents,
  ) {
    this.element.append(this.band, this.stroke, this.cross);
    // Before handles and the plane get them.
    const capture = { capture: true };
    svg.addEventListener("pointerdown", (event) => this.down(event), capture);
    svg.addEventListener("pointermove", (event) => this.moved(event), capture);
    svg.addEventListener("pointerup", (event) => this.up(event), capture);
    svg.addEventListener("pointercancel", (event) => event.pointerId === this.pointer && this.drop(), capture);
    svg.addEventListener("dblclick", (event) => this.on && event.stopImmediatePropagation(), capture);
    svg.addEventListener("keydown", (event) => this.pressed(event), capture);
  }

  get active(): boolean {
    return this.on;
  }

  turn(on: boolean): void {
    if (this.on === on) return;
    this.on = on;
    this.at = null;
    this.drop();
    this.svg.classList.toggle("drawing", on);
    this.place.free();
    this.events.turned(on);
    this.draw();
  }

  draw(): void {
    const { plane } = this.place;
    this.stroke.setAttribute("d", line(...this.track.map((point) => plane.toPixels(point))));
    const last = this.on ? this.events.last() : null;
    this.band.setAttribute("d", this.at && last ? line(plane.toPixels(last), plane.toPixels(this.at)) : "");
    const [x, y] = this.at && this.on ? plane.toPixels(this.at) : [-99, -99];
    this.cross.setAttribute("d", `M${x - 9} ${y}H${x + 9}M${x} ${y - 9}V${y + 9}`);
  }

  private down(event: PointerEvent): void {
    if (!this.on || event.button !== 0 || this.pointer !== null) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    this.svg.focus({ preventScroll: true });
    this.pointer = event.pointerId;
    this.svg.setPointerCapture(event.pointerId);
    this.track = [this.place.plane.fromPixels(this.place.pixels(event))];
  }

  private moved(event: PointerEvent): void {
    if (!this.on) return;
    event.stopImmediatePropagation();
    if (this.pointer !== null && event.pointerId !== this.pointer) return;
    const at = this.place.plane.fromPixels(this.place.pixels(event));
    if (this.pointer === null) {
      this.at = this.place.catch(at, event).at;
    } else {
      // Pens tell of their pressure where they rest, too.
      if (distance(this.track.at(-1)!, at) > 0) this.track.push(at);
      this.at = null;
    }
    this.draw();
  }

  private up(event: PointerEvent): void {
    if (!this.on || event.pointerId !== this.pointer) return;
    event.stopImmediatePropagation();
    const { plane } = this.place;
    const [first, track] = [this.track[0]!, this.track];
    this.drop();
    const far = Math.max(...track.map((point) => distance(point, first))) * plane.scale;
    if (far < CLICK) {
      this.put(this.place.catch(first, event).at);
    } else {
      const [begin, end] = [first, track.at(-1)!].map((point) => away(point, this.place.catch(point, event).at));
      // Where its ends are caught, the stroke goes along, so that it gets no kink.
      this.events.stroked(
        track.map(([x, y], i) => {
          const share = i / (track.length - 1);
          return [x + (1 - share) * begin![0] + share * end![0], y + (1 - share) * begin![1] + share * end![1]];
        }),
      );
      this.turn(false);
    }
    this.draw();
  }

  private put(at: Point): void {
    const last = this.events.last();
    if (last && distance(last, at) * this.place.plane.scale < CLICK) this.turn(false);
    else this.events.clicked(at);
  }

  private drop(): void {
    this.track = [];
    this.pointer = null;
  }

  private pressed(event: KeyboardEvent): void {
    if (!this.on || event.ctrlKey || event.metaKey) return;
    const { plane } = this.place;
    const direction = ARROWS[event.key];
    if (direction) {
      const step = (plane.step / 4) * (event.shiftKey ? 4 : event.altKey ? 0.1 : 1);
      const from = this.at ?? this.events.last() ?? plane.rounded(plane.centre, plane.step / 4);
      this.at = plane.rounded([from[0] + direction[0] * step, from[1] + direction[1] * step], step);
    } else if (event.key === " ") {
      this.put(this.at ?? plane.rounded(plane.centre, plane.step / 4));
    } else if (event.key === "Enter" || (event.key === "Escape" && this.events.last())) {
      this.turn(false);
    } else {
      return;
    }
    event.preventDefault();
    event.stopImmediatePropagation();
    this.draw();
  }
}

function away(from: Point, to: Point): Point {
  return [to[0] - from[0], to[1] - from[1]];
}
