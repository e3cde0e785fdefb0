// What is drawn in space is made of these: shaders with their uniforms, and meshes that carry them.

import { BufferGeometry, DoubleSide, GLSL3, Mesh, RawShaderMaterial, type IUniform } from "three";

export type Uniforms = Record<string, IUniform>;
export type Part = Mesh<BufferGeometry, RawShaderMaterial>;

export const material = (
  vertexShader: string, fragmentShader: string, uniforms: Uniforms, more: object = {},
): RawShaderMaterial =>
  new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, side: DoubleSide, ...more });

export function part(look: RawShaderMaterial, order: number): Part {
  const mesh = new Mesh(new BufferGeometry(), look);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

/** Two triangles for each of some lines of four vertices. */
export function quadIndex(lines: ArrayLike<number>): Uint32Array {
  const index = new Uint32Array(6 * lines.length);
  for (let i = 0; i < lines.length; i++) {
    const v = 4 * lines[i]!;
    index[6 * i] = v;
    index[6 * i + 1] = index[6 * i + 4] = v + 1;
    index[6 * i + 2] = index[6 * i + 3] = v + 2;
    index[6 * i + 5] = v + 3;
  }
  return index;
}
