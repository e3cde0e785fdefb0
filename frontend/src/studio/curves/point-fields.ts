// The selected control point in numbers, and buttons to add and remove points.

import { button, numberBox, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { CurveName, Point } from "../state/types.ts";

export interface PointEvents {
  moved(index: number, to: Point, gesture: string): void;
  added(after: number): void;
  removed(index: number): void;
}

export class PointFields {
  readonly element: HTMLElement;
  private readonly title = h("span", { class: "quiet point-title" });
  private readonly boxes: [HTMLInputElement, HTMLInputElement];
  private readonly remove: HTMLButtonElement;
  private points: Point[] = [];
  private index = 0;

  constructor(name: CurveName, events: PointEvents) {
    const box = (axis: 0 | 1): HTMLInputElement =>
      numberBox(
        { step: "any", "aria-label": `${name}, ${"xy"[axis]} of the point`, "data-testid": `point-${name}-${"xy"[axis]}` },
        (value) => {
          const to: Point = [...this.points[this.index]!];
          to[axis] = value;
          events.moved(this.index, to, `type-${name}-${this.index}`);
        },
      );
    this.boxes = [box(0), box(1)];
    this.remove = button({
      label: `Remove this point of ${name}`,
      icon: "minus",
      keys: "Delete",
      testid: `remove-${name}`,
      act: () => events.removed(this.index),
    });
    this.element = h(
      "div",
      { class: "point-fields" },
      this.title,
      h("label", { class: "coordinate" }, "x", this.boxes[0]),
      h("label", { class: "coordinate" }, "y", this.boxes[1]),
      button({
        label: `Add a point of ${name} after this one`,
        icon: "plus",
        testid: `add-${name}`,
        act: () => events.added(this.index),
      }),
      this.remove,
    );
  }

  get selected(): number {
    return this.index;
  }

  select(index: number): void {
    this.index = index;
    this.refresh();
  }

  show(points: Point[]): void {
    this.points = points;
    this.index = Math.min(this.index, points.length - 1);
    this.refresh();
  }

  private refresh(): void {
    const point = this.points[this.index];
    if (!point) return;
    this.title.textContent = `${this.index + 1}/${this.points.length}`;
    this.title.title = `point ${this.index + 1} of ${this.points.length}`;
    this.boxes.forEach((box, axis) => setNumber(box, short(point[axis]!, 8)));
    this.remove.disabled = this.points.length <= 2;
  }
}
