// Boards as the graphics card holds them: solids that stand still in the frames of their panels and
// are carried by the panels' poses.

import { BufferAttribute, BufferGeometry, FrontSide } from "three";
import { material, part, type Part, type Uniforms } from "./parts.ts";
import type { Motion } from "./rigid.ts";
import { boardFragment, boardVertex } from "./shaders.ts";
import type { Boards, View } from "./view.ts";

/** The pattern of a board's surface, the same for many boards. */
export interface Surface {
  /** Corners of the outlines whose mean each vertex is. */
  sources: number[][];
  /** 0 along edges of faces, 1 in their middle and on the board's sides. */
  rims: number[];
  /** Three vertices each, counter-clockwise from outside; no area where corners coincide. */
  triangles: number[];
}

export class Boards3D {
  readonly solids: Part;
  private readonly covered;
  /** For every vertex the corner of a panel that is near: see the shaders. */
  private near: Float32Array = new Float32Array(0);
  private wanted = true;

  constructor(shared: Uniforms & { covered: { value: number } }) {
    this.covered = shared.covered;
    this.solids = part(material(boardVertex, boardFragment, shared, { side: FrontSide }), 1);
    this.update();
  }

  show(motion: Motion, view: View): void {
    this.solids.geometry.dispose();
    this.solids.geometry = new BufferGeometry();
    this.near = new Float32Array(0);
    if (view.boards && view.flat.length) this.build(motion, view, view.boards);
    this.update();
  }

  setVisible(visible: boolean): void {
    this.wanted = visible;
    this.update();
  }

  /** Values at the corners (4 F,) of panels. */
  setValues(atCorners: Float32Array): void {
    if (!this.near.length) return;
    const attribute = this.solids.geometry.getAttribute("amount") as BufferAttribute;
    (attribute.array as Float32Array).set(this.near.map((corner) => atCorners[corner]!));
    attribute.needsUpdate = true;
  }

  dispose(): void {
    this.solids.geometry.dispose();
    this.solids.material.dispose();
  }

  private build(motion: Motion, view: View, boards: Boards): void {
    const { panels, corners, outlines } = boards;
    const size = boards.heights * corners;
    const [solid, upper, lower] = [[true, true], [false, true], [true, false]].map(([bottom, top]) => surfaceOf(boards, bottom!, top!));
    const chosen = Array.from(panels, (_, board) => {
      // What faces the membrane between two boards is never seen.
      const low = outlines[3 * board * size + 2]!, high = outlines[3 * (board + 1) * size - 1]!;
      if (view.shifts) return solid!; // whole boards, with no membrane
      return low >= 0 ? upper! : high <= 0 ? lower! : solid!;
    });
    const count = chosen.reduce((sum, { rims }) => sum + rims.length, 0);
    const points = new Float32Array(3 * count), rims = new Float32Array(count), of = new Uint32Array(count);
    const index = new Uint32Array(chosen.reduce((sum, { triangles }) => sum + triangles.length, 0));
    this.near = new Float32Array(count);
    let vertex = 0, filled = 0;
    chosen.forEach((surface, board) => {
      const panel = panels[board]!;
      for (const each of surface.triangles) index[filled++] = vertex + each;
      surface.sources.forEach((sources, k) => {
        for (const corner of sources) {
          for (let axis = 0; axis < 3; axis++) {
            points[3 * vertex + axis]! += outlines[3 * (board * size + corner) + axis]! / sources.length;
          }
        }
        // Outlines have one or two corners at each corner of the panel, in its order.
        const which = Math.floor((4 * (sources[0]! % corners)) / corners);
        this.near[vertex] = motion.cornerOf(panel, view.faces[4 * panel + which]!);
        of[vertex] = panel;
        rims[vertex++] = surface.rims[k]!;
      });
    });
    const { geometry } = this.solids;
    geometry.setAttribute("point", new BufferAttribute(motion.inPanels(points, of), 3));
    geometry.setAttribute("corner", new BufferAttribute(this.near, 1));
    geometry.setAttribute("rim", new BufferAttribute(rims, 1));
    geometry.setAttribute("amount", new BufferAttribute(new Float32Array(count), 1));
    geometry.setIndex(new BufferAttribute(index, 1));
  }

  private update(): void {
    this.solids.visible = this.near.length > 0 && this.wanted;
    this.covered.value = Number(this.solids.visible);
  }
}

/** Sides of a board, and which of its faces are wanted, each as a fan about its middle. */
export function surfaceOf(
  { heights, corners }: Pick<Boards, "heights" | "corners">, bottom: boolean, top: boolean,
): Surface {
  const highest = (heights - 1) * corners;
  const sources = Array.from({ length: heights * corners }, (_, corner) => [corner]);
  const rims = sources.map(() => 1);
  const triangles: number[] = [];
  for (let low = 0; low < highest; low += corners) {
    for (let k = 0; k < corners; k++) {
      const a = low + k, b = low + ((k + 1) % corners);
      triangles.push(a, b, b + corners, a, b + corners, a + corners);
    }
  }
  for (const [wanted, low] of [[bottom, 0], [top, highest]] as const) {
    if (!wanted) continue;
    const first = sources.length, ring = Array.from({ length: corners }, (_, k) => low + k);
    for (const corner of ring) sources.push([corner]);
    sources.push(ring);
    rims.push(...ring.map(() => 0), 1);
    for (let k = 0; k < corners; k++) {
      const a = first + k, b = first + ((k + 1) % corners);
      triangles.push(first + corners, ...(low ? [a, b] : [b, a]));
    }
  }
  return { sources, rims, triangles };
}
