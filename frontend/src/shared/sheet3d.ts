// The sheet as the graphics card holds it: panels and creases that stand still, and their poses.

import {
  BufferAttribute, BufferGeometry, DataTexture, FloatType, LineSegments, NearestFilter,
  type Object3D, type RawShaderMaterial, RGBAFormat,
} from "three";
import { Boards3D } from "./boards3d.ts";
import { material, part, type Part, quadIndex, type Uniforms } from "./parts.ts";
import { Motion } from "./rigid.ts";
import { creaseVertex, depthFragment, depthVertex, lineFragment, panelFragment, panelVertex, threadVertex } from "./shaders.ts";
import { edgePanels, type View } from "./view.ts";

/** Panels in a row of the textures; the shaders know it too. */
const ROW = 512;
/** Stands for a distance that is not known. */
const UNKNOWN = 3e30;
/** Of more edges than this those that come out this short (pixels of the style sheet) are threads. */
const MANY = 6000;
const SHORT = 9;

export class Sheet3D {
  readonly panels: Part;
  readonly depth: Part;
  readonly creases: Part;
  /** The same creases one pixel wide, where panels are tiny; either is drawn. */
  readonly threads: LineSegments<BufferGeometry, RawShaderMaterial>;
  /** Outlines of marked panels, seen through what lies before them. */
  readonly marks: Part;
  /** What is built of the panels, where they have a thickness. */
  readonly boards: Boards3D;
  motion: Motion | null = null;
  /** Adjacent panels of the edges drawn. */
  private beside: Int32Array = new Int32Array(0);
  private marked: number[] = [];
  private readonly thread = { value: 1 };
  private meanEdge = 1;
  private readonly poses = { value: texture(2, 1) };
  private readonly corners = { value: texture(4, 1) };

  constructor(uniforms: Uniforms) {
    const shared = { ...uniforms, poses: this.poses, corners: this.corners, covered: { value: 0 } };
    const line = { transparent: true, depthWrite: false };
    this.panels = part(material(panelVertex, panelFragment, shared, {
      polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 4,
    }), 0);
    this.depth = part(material(depthVertex, depthFragment, shared), 0);
    this.creases = part(material(creaseVertex, lineFragment, { ...shared, opacity: { value: 1 } }, line), 2);
    this.threads = new LineSegments(new BufferGeometry(), material(threadVertex, lineFragment, {
      ...shared, thread: this.thread, opacity: { value: 1 },
    }, line));
    this.threads.frustumCulled = false;
    this.threads.renderOrder = 2;
    this.marks = part(material(creaseVertex, lineFragment, { ...shared, opacity: { value: 0.35 } }, { ...line, depthTest: false }), 4);
    this.boards = new Boards3D(shared);
  }

  /** What is drawn, but for the depths that the light sees. */
  get drawn(): Object3D[] {
    return [this.panels, this.boards.solids, this.creases, this.threads, this.marks];
  }

  show(view: View): void {
    const motion = new Motion(view);
    this.motion = motion;
    const rows = Math.max(1, Math.ceil(motion.panels / ROW));
    if (this.poses.value.image.height !== rows) {
      for (const [held, each] of [[this.poses, 2], [this.corners, 4]] as const) {
        held.value.dispose();
        held.value = texture(each, rows);
      }
    }
    this.disposeGeometries();
    const adjacent = edgePanels(view);
    writeCorners(motion, adjacent, this.corners.value);
    this.panels.geometry = this.depth.geometry = panelGeometry(motion);
    this.boards.show(motion, view);
    [this.creases.geometry, this.beside] = creaseGeometry(motion, view, adjacent);
    for (const lines of [this.marks, this.threads]) {
      lines.geometry = new BufferGeometry();
      for (const [name, attribute] of Object.entries(this.creases.geometry.attributes)) {
        lines.geometry.setAttribute(name, attribute);
      }
    }
    const edges = this.beside.length / 2;
    const many = edges > MANY;
    this.threads.geometry.setIndex(new BufferAttribute(Uint32Array.from({ length: many ? 2 * edges : 0 }, (_, i) => 4 * (i >> 1) + (i & 1)), 1));
    this.meanEdge = many ? meanSide(motion) : Infinity;
    this.mark(this.marked);
    this.upload();
  }

  /** Values at vertices, spread over panels. */
  setValues(values: Float32Array | null): void {
    const { motion } = this;
    if (!motion) return;
    const atCorners = Float32Array.from(motion.faces, (vertex) => {
      const value = values ? values[vertex]! : NaN;
      return Number.isNaN(value) ? UNKNOWN : value;
    });
    const attribute = this.panels.geometry.getAttribute("amount") as BufferAttribute;
    (attribute.array as Float32Array).set(atCorners);
    attribute.needsUpdate = true;
    this.boards.setValues(atCorners);
  }

