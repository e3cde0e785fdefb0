// Lines that measure a shell as it stands, at the sides that one sees: width, depth, height, headroom.

import { Vector3 } from "three";
import { extentOf, type Extent } from "../../shared/camera.ts";
import type { Theme } from "../../shared/colours.ts";
import { groundOf } from "../../shared/ground.ts";
import { type Drawing, type Guest, Lines3D } from "../../shared/marks3d.ts";
import type { Uniforms } from "../../shared/parts.ts";
import type { Motion } from "../../shared/rigid.ts";
import { targetPoints, type View } from "../../shared/view.ts";

/** How far lines are from the shell, and how far the lines that lead to them go beyond, of its largest size. */
const AWAY = 0.06;
const BEYOND = 0.02;

export const MEASURES = ["width", "depth", "height", "headroom"] as const;
export type Measure = (typeof MEASURES)[number];
type Line = [Vector3, Vector3];

export class DimensionLines implements Guest {
  /** The middle of every line that is seen. */
  readonly middles = new Map<Measure, Vector3>();
  private readonly lines;
  private readonly inside;
  private box: Extent | null = null;
  private room = 0;
  private on = true;
  private side = "";

  /** `arm`: the way to the eye. */
  constructor(uniforms: Uniforms, private readonly arm: () => Vector3) {
    this.lines = new Lines3D(uniforms, { width: 1.2 });
    this.inside = new Lines3D(uniforms, { width: 1.2, through: 0.6 });
  }

  get drawn() {
    return [...this.lines.drawn, ...this.inside.drawn];
  }

  show(view: View): void {
    const points = targetPoints(view);
    this.box = points && extentOf([points, ...view.clipped.flatMap((each) => targetPoints(each) ?? [])]);
    if (this.box) this.box.low.z = Math.min(this.box.low.z, groundOf(view).atTarget);
    this.room = 0;
  }

  /** The headroom, once it is known; 0: none. */
  setRoom(height: number): void {
    this.room = height;
  }

  setVisible(on: boolean): void {
    this.on = on;
  }

  /** Whether one looks at other sides now than those that are measured. */
  get turned(): boolean {
    return this.middles.size > 0 && this.side !== this.sideSeen();
  }

  get reach(): Float32Array {
    if (!this.box || !this.middles.size) return new Float32Array();
    const { low, high } = this.box, away = this.away;
    return Float32Array.from([low.x - away, high.x + away].flatMap((x) => [low.y - away, high.y + away].flatMap((y) => [x, y, low.z])));
  }

  move(_: Motion, { atTarget }: Drawing): void {
    this.middles.clear();
    const { box } = this;
    const seen = this.on && atTarget && box !== null;
    this.lines.visible = seen;
    this.inside.visible = seen && this.room > 0;
    if (!seen) return;
    this.side = this.sideSeen();
    const drawn = this.measures(box);
    this.lines.set(Float32Array.from(drawn.flat(2).flatMap((each) => [...each])));
    if (!this.room) return;
    const foot = new Vector3(box.centre.x, box.centre.y, box.low.z), top = foot.clone().setZ(box.low.z + this.room);
    this.middles.set("headroom", foot.clone().lerp(top, 0.2));
    this.inside.set(Float32Array.from([...foot, ...top]));
  }

  paint(theme: Theme): void {
    for (const each of [this.lines, this.inside]) each.setColour(theme.linear("--text-2"));
  }

  dispose(): void {
    this.lines.dispose();
    this.inside.dispose();
  }

  private get away(): number {
    const { low, high } = this.box!;
    return AWAY * Math.max(high.x - low.x, high.y - low.y, high.z - low.z);
  }

  private sideSeen(): string {
    const { x, y } = this.arm();
    return `${Math.sign(x)} ${Math.sign(y)} ${Math.abs(x) > Math.abs(y)}`;
  }

  /** Each with the two lines that lead to its ends. */
  private measures({ low, high }: Extent): Line[][] {
    const eye = this.arm(), { away } = this, reach = away + BEYOND * (away / AWAY);
    const [toX, toY] = [eye.x < 0 ? -1 : 1, eye.y < 0 ? -1 : 1];
    const near = new Vector3(toX < 0 ? low.x : high.x, toY < 0 ? low.y : high.y, low.z);
    const far = new Vector3(toX < 0 ? high.x : low.x, toY < 0 ? high.y : low.y, low.z);
    const measured = (name: Measure, from: Vector3, to: Vector3, out: Vector3): Line[] => {
      const [begin, end] = [from, to].map((each) => each.clone().addScaledVector(out, away)) as Line;
      this.middles.set(name, begin.clone().lerp(end, 0.5));
      return [[begin, end], ...[from, to].map((each): Line => [each, each.clone().addScaledVector(out, reach)])];
    };
    // Of the two upright edges that one sees against the ground, the right one.
    const right = new Vector3(-eye.y, eye.x, 0);
    const [one, other] = [new Vector3(far.x, near.y, low.z), new Vector3(near.x, far.y, low.z)];
    const [edge, out] = one.dot(right) > other.dot(right) ? [one, new Vector3(-toX, 0, 0)] : [other, new Vector3(0, -toY, 0)];
    return [
      measured("width", new Vector3(low.x, near.y, low.z), new Vector3(high.x, near.y, low.z), new Vector3(0, toY, 0)),
      measured("depth", new Vector3(near.x, low.y, low.z), new Vector3(near.x, high.y, low.z), new Vector3(toX, 0, 0)),
      measured("height", edge, edge.clone().setZ(high.z), out),
    ];
  }
}
