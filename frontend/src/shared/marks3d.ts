// Lines and dots that are drawn into the view in space, some hundreds of them, moved as they are told.

import { BufferAttribute, BufferGeometry, Mesh, type Object3D, Points, type RawShaderMaterial } from "three";
import type { Theme } from "./colours.ts";
import { material, quadIndex, type Uniforms } from "./parts.ts";
import type { Motion } from "./rigid.ts";
import { curveVertex, dotFragment, dotVertex, lineFragment } from "./shaders.ts";
import type { View } from "./view.ts";

/** The state drawn: its drive, and the height of the ground below it. */
export interface Drawing {
  drive: number;
  atTarget: boolean;
  ground: number;
}

/** What else is drawn in space, about the shell's origin. */
export interface Guest {
  readonly drawn: Object3D[];
  /** Whether it is drawn with loads, too. */
  readonly withLoads?: boolean;
  /** Another shell. */
  show?(view: View, motion: Motion): void;
  /** Points that are to be in view with the shell (n, 3). */
  readonly reach?: Float32Array;
  /** Another state of it is drawn. */
  move?(motion: Motion, state: Drawing): void;
  paint(theme: Theme): void;
  dispose(): void;
}

/** How a mark is drawn: `through`, its strength where the shell hides it. */
export interface Stroke {
  /** Pixels of the style sheet. */
  width: number;
  through?: number;
}

type Drawn = { material: RawShaderMaterial; geometry: BufferGeometry; visible: boolean };

const SOFT = { transparent: true, depthWrite: false };

abstract class Marks {
  protected readonly ink = { value: [0, 0, 0] };
  abstract readonly drawn: Object3D[];

  setColour(rgb: number[]): void {
    this.ink.value = rgb;
  }

  set visible(value: boolean) {
    for (const each of this.drawn) each.visible = value;
  }

  dispose(): void {
    for (const each of this.drawn as unknown as Drawn[]) {
      each.geometry.dispose();
      each.material.dispose();
    }
  }
}

export class Lines3D extends Marks {
  readonly drawn: Mesh<BufferGeometry, RawShaderMaterial>[];
  private geometry = new BufferGeometry();

  constructor(uniforms: Uniforms, { width, through = 0 }: Stroke) {
    super();
    const own = { ...uniforms, ink: this.ink, width: { value: width } };
    const layer = (opacity: number, order: number, more: object): Mesh<BufferGeometry, RawShaderMaterial> => {
      const mesh = new Mesh(this.geometry, material(curveVertex, lineFragment, { ...own, opacity: { value: opacity } }, { ...SOFT, ...more }));
      mesh.renderOrder = order;
      mesh.frustumCulled = false;
      return mesh;
    };
    this.drawn = [layer(1, 8, {})];
    if (through) this.drawn.push(layer(through, 7, { depthTest: false }));
  }

  /** Begin and end (n, 2, 3) of every line. */
  set(points: Float32Array): void {
    const count = points.length / 6;
    if (this.geometry.getAttribute("from")?.count !== 4 * count) this.renew(count);
    const from = this.geometry.getAttribute("from") as BufferAttribute, to = this.geometry.getAttribute("to") as BufferAttribute;
    for (let line = 0; line < count; line++) {
      const begin = points.subarray(6 * line, 6 * line + 3), end = points.subarray(6 * line + 3, 6 * line + 6);
      for (let k = 0; k < 4; k++) {
        (from.array as Float32Array).set(begin, 12 * line + 3 * k);
        (to.array as Float32Array).set(end, 12 * line + 3 * k);
      }
    }
    from.needsUpdate = to.needsUpdate = true;
  }

  private renew(count: number): void {
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    for (const name of ["from", "to"]) this.geometry.setAttribute(name, new BufferAttribute(new Float32Array(12 * count), 3));
    this.geometry.setIndex(new BufferAttribute(quadIndex(Array.from({ length: count }, (_, k) => k)), 1));
    for (const mesh of this.drawn) mesh.geometry = this.geometry;
  }
}

export class Dots3D extends Marks {
  readonly drawn: Points<BufferGeometry, RawShaderMaterial>[];
  private geometry = new BufferGeometry();

  constructor(uniforms: Uniforms, { width, through = 0 }: Stroke) {
    super();
    const own = { ...uniforms, ink: this.ink, width: { value: width } };
    const layer = (opacity: number, order: number, more: object): Points<BufferGeometry, RawShaderMaterial> => {
      const points = new Points(this.geometry, material(dotVertex, dotFragment, { ...own, opacity: { value: opacity } }, { ...SOFT, ...more }));
      points.renderOrder = order;
      points.frustumCulled = false;
      return points;
    };
    this.drawn = [layer(1, 9, {})];
    if (through) this.drawn.push(layer(through, 8, { depthTest: false }));
  }

  /** Places (n, 3). */
  set(points: Float32Array): void {
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(points.slice(), 3));
    for (const each of this.drawn) each.geometry = this.geometry;
  }
}
