// The shell under a load case as the graphics card holds it: its triangles and lines, displaced.

import { BufferAttribute, BufferGeometry, Group, Vector3 } from "three";
import { LoadMarks } from "./load-marks.ts";
import { AMOUNT_MAP, mapTexels, type Theme } from "./colours.ts";
import { amountsOf, rimOf, rimsOf, type Deflection, type Measure } from "./loaded.ts";
import { LoadedPicking } from "./loaded-picking.ts";
import { Lines3D } from "./marks3d.ts";
import { mapTexture } from "./maps.ts";
import { material, part, quadIndex, type Part, type Uniforms } from "./parts.ts";
import { lineFragment, loadedFragment, loadedLineVertex, loadedVertex } from "./shaders.ts";
import type { Loaded } from "./view.ts";

/** A load case, what its colours mean, and how many times as large displacements are drawn. */
export interface Shown {
  deflection: Deflection;
  measure: Measure;
  scale: number;
}

/** With the most that its colours show, what has it, and where (but of displacements), and the largest load on a
 * panel (N). */
export type Drawn = Shown & { most: number; of: string | null; at: Vector3 | null; force: number };

/** Stands for a stress that is not known. */
const UNKNOWN = 3e30;

export class Loaded3D {
  readonly drawn = new Group();
  shown: Drawn | null = null;
  /** What is under a place of it, while a case is shown. */
  picking: LoadedPicking | null = null;
  private readonly times = { value: 1 };
  private readonly map = mapTexture(mapTexels(AMOUNT_MAP));
  private readonly panels: Part;
  private readonly creases: Lines;
  /** The sheet's border without loads. */
  private readonly before: Lines;
  private readonly ties: Lines;
  private readonly marks: LoadMarks;
  /** Round what has the most. */
  private readonly worst: Lines3D;
  private loaded: Loaded | null = null;
  private ends: { rims: Uint32Array; border: Uint32Array } = { rims: new Uint32Array(0), border: new Uint32Array(0) };
  private deflection: Deflection | null = null;

  constructor(shared: Uniforms) {
    const own = { ...shared, times: this.times, amounts: { value: this.map } };
    this.panels = part(material(loadedVertex, loadedFragment, own, {
      polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 4,
    }), 0);
    this.creases = new Lines(own, 1, 2);
    this.before = new Lines({ ...own, times: { value: 0 } }, 1.2, 2);
    this.ties = new Lines(own, 2.6, 2);
    this.marks = new LoadMarks(shared);
    this.worst = new Lines3D(shared, { width: 3.2, through: 0.5 });
    this.drawn.add(this.panels, this.creases.mesh, this.before.mesh, this.ties.mesh, ...this.marks.drawn, ...this.worst.drawn);
    this.drawn.visible = false;
  }

  show(loaded: Loaded | null): void {
    this.loaded = loaded;
    this.deflection = null;
    if (loaded) this.ends = rimsOf(loaded);
  }

  set(shown: Shown | null): void {
    const { loaded } = this;
    this.shown = this.picking = null;
    this.drawn.visible = false;
    if (!shown || !loaded) return;
    this.drawn.visible = true;
    const { deflection, measure, scale } = shown;
    if (deflection !== this.deflection) this.build(loaded, deflection);
    const nodes = loaded.points.map((value, k) => value + scale * deflection.displacements[k]!);
    this.marks.build(loaded, deflection.number, nodes);
    this.picking = new LoadedPicking(loaded, nodes);
    const { shares, most, of } = amountsOf(loaded, deflection, measure);
    const known = shares.map((share) => (Number.isNaN(share) ? UNKNOWN : share));
    this.panels.geometry.setAttribute("amount", new BufferAttribute(known, 1));
    this.times.value = scale;
    this.shown = { ...shown, most, of: of === null ? null : loaded.called(of), at: this.flag(loaded, of, nodes), force: this.marks.force };
  }

  /** Draw the rim of what has the most; the middle of it. */
  private flag(loaded: Loaded, of: number | null, nodes: Float32Array): Vector3 | null {
    const ends = of === null ? [] : [...rimOf(loaded, of)];
    this.worst.visible = ends.length > 0;
    if (!ends.length) return null;
    const rim = ends.map((node) => new Vector3().fromArray(nodes, 3 * node));
    this.worst.set(Float32Array.from(rim.flatMap((each) => [...each])));
    return rim.reduce((sum, each) => sum.add(each), new Vector3()).divideScalar(rim.length);
  }

  paint(theme: Theme): void {
    this.creases.ink.value = theme.linear("--crease");
    this.before.ink.value = theme.linear("--text-2");
    this.ties.ink.value = theme.linear("--tie");
    this.marks.paint(theme);
    this.worst.setColour(theme.linear("--accent"));
  }

  dispose(): void {
    this.map.dispose();
    this.marks.dispose();
    this.worst.dispose();
    for (const mesh of [this.panels, this.creases.mesh, this.before.mesh, this.ties.mesh]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }

  private build(loaded: Loaded, deflection: Deflection): void {
    const { points, triangles, ties } = loaded, { displacements } = deflection;
    this.deflection = deflection;
    this.panels.geometry.dispose();
    this.panels.geometry = new BufferGeometry();
    this.panels.geometry.setAttribute("position", new BufferAttribute(at(points, triangles), 3));
    this.panels.geometry.setAttribute("moved", new BufferAttribute(at(displacements, triangles), 3));
    this.creases.build(points, displacements, this.ends.rims);
    this.before.build(points, displacements, this.ends.border);
    this.ties.build(points, displacements, ties);
  }
}

/** Lines between nodes, displaced with them. */
class Lines {
  readonly mesh: Part;
  readonly ink = { value: [0, 0, 0] };

  constructor(shared: Uniforms, width: number, order: number) {
    const own = { ...shared, ink: this.ink, width: { value: width }, opacity: { value: 1 } };
    this.mesh = part(material(loadedLineVertex, lineFragment, own, { transparent: true, depthWrite: false }), order);
  }

  build(points: Float32Array, displacements: Float32Array, ends: Uint32Array): void {
    const count = ends.length / 2;
    const corners = (which: number): Uint32Array => Uint32Array.from({ length: 4 * count }, (_, k) => ends[2 * (k >> 2) + which]!);
    const [from, to] = [corners(0), corners(1)];
    const geometry = new BufferGeometry();
    for (const [name, values, nodes] of [
      ["from", points, from], ["to", points, to], ["fromMoved", displacements, from], ["toMoved", displacements, to],
    ] as const) {
      geometry.setAttribute(name, new BufferAttribute(at(values, nodes), 3));
    }
    geometry.setIndex(new BufferAttribute(quadIndex(Array.from({ length: count }, (_, i) => i)), 1));
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }
}

/** Vectors (K, 3) of some nodes (K,). */
function at(vectors: Float32Array, nodes: Uint32Array): Float32Array {
  const found = new Float32Array(3 * nodes.length);
  nodes.forEach((node, k) => found.set(vectors.subarray(3 * node, 3 * node + 3), 3 * k));
  return found;
}
