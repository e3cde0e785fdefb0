// Where two panels are nearest to each other.

import { Vector3 } from "three";

export interface Nearest {
  gap: number;
  /** In the middle between them. */
  point: Vector3;
}

/** The nearest points of two quadrilaterals of four corners each, lying in two planes. */
export function nearestOf(one: Vector3[], other: Vector3[]): Nearest {
  let gap = Infinity;
  const point = new Vector3();
  const offer = (a: Vector3, b: Vector3): void => {
    const apart = a.distanceTo(b);
    // Not a number where a side has no length: its corners are offered with the sides beside it.
    if (!(apart < gap)) return;
    gap = apart;
    point.addVectors(a, b).multiplyScalar(0.5);
  };
  for (let i = 0; i < 4; i++) {
    for (let j = 0; j < 4; j++) offer(...betweenLines(one[i]!, one[(i + 1) & 3]!, other[j]!, other[(j + 1) & 3]!));
  }
  for (const [from, to] of [[one, other], [other, one]] as const) {
    for (const corner of from) {
      const foot = footInside(corner, to);
      if (foot) offer(corner, foot);
    }
  }
  return { gap, point };
}

/** Nearest points of two line segments. */
function betweenLines(p: Vector3, q: Vector3, r: Vector3, s: Vector3): [Vector3, Vector3] {
  const u = q.clone().sub(p), v = s.clone().sub(r), w = p.clone().sub(r);
  const a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(w), e = v.dot(w);
  const det = a * c - b * b;
  let along = det > 1e-12 * a * c ? clamp((b * e - c * d) / det) : 0;
  let beside = clamp((b * along + e) / c);
  along = clamp((b * beside - d) / a);
  beside = clamp((b * along + e) / c);
  return [p.clone().addScaledVector(u, along), r.clone().addScaledVector(v, beside)];
}

/** Foot of the perpendicular on a panel, if it lies in it. */
function footInside(point: Vector3, panel: Vector3[]): Vector3 | null {
  const [a, b, c, d] = panel as [Vector3, Vector3, Vector3, Vector3];
  const normal = c.clone().sub(a).cross(d.clone().sub(b)).normalize();
  const foot = point.clone().addScaledVector(normal, -normal.dot(point.clone().sub(a)));
  const inside = (x: Vector3, y: Vector3, z: Vector3): boolean =>
    // On the line of a triangle without area nothing is inside.
    y.clone().sub(x).cross(z.clone().sub(x)).dot(normal) > 0 &&
    ([[x, y], [y, z], [z, x]] as const).every(([from, to]) => to.clone().sub(from).cross(foot.clone().sub(from)).dot(normal) >= 0);
  return inside(a, b, c) || inside(a, c, d) ? foot : null;
}

function clamp(value: number): number {
  return Math.min(1, Math.max(0, value));
}
