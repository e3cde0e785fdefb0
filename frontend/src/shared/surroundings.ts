// What stands around the shell: ground with its grid, target surface, curves f and g.

import { BufferAttribute, BufferGeometry, Mesh, type RawShaderMaterial } from "three";
import { curveVertex, groundFragment, groundVertex, lineFragment, surfaceFragment, surfaceVertex } from "./shaders.ts";
import { material, quadIndex, type Uniforms } from "./parts.ts";
import type { Lattice } from "./view.ts";

export function makeGround(uniforms: Uniforms): Mesh<BufferGeometry, RawShaderMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  const ground = new Mesh(geometry, material(groundVertex, groundFragment, uniforms, {
    transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: 4, polygonOffsetUnits: 16,
  }));
  ground.frustumCulled = false;
  ground.renderOrder = -1;
  return ground;
}

/** The target: glass with lines, drawn after the shell. */
export function makeSurface(uniforms: Uniforms): Mesh<BufferGeometry, RawShaderMaterial> {
  const surface = new Mesh(new BufferGeometry(), material(surfaceVertex, surfaceFragment, uniforms, { transparent: true, depthWrite: false }));
  surface.frustumCulled = false;
  surface.renderOrder = 3;
  return surface;
}

export function setLattice(mesh: Mesh<BufferGeometry>, lattice: Lattice | undefined): void {
  mesh.geometry.dispose();
  const geometry = new BufferGeometry();
  mesh.geometry = geometry;
  if (!lattice) return;
  const { rows, columns, points } = lattice;
  const uv = new Float32Array(2 * rows * columns);
  const index = new Uint32Array(6 * (rows - 1) * (columns - 1));
  let n = 0;
  for (let i = 0; i < rows; i++) {
    for (let j = 0; j < columns; j++) {
      const v = i * columns + j;
      uv[2 * v] = i / (rows - 1);
      uv[2 * v + 1] = j / (columns - 1);
      if (i + 1 < rows && j + 1 < columns) {
        index.set([v, v + 1, v + columns, v + columns, v + 1, v + columns + 1], n);
        n += 6;
      }
    }
  }
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setAttribute("uv", new BufferAttribute(uv, 2));
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.computeVertexNormals();
}

/** A curve, and the same curve faintly where the shell hides it. */
export class CurveLine {
  readonly front: Mesh<BufferGeometry, RawShaderMaterial>;
  readonly hidden: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly ink = { value: [0, 0, 0] };

  constructor(uniforms: Uniforms) {
    const own = { ...uniforms, ink: this.ink, width: { value: 2.6 } };
    this.front = new Mesh(new BufferGeometry(), material(curveVertex, lineFragment, { ...own, opacity: { value: 1 } }, { transparent: true, depthWrite: false }));
    this.hidden = new Mesh(this.front.geometry, material(curveVertex, lineFragment, { ...own, opacity: { value: 0.4 } }, {
      transparent: true, depthTest: false, depthWrite: false,
    }));
    this.front.renderOrder = 6;
    this.hidden.renderOrder = 5;
    for (const mesh of this.meshes) mesh.frustumCulled = false;
  }

  get meshes(): Mesh<BufferGeometry, RawShaderMaterial>[] {
    return [this.front, this.hidden];
  }

  setColour(rgb: number[]): void {
    this.ink.value = rgb;
  }

  set visible(value: boolean) {
    for (const mesh of this.meshes) mesh.visible = value;
  }

  show(points: Float32Array | undefined): void {
    const count = points ? Math.max(0, points.length / 3 - 1) : 0;
    const from = new Float32Array(12 * count), to = new Float32Array(12 * count);
    for (let line = 0; line < count; line++) {
      for (let k = 0; k < 4; k++) {
        from.set(points!.subarray(3 * line, 3 * line + 3), 12 * line + 3 * k);
        to.set(points!.subarray(3 * line + 3, 3 * line + 6), 12 * line + 3 * k);
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("from", new BufferAttribute(from, 3));
    geometry.setAttribute("to", new BufferAttribute(to, 3));
    geometry.setIndex(new BufferAttribute(quadIndex(Array.from({ length: count }, (_, i) => i)), 1));
    this.front.geometry.dispose();
    this.front.geometry = this.hidden.geometry = geometry;
  }

  dispose(): void {
    this.front.geometry.dispose();
    for (const mesh of this.meshes) mesh.material.dispose();
  }
}
