// A person beside or inside the shell, for its size: a flat figure that faces the eye.

import { BufferAttribute, BufferGeometry, ShapeUtils, Vector2, Vector3 } from "three";
import type { Theme } from "./colours.ts";
import { extentOf } from "./camera.ts";
import type { Headroom } from "./headroom.ts";
import type { Drawing, Guest } from "./marks3d.ts";
import { material, part, type Uniforms } from "./parts.ts";
import { heightOfPerson, PERSON, suitsPerson } from "./person.ts";
import type { Motion } from "./rigid.ts";
import { figureVertex, plainFragment } from "./shaders.ts";
import { targetPoints, type View } from "./view.ts";

/** Clear of the shell beside which it stands, in its height. */
const BESIDE = 0.35;
/** How much of it is seen through the shell. */
const THROUGH = 0.35;
/** Room over its head where it stands inside, in its height. */
const OVER = 1.03;

export class Person3D implements Guest {
  private readonly figure;
  /** The same, faintly where the shell hides it. */
  private readonly hidden;
  private readonly ink = { value: [0, 0, 0] };
  private readonly foot = { value: new Vector3() };
  private readonly tall = { value: 1 };
  private fits = false;
  private inside = false;
  private on = true;

  constructor(uniforms: Uniforms) {
    const own = { ...uniforms, ink: this.ink, foot: this.foot, tall: this.tall };
    this.figure = part(material(figureVertex, plainFragment, { ...own, opacity: { value: 1 } }), 0);
    this.hidden = part(material(figureVertex, plainFragment, { ...own, opacity: { value: THROUGH } }, { transparent: true, depthTest: false, depthWrite: false }), 7);
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

  /** Where the shell has most room; beside it if that is too low. */
  place(view: View, room: Headroom | null): void {
    this.fits = Person3D.suits(view);
    if (!this.fits) return;
    const tall = heightOfPerson(view.header.unit);
    this.tall.value = tall;
    this.inside = room !== null && room.height >= OVER * tall;
    if (this.inside) this.foot.value.set(room!.x, room!.y, 0);
    else {
      const { low, high } = extentOf([view.positions]);
      this.foot.value.set(0.3 * low.x + 0.7 * high.x, low.y - BESIDE * tall, 0);
    }
  }

  /** Inside only while the shell stands: on the way panels would cut through it. */
  move(_: Motion, { atTarget, ground }: Drawing): void {
    this.figure.visible = this.hidden.visible = this.on && this.fits && (atTarget || !this.inside);
    this.foot.value.z = ground;
  }

  paint(theme: Theme): void {
    this.ink.value = theme.linear("--person");
  }

  dispose(): void {
    this.figure.geometry.dispose();
    for (const each of this.drawn) each.material.dispose();
  }
}
