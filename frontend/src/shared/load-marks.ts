// What loads a shell and what holds it: an arrow for every panel, a mark for every support.

import { Vector3 } from "three";
import type { Theme } from "./colours.ts";
import { extentOf } from "./camera.ts";
import { Lines3D } from "./marks3d.ts";
import type { Uniforms } from "./parts.ts";
import { Held, type Loaded } from "./view.ts";

/** Of the shell's radius: the longest arrow, and the size of a support. */
const ARROW = 0.22;
const SUPPORT = 0.035;
/** Of an arrow its head, and half the width of that. */
const HEAD = 0.22;
const WIDE = 0.09;
/** Shorter arrows than this share of the longest are left out. */
const SHORTEST = 0.02;
/** Of more panels every k-th has an arrow; of more supports every k-th a mark. */
const MOST = 600;

export class LoadMarks {
  /** The largest load on a panel (N). */
  force = 0;
  private readonly arrows;
  private readonly supports;

  constructor(uniforms: Uniforms) {
    this.arrows = new Lines3D(uniforms, { width: 1.6 });
    this.supports = new Lines3D(uniforms, { width: 2 });
  }

  get drawn() {
    return [...this.arrows.drawn, ...this.supports.drawn];
  }

  /** Of a case, on panels where their nodes (N, 3) are drawn. */
  build(loaded: Loaded, number: number, nodes: Float32Array): void {
    const { radius } = extentOf([loaded.points]);
    this.arrows.set(Float32Array.from(this.arrowsOf(loaded, number, nodes, ARROW * radius)));
    const marks: number[] = [], { held, points } = loaded;
    for (const k of every(held.length / 2)) marks.push(...supportMark(points.subarray(3 * held[2 * k]!, 3 * held[2 * k]! + 3), held[2 * k + 1]!, SUPPORT * radius));
    this.supports.set(Float32Array.from(marks));
  }

  paint(theme: Theme): void {
    this.arrows.setColour(theme.linear("--load"));
    this.supports.setColour(theme.linear("--foot"));
  }

  dispose(): void {
    this.arrows.dispose();
    this.supports.dispose();
  }

  /** Ends of lines: arrows outside the shell, which push to the middle of their panels or pull from it. */
  private arrowsOf(loaded: Loaded, number: number, nodes: Float32Array, longest: number): number[] {
    const panels = loaded.loads.length / 3 / loaded.cases.length;
    const force = (panel: number): Vector3 => new Vector3().fromArray(loaded.loads, 3 * (number * panels + panel));
    this.force = 0;
    for (let panel = 0; panel < panels; panel++) this.force = Math.max(this.force, force(panel).length());
    const faces = facesOf(loaded, nodes, panels), lines: number[] = [];
    for (const panel of every(panels)) {
      const way = force(panel).multiplyScalar(longest / (this.force || 1)), size = way.length();
      if (!(size > SHORTEST * longest)) continue;
      const { middle, outward } = faces[panel]!, pulls = way.dot(outward) > 0;
      const tip = pulls ? middle.clone().add(way) : middle, tail = tip.clone().sub(way);
      const side = new Vector3().crossVectors(way, Math.abs(way.z) > 0.7 * size ? new Vector3(1, 0, 0) : new Vector3(0, 0, 1)).setLength(WIDE * size);
      const neck = tip.clone().addScaledVector(way, -HEAD);
      lines.push(...tail, ...tip, ...tip, ...neck.clone().add(side), ...tip, ...neck.clone().sub(side));
    }
    return lines;
  }
}

/** Middle of every panel, and the way out of the shell there: most of it looks up. */
function facesOf({ triangles, panels, ofPanels }: Loaded, nodes: Float32Array, count: number): { middle: Vector3; outward: Vector3 }[] {
  const faces = Array.from({ length: count }, () => ({ middle: new Vector3(), outward: new Vector3(), corners: 0 }));
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  let up = 0;
  for (let k = 0; k < ofPanels; k++) {
    const face = faces[panels[k]!]!;
    [a, b, c].forEach((corner, which) => {
      corner.fromArray(nodes, 3 * triangles[3 * k + which]!);
      face.middle.add(corner);
      face.corners++;
    });
    const area = b.sub(a).cross(c.sub(a));
    face.outward.add(area);
    up += area.z;
  }
  for (const { middle, outward, corners } of faces) {
    middle.divideScalar(corners || 1);
    if (up < 0) outward.negate();
  }
  return faces;
}

/** A pyramid below a pinned node, with a line below it where that slides, and a box round a clamped one. */
function supportMark(point: Float32Array, kind: number, size: number): number[] {
  const [x, y, z] = point as unknown as [number, number, number];
  const ring = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => [x + 0.7 * size * u!, y + 0.7 * size * v!] as const);
  const lines: number[] = [];
  const square = (height: number): void => ring.forEach(([u, v], k) => lines.push(u, v, height, ...ring[(k + 1) % 4]!, height));
  square(z - 1.4 * size);
  if (kind === Held.clamped) {
    square(z);
    for (const [u, v] of ring) lines.push(u, v, z, u, v, z - 1.4 * size);
  } else {
    for (const [u, v] of ring) lines.push(x, y, z, u, v, z - 1.4 * size);
    if (kind === Held.up) square(z - 1.9 * size);
  }
  return lines;
}

function* every(count: number): Generator<number> {
  const step = Math.ceil(count / MOST) || 1;
  for (let k = 0; k < count; k += step) yield k;
}
