// A person inside or beside the shell, for its size: a flat figure that faces the eye.

import { BufferAttribute, BufferGeometry, GreaterDepth, ShapeUtils, Vector2, Vector3 } from "three";
import type { Theme } from "./colours.ts";
import { extentOf, goodDirection } from "./camera.ts";
import { between, groundOf } from "./ground.ts";
import type { Headroom } from "./headroom.ts";
import type { Drawing, Guest } from "./marks3d.ts";
import { material, part, type Uniforms } from "./parts.ts";
import { heightOfPerson, PERSON, suitsPerson } from "./person.ts";
import type { Motion } from "./rigid.ts";
import { figureVertex, plainFragment } from "./shaders.ts";
import { drives, targetPoints, vertexCount, type View } from "./view.ts";

/** Clear of the shell beside which it stands, in its height. */
const BESIDE = 0.4;
/** How much of it is seen through the shell. */
const THROUGH = 0.4;
/** Half the width of a figure, in its height. */
const HALF = 0.2;
/** Room over its head where it stands inside, in its height. */
const OVER = 1.03;

export class Person3D implements Guest {
  private readonly figure;
  /** The same, faintly where the shell hides it. */
  private readonly hidden;
  private readonly ink = { value: [0, 0, 0] };
  private readonly shade = { value: [0, 0, 0] };
  private readonly foot = { value: new Vector3() };
  private readonly tall = { value: 1 };
  private fits = false;
  private on = true;
  /** Where it stands inside, if the shell is high enough. */
  private room: Headroom | null = null;
  /** Where it stands beside every state of the motion. */
  private beside = { drives: [] as number[], x: [] as number[], y: [] as number[], z: [] as number[] };

  constructor(uniforms: Uniforms) {
    const own = { ...uniforms, ink: this.ink, foot: this.foot, tall: this.tall };
    this.figure = part(material(figureVertex, plainFragment, { ...own, opacity: { value: 1 } }), 0);
    this.hidden = part(material(figureVertex, plainFragment, { ...own, ink: this.shade, opacity: { value: THROUGH } }, { transparent: true, depthFunc: GreaterDepth, depthWrite: false }), 7);
    const outline = PERSON.map(([x, y]) => new Vector2(x, y));
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from(PERSON.flatMap(([x, y]) => [x, y, 0])), 3));
    geometry.setIndex(ShapeUtils.triangulateShape(outline, []).flat());
    this.figure.geometry = this.hidden.geometry = geometry;
  }

  get drawn() {
    return [this.figure, this.hidden];
  }

  /** Whether a person says anything of a shell's size. */
  static suits(view: View): boolean {
    const points = targetPoints(view);
    if (!points) return false;
    const { low, high } = extentOf([points]);
    return suitsPerson(Math.max(...high.sub(low)), view.header.unit);
  }

  setVisible(on: boolean): void {
    this.on = on;
  }

  /** Beside the shell, until it is known how much room is in it. */
  show(view: View): void {
    this.fits = Person3D.suits(view);
    if (!this.fits) return;
    const tall = heightOfPerson(view.header.unit), size = 3 * vertexCount(view);
    this.tall.value = tall;
    const at = [...drives(view)], ground = groundOf(view);
    // To the left, as one looks: nothing of the shell is before it or behind it.
    const { x, y } = goodDirection(targetPoints(view)!).setZ(0).normalize();
    const places = at.map((_, k) => {
      const state = view.positions.subarray(k * size, (k + 1) * size);
      const [near, far] = spread(state, x, y), [left] = spread(state, -y, x);
      const along = (near + far) / 2, across = left - BESIDE * tall;
      return [along * x - across * y, along * y + across * x] as const;
    });
    this.beside = {
      drives: at,
      x: places.map(([x]) => x),
      y: places.map(([, y]) => y),
      z: at.map((drive) => ground.levelAt(drive)),
    };
  }

  /** Where the shell has most room, if that is enough; true if it stands elsewhere now than before,
   * inside or beside. */
  place(room: Headroom | null): boolean {
    const before = this.room;
    this.room = room !== null && room.height >= OVER * this.tall.value ? room : null;
    return (before === null) !== (this.room === null);
  }

  get reach(): Float32Array {
    if (!this.figure.visible) return new Float32Array();
    const { x, y, z } = this.foot.value, half = HALF * this.tall.value;
    return Float32Array.from([-half, half].flatMap((side) => [x + side, y, z, x + side, y, z + this.tall.value]));
  }

  /** Inside only while the shell stands: on the way panels would cut through it. */
  move(_: Motion, { drive, atTarget, ground }: Drawing): void {
    this.figure.visible = this.hidden.visible = this.on && this.fits;
    const { room, beside } = this;
    if (room && atTarget) this.foot.value.set(room.x, room.y, ground);
    else this.foot.value.set(between(beside.drives, beside.x, drive), between(beside.drives, beside.y, drive), ground);
  }

  paint(theme: Theme): void {
    this.ink.value = theme.linear("--person");
    this.shade.value = theme.linear("--person-behind");
  }

  dispose(): void {
    this.figure.geometry.dispose();
    for (const each of this.drawn) each.material.dispose();
  }
}

/** How far points (n, 3) reach along a direction in plan. */
function spread(points: Float32Array, x: number, y: number): [number, number] {
  let low = Infinity, high = -Infinity;
  for (let i = 0; i < points.length; i += 3) {
    const at = points[i]! * x + points[i + 1]! * y;
    if (at < low) low = at;
    if (at > high) high = at;
  }
  return [low, high];
}
