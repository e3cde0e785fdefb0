// Flaps that are clipped on: strips of panels of their own, drawn at the target and nowhere else.

import { Group, Vector2 } from "three";
import type { Uniforms } from "./parts.ts";
import { Sheet3D } from "./sheet3d.ts";
import type { View } from "./view.ts";

export class Clipped3D {
  readonly solids = new Group();
  readonly depths = new Group();
  /** Vertices of each strip. */
  points: Float32Array[] = [];
  private readonly uniforms;
  private strips: Sheet3D[] = [];
  private thick = true;

  constructor(shared: Uniforms) {
    // Panels of the sheet that are pointed at or touch have the same numbers.
    this.uniforms = { ...shared, hovered: { value: -1 }, touching: { value: new Vector2(-1, -1) } };
  }

  show(views: View[]): void {
    this.dispose();
    this.points = views.map(({ positions }) => positions);
    this.strips = views.map((view) => {
      const strip = new Sheet3D(this.uniforms);
      strip.show(view);
      strip.setValues(null);
      strip.boards.setVisible(this.thick);
      this.solids.add(...strip.drawn);
      this.depths.add(strip.depth);
      return strip;
    });
  }

  setVisible(visible: boolean): void {
    this.solids.visible = this.depths.visible = visible;
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
