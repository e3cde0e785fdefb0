// Where the pointer is on a canvas, in the camera's terms; asked once a frame.

import { Vector2 } from "three";

export class Pointing {
  private at: Vector2 | null = null;

  /** `moved` asks for a frame; `left` says that the pointer is gone. */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly moved: () => void, left: () => void) {
    canvas.addEventListener("pointermove", this.follow);
    canvas.addEventListener("pointerdown", this.follow);
    canvas.addEventListener("pointerleave", () => {
      this.at = null;
      left();
    });
  }

  /** The place, -1 to 1 both ways, if the pointer moved since it was taken last. */
  take(): Vector2 | null {
    const { at } = this;
    this.at = null;
    return at;
  }

  private readonly follow = (event: PointerEvent): void => {
    // Who drags turns the view and points at nothing.
    if (event.type === "pointermove" && event.buttons) return;
    const box = this.canvas.getBoundingClientRect();
    this.at = new Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1,
      1 - (2 * (event.clientY - box.top)) / box.height,
    );
    this.moved();
  };
}
