// Elements over the scene that stay at places of it.

import type { Vector3 } from "three";
import type { Shell3D } from "../../shared/shell3d.ts";
import { h } from "../parts/dom.ts";
import { clamp } from "../parts/numbers.ts";

/** Room that other controls have at the top of the picture, and at the right of one that is so wide (pixels). */
const TOP = 64;
const RIGHT = 56;
const WIDE = 420;
/** What would lie on something else is moved up or down by so much, or left out (pixels). */
const MOVES = [0, 30, -30, 60, -60];

/** What stands beyond this share of the width has its words at its left. */
const LEFT_OF = 0.6;

/** Half of what a handle takes (pixels). */
const HANDLE = [13, 13] as const;

type Place = [x: number, y: number];

export class Pinned {
  readonly layer = h("div", { class: "scene-layer" });
  private readonly held: { element: HTMLElement; at: () => Vector3 | null; room: readonly [number, number] | null; placed: string }[] = [];

  constructor(private readonly shell: Shell3D) {
    shell.onFrame.add(() => this.place());
  }

  /** `at`: where it is about the origin, null where it is not seen; `room`: half its size, if it may lie beside
   * its place so that it is whole, and on nothing that was added before. */
  add(element: HTMLElement, at: () => Vector3 | null, room: readonly [number, number] | null = null): void {
    const frame = h("div", { class: "scene-pin", hidden: true }, element);
    this.held.push({ element: frame, at, room, placed: "" });
    this.layer.append(frame);
  }

  /** Nothing is measured here, or the page would be laid out in every frame. */
  private place(): void {
    const taken: { place: Place; room: readonly [number, number] }[] = [];
    for (const each of this.held) {
      const point = each.at();
      const free = (place: Place, room: readonly [number, number]): boolean =>
        taken.every((other) => [0, 1].some((k) => Math.abs(place[k]! - other.place[k]!) >= room[k]! + other.room[k]!));
      const place = point ? this.placeOf(this.shell.eye.inPicture(point), each.room, free) : null;
      if (place) taken.push({ place, room: each.room ?? HANDLE });
      const placed = place ? place.map((at) => at.toFixed(1)).join(" ") : "";
      if (placed === each.placed) continue;
      each.placed = placed;
      each.element.hidden = !place;
      each.element.classList.toggle("at-right", place !== null && place[0] > LEFT_OF * this.shell.eye.size[0]);
      if (place) Object.assign(each.element.style, { left: `${place[0].toFixed(1)}px`, top: `${place[1].toFixed(1)}px` });
    }
  }

  private placeOf([x, y]: Place, room: readonly [number, number] | null, free: (place: Place, room: readonly [number, number]) => boolean): Place | null {
    const [width, height] = this.shell.eye.size;
    if (x < 0 || y < 0 || x > width || y > height) return null;
    // On a phone the tools lie in a row over the shell: no handle looks out below them.
    if (!room) return width <= WIDE && y < TOP ? null : [x, y];
    const places = MOVES.map((by): Place => [
      clamp(x, room[0], Math.max(room[0], width - room[0] - (width > WIDE ? RIGHT : 0))), clamp(y + by, TOP, Math.max(TOP, height - room[1])),
    ]);
    return places.find((place) => free(place, room)) ?? null;
  }
}
