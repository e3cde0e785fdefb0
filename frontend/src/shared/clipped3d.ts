// Parts that go with the sheet: drawn at the target and nowhere else if they have that state alone, such
// as flaps that are clipped on, else as they move, from the drive on at which they are joined to it.

import { Group, Vector2 } from "three";
import type { Uniforms } from "./parts.ts";
import { Sheet3D } from "./sheet3d.ts";
import type { View } from "./view.ts";

export class Clipped3D {
  readonly solids = new Group();
  readonly depths = new Group();
  /** Vertices of each strip. */
  points: Float32Array[] = [];
  /** The share of those that are there at the target alone which are there by now. */
  put = 1;
  private readonly uniforms;
  private strips: Sheet3D[] = [];
  private thick = true;
  /** From which drive on each moves with the sheet; null: it is there at the target alone. */
  private from: (number | null)[] = [];

  constructor(shared: Uniforms) {
    // Panels of the sheet that are pointed at or touch have the same numbers.
    this.uniforms = { ...shared, hovered: { value: -1 }, touching: { value: new Vector2(-1, -1) } };
  }

  show(views: View[]): void {
    this.dispose();
    this.from = views.map(({ header }) => (header.drives_deg.length > 1 ? header.joined_from_deg ?? -Infinity : null));
    this.points = views.map(({ positions }) => positions);
    this.strips = views.map((view) => {
      const strip = new Sheet3D(this.uniforms);
      strip.show(view);
      strip.setValues(null);
      strip.boards.setVisible(this.thick);
      const solids = new Group();
      solids.add(...strip.drawn);
      this.solids.add(solids);
      this.depths.add(strip.depth);
      return strip;
    });
  }

  /** Draw each as it is at a share of the way, where the sheet has this drive. */
  pose(share: number, drive: number, atTarget: boolean): void {
    const put = this.put * this.standing.length;
    let number = 0;
    this.strips.forEach((strip, k) => {
      const from = this.from[k]!, there = from === null ? atTarget && number++ < put : drive >= from;
      this.solids.children[k]!.visible = strip.depth.visible = there;
      if (!there || from === null) return;
      strip.motion!.setFold(share);
      strip.upload();
    });
  }

  /** Vertices of those that are there at the target alone. */
  get standing(): Float32Array[] {
    return this.points.filter((_, k) => this.from[k] === null);
  }

  setThickness(visible: boolean): void {
    this.thick = visible;
    for (const strip of this.strips) strip.boards.setVisible(visible);
  }

  setScale(pixels: number): void {
    for (const strip of this.strips) strip.setScale(pixels);
  }

  dispose(): void {
    for (const strip of this.strips) strip.dispose();
    this.solids.clear();
    this.depths.clear();
  }
}