  /** Panels whose outlines are seen through the others. */
  mark(panels: number[]): void {
    this.marked = panels;
    const edges: number[] = [];
    for (let i = 0; panels.length && i < this.beside.length; i++) {
      if (panels.includes(this.beside[i]!)) edges.push(i >> 1);
    }
    this.marks.visible = edges.length > 0;
    if (edges.length) this.marks.geometry.setIndex(new BufferAttribute(quadIndex(edges), 1));
  }

  /** Choose between lines and threads; `pixels` are those of a unit of length. */
  setScale(pixels: number): void {
    const length = this.meanEdge * pixels;
    this.threads.visible = length < SHORT;
    this.creases.visible = !this.threads.visible;
    this.thread.value = Math.max(0.12, (length / SHORT) ** 2);
  }

  /** Send the poses of the state drawn. */
  upload(): void {
    (this.poses.value.image.data as Float32Array).set(this.motion!.pose);
    this.poses.value.needsUpdate = true;
  }

  dispose(): void {
    this.disposeGeometries();
    this.boards.dispose();
    for (const mesh of [this.panels, this.depth, this.creases, this.threads, this.marks]) mesh.material.dispose();
    this.poses.value.dispose();
    this.corners.value.dispose();
  }

  private disposeGeometries(): void {
    for (const mesh of [this.panels, this.creases, this.threads, this.marks]) mesh.geometry.dispose();
  }
}

/** Mean length of panels' first two sides. */
function meanSide(motion: Motion): number {
  let sum = 0;
  const c = motion.corners;
  for (let at = 0; at < c.length; at += 12) {
    for (const [a, b] of [[0, 3], [3, 6]] as const) {
      sum += Math.hypot(c[at + a]! - c[at + b]!, c[at + a + 1]! - c[at + b + 1]!, c[at + a + 2]! - c[at + b + 2]!);
    }
  }
  return sum / (2 * motion.panels);
}

/** Numbers for the shaders: so many texels for each panel. */
function texture(each: number, rows: number): DataTexture {
  const made = new DataTexture(new Float32Array(4 * each * ROW * rows), each * ROW, rows, RGBAFormat, FloatType);
  made.magFilter = made.minFilter = NearestFilter;
  made.needsUpdate = true;
  return made;
}

function writeCorners(motion: Motion, adjacent: Int32Array, held: DataTexture): void {
  const texels = held.image.data as Float32Array;
  for (let corner = 0; corner < 4 * motion.panels; corner++) {
    for (let axis = 0; axis < 3; axis++) texels[4 * corner + axis] = motion.corners[3 * corner + axis]!;
    texels[4 * corner + 3] = -1;
  }
  const filled = new Uint8Array(motion.panels);
  const note = (panel: number, other: number): void => {
    const place = filled[panel]!++;
    if (place < 4) texels[16 * panel + 4 * place + 3] = other;
  };
  for (let e = 0; e < adjacent.length; e += 2) {
    if (adjacent[e]! < 0 || adjacent[e + 1]! < 0) continue;
    note(adjacent[e]!, adjacent[e + 1]!);
    note(adjacent[e + 1]!, adjacent[e]!);
  }
  held.needsUpdate = true;
}

function panelGeometry(motion: Motion): BufferGeometry {
  const count = motion.panels;
  const index = new Uint32Array(6 * count);
  for (let panel = 0; panel < count; panel++) {
    const v = 4 * panel;
    index.set([v, v + 1, v + 2, v, v + 2, v + 3], 6 * panel);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("amount", new BufferAttribute(new Float32Array(4 * count), 1));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

function creaseGeometry(motion: Motion, view: View, adjacent: Int32Array): [BufferGeometry, Int32Array] {
  const count = view.edges.length / 2;
  const ends = new Float32Array(16 * count), letters = new Float32Array(4 * count);
  const beside = new Int32Array(2 * count);
  let n = 0;
  for (let e = 0; e < count; e++) {
    const first = adjacent[2 * e]!;
    if (first < 0) continue;
    const other = adjacent[2 * e + 1]! < 0 ? first : adjacent[2 * e + 1]!;
    const from = view.edges[2 * e]!, to = view.edges[2 * e + 1]!;
    for (let k = 0; k < 4; k++) {
      const at = 16 * n + 4 * k;
      ends[at] = motion.cornerOf(first, from);
      ends[at + 1] = motion.cornerOf(first, to);
      ends[at + 2] = motion.cornerOf(other, from);
      ends[at + 3] = motion.cornerOf(other, to);
      letters[4 * n + k] = view.assignment[e]!;
    }
    beside[2 * n] = first;
    beside[2 * n + 1] = other;
    n++;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("ends", new BufferAttribute(ends.subarray(0, 16 * n), 4));
  geometry.setAttribute("letter", new BufferAttribute(letters.subarray(0, 4 * n), 1));
  geometry.setIndex(new BufferAttribute(quadIndex(Array.from({ length: n }, (_, i) => i)), 1));
  return [geometry, beside.subarray(0, 2 * n)];
}
