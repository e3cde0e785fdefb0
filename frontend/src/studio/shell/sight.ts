// What lies under the pointer, in space and in the pattern alike: a panel, and the nearest place on its sides.

import type { Vector3 } from "three";
import { flatPlace } from "../../shared/inspect.ts";
import type { Pattern2D } from "../../shared/pattern2d.ts";
import type { Shell3D } from "../../shared/shell3d.ts";
import { type Pixel, type Snapped, snapTo } from "../../shared/snap.ts";
import type { Store } from "../state/store.ts";

export type Room = "space" | "pattern";

export interface Sighted extends Snapped {
  panel: number;
  /** Mean length of the panel's sides on the screen (pixels). */
  size: number;
}

/** Arrow keys as steps in the grid of the flat sheet. */
export const ARROWS: Record<string, [down: number, right: number]> = {
  ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0],
};

/** A pointer that moves less than this between down and up taps (pixels). */
const STILL = 6;
/** Around a place beside the sheet, its rim is looked for this far away (pixels). */
const RIM = 9;
const AROUND: Pixel[] = [[0, 0], ...Array.from({ length: 8 }, (_, k): Pixel => [RIM * Math.cos((k * Math.PI) / 4), RIM * Math.sin((k * Math.PI) / 4)])];

export class Sight {
  constructor(
    private readonly store: Store,
    private readonly shell: Shell3D,
    private readonly pattern: Pattern2D,
  ) {}

  /** Call back where either drawing is tapped. */
  onTap(tapped: (room: Room, event: PointerEvent) => void): void {
    for (const [room, canvas] of this.rooms()) {
      let down: PointerEvent | null = null;
      let fingers = 0;
      canvas.addEventListener("pointerdown", (event) => {
        fingers = event.isPrimary ? 1 : fingers + 1;
        down = fingers === 1 && event.button === 0 ? event : null;
      });
      canvas.addEventListener("pointerup", (event) => {
        if (down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < STILL) tapped(room, event);
        down = null;
      });
    }
  }

  /** Call back, once a frame, where the mouse is over either drawing; null when it left. */
  onMove(moved: (room: Room, event: PointerEvent | null) => void): void {
    for (const [room, canvas] of this.rooms()) {
      let latest: PointerEvent | null = null;
      canvas.addEventListener("pointermove", (event) => {
        if (event.pointerType === "touch" || event.buttons) return;
        if (!latest) {
          requestAnimationFrame(() => {
            if (latest) moved(room, latest);
            latest = null;
          });
        }
        latest = event;
      });
      canvas.addEventListener("pointerleave", () => {
        latest = null;
        moved(room, null);
      });
    }
  }

  /** The panel under a place of the window, and what of its sides is nearest; corners catch within reach. */
  at(room: Room, { clientX: x, clientY: y }: PointerEvent, reach: number): Sighted | null {
    for (const [dx, dy] of AROUND) {
      const hit = room === "space" ? this.shell.under(x + dx, y + dy) : this.pattern.under(x + dx, y + dy);
      if (!hit) continue;
      const corners = room === "space" ? this.inSpace(hit.panel) : this.inPattern(hit.panel);
      const snapped = snapTo(corners, [x, y], reach);
      if (room === "space" && snapped.along > 0 && snapped.along < 1) {
        // Shares of a line on the screen are not those of the line in space.
        const [from, to] = [snapped.side, (snapped.side + 1) & 3].map((k) => this.corner(hit.panel, k));
        const way = to!.sub(from!);
        const share = (hit.point as Vector3).clone().sub(from!).dot(way) / way.lengthSq();
        snapped.along = Math.min(1, Math.max(0, share));
      }
      const size = corners.reduce((sum, [u, v], k) => sum + Math.hypot(u - corners[(k + 1) & 3]![0], v - corners[(k + 1) & 3]![1]) / 4, 0);
      return { ...snapped, panel: hit.panel, size };
    }
    return null;
  }

  private rooms(): [Room, HTMLCanvasElement][] {
    return [["space", this.shell.canvas], ["pattern", this.pattern.canvas]];
  }

  private corner(panel: number, k: number): Vector3 {
    const { faces } = this.store.view.value!;
    return this.shell.corner(this.shell.motion!.cornerOf(panel, faces[4 * panel + k]!));
  }

  private inSpace(panel: number): Pixel[] {
    return [0, 1, 2, 3].map((k) => this.shell.onScreen(this.corner(panel, k)));
  }

  private inPattern(panel: number): Pixel[] {
    const view = this.store.view.value!;
    return [0, 1, 2, 3].map((k) => {
      const { x, y } = flatPlace(view, view.faces[4 * panel + k]!);
      return this.pattern.onScreen(x, y);
    });
  }
}
