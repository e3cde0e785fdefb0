// Another shell, as glass, in the place that it has in the world.

import { BufferAttribute, BufferGeometry, LineSegments, Vector3 } from "three";
import type { Theme } from "./colours.ts";
import type { Drawing, Guest } from "./marks3d.ts";
import { material, part, type Uniforms } from "./parts.ts";
import { Motion } from "./rigid.ts";
import { ghostFragment, ghostVertex, plainFragment } from "./shaders.ts";
import { stopsOf, targetShare, type Stop } from "./stops.ts";
import type { View } from "./view.ts";

/** The share of one motion that is as far between its stops as a share of another is; the target
 * where they have other stops. */
export function shareAmong(share: number, from: Stop[], to: Stop[]): number {
  if (from.map(({ name }) => name).join() !== to.map(({ name }) => name).join()) return targetShare(to);
  const k = Math.max(1, from.findIndex((stop, number) => number > 0 && share <= stop.share));
  const [a, b, c, d] = [from[k - 1]!.share, from[k]!.share, to[k - 1]!.share, to[k]!.share];
  return c + ((share - a) / (b - a || 1)) * (d - c);
}

const corner = new Vector3();

export class Ghost3D implements Guest {
  private readonly ink = { value: [0, 0, 0] };
  private readonly glass;
  private readonly lines;
  private view: View | null = null;
  private motion: Motion | null = null;
  private shown: View | null = null;
  private points = new BufferAttribute(new Float32Array(0), 3);

  constructor(uniforms: Uniforms) {
    this.glass = part(material(ghostVertex, ghostFragment, { ...uniforms, ink: this.ink }, { transparent: true, depthWrite: false }), 3);
    this.lines = new LineSegments(new BufferGeometry(), material(ghostVertex, plainFragment, { ink: this.ink, opacity: { value: 0.55 } }, { transparent: true, depthWrite: false }));
    this.lines.renderOrder = 4;
    this.lines.frustumCulled = false;
    this.glass.visible = this.lines.visible = false;
  }

  get drawn() {
    return [this.glass, this.lines];
  }

  /** Another ghost, or none. */
  set(view: View | null): void {
    this.view = view;
    this.motion = view && new Motion(view);
    for (const each of this.drawn) each.geometry.dispose();
    if (!this.motion) return;
    const { panels } = this.motion;
    this.points = new BufferAttribute(new Float32Array(12 * panels), 3);
    const faces: number[] = [], sides: number[] = [];
    for (let v = 0; v < 4 * panels; v += 4) {
      faces.push(v, v + 1, v + 2, v, v + 2, v + 3);
      sides.push(v, v + 1, v + 1, v + 2, v + 2, v + 3, v + 3, v);
    }
    for (const [each, index] of [[this.glass, faces], [this.lines, sides]] as const) {
      each.geometry = new BufferGeometry();
      each.geometry.setAttribute("position", this.points);
      each.geometry.setIndex(index);
    }
  }

  show(view: View): void {
    this.shown = view;
  }

  move(motion: Motion, { drive }: Drawing): void {
    const { view, shown, motion: own } = this;
    this.glass.visible = this.lines.visible = view !== null && view !== shown;
    if (!view || !shown || !own) return;
    own.setFold(shareAmong(motion.shareOf(drive), stopsOf(shown), stopsOf(view)));
    const [x, y, z] = view.header.origin.map((each, axis) => each - shown.header.origin[axis]!);
    for (let v = 0; v < 4 * own.panels; v++) {
      own.at(v, corner);
      this.points.setXYZ(v, corner.x + x!, corner.y + y!, corner.z + z!);
    }
    this.points.needsUpdate = true;
  }

  paint(theme: Theme): void {
    this.ink.value = theme.linear("--ghost");
  }

  dispose(): void {
    for (const each of this.drawn) {
      each.geometry.dispose();
      each.material.dispose();
    }
  }
}
