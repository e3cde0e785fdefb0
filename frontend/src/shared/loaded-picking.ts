// What lies under a ray, and where corners of panels are, of a shell that a load case displaces.

import { Ray, Vector3 } from "three";
import type { Loaded } from "./view.ts";

const [a, b, c, hit] = [0, 1, 2, 3].map(() => new Vector3()) as [Vector3, Vector3, Vector3, Vector3];

export class LoadedPicking {
  /** Nodes of every panel. */
  private readonly of = new Map<number, Set<number>>();

  /** `nodes`: (N, 3) the nodes as they are drawn. */
  constructor(private readonly loaded: Loaded, private readonly nodes: Float32Array) {
    const { triangles, panels, ofPanels } = loaded;
    for (let k = 0; k < ofPanels; k++) {
      const nodesOf = this.of.get(panels[k]!) ?? new Set();
      for (let corner = 0; corner < 3; corner++) nodesOf.add(triangles[3 * k + corner]!);
      this.of.set(panels[k]!, nodesOf);
    }
  }

  /** The nearest panel that a ray meets, and how far along it; what stiffens the sheet hides panels. */
  hit(origin: Vector3, direction: Vector3): { panel: number; along: number } | null {
    const { triangles, panels, ofPanels } = this.loaded;
    const ray = new Ray(origin, direction);
    let nearest = Infinity, found = -1;
    for (let k = 0; k < triangles.length / 3; k++) {
      a.fromArray(this.nodes, 3 * triangles[3 * k]!);
      b.fromArray(this.nodes, 3 * triangles[3 * k + 1]!);
      c.fromArray(this.nodes, 3 * triangles[3 * k + 2]!);
      if (!ray.intersectTriangle(a, b, c, false, hit)) continue;
      const along = hit.distanceTo(origin);
      if (along >= nearest) continue;
      nearest = along;
      found = k;
    }
    return found < 0 || found >= ofPanels ? null : { panel: panels[found]!, along: nearest };
  }

  /** Where a place of a panel, a corner of it, is drawn: that of the panel's node there. */
  moved(panel: number, place: Vector3): Vector3 {
    let nearest = Infinity, at = -1;
    for (const node of this.of.get(panel) ?? []) {
      const away = a.fromArray(this.loaded.points, 3 * node).distanceToSquared(place);
      if (away >= nearest) continue;
      nearest = away;
      at = node;
    }
    return at < 0 ? place : place.fromArray(this.nodes, 3 * at);
  }
}
