// Panels as rigid bodies: a pose (turn and place) in every state, and between two states the turn
// in between (slerp) about the panel's centre. Vertices are never interpolated: panels keep shape.

import { Matrix4, Quaternion, Vector3 } from "three";

import { shareOf } from "./stops.ts";
import { drives, panelCount, vertexCount, type View } from "./view.ts";

/** Poses are kept for all states up to so many numbers, otherwise for the latest three. */
const KEPT = 12_000_000;

/** Numbers of a pose as drawn: quaternion x y z w, centre x y z, 0. */
export const POSE = 8;

// Written over and over: a large sheet has a hundred thousand panels to place.
const turn = new Quaternion(), other = new Quaternion(), frame = new Matrix4();
const point = new Vector3(), centre = new Vector3(), axis = new Vector3(), normal = new Vector3();
const vertices = [0, 1, 2, 3].map(() => new Vector3());

export class Motion {
  readonly panels: number;
  readonly states: number;
  /** First and last drive; states between are found by their drive. */
  readonly drives: Float64Array;
  /** Corners (F, 4, 3) in the frame of their panel, about its centre. */
  readonly corners: Float32Array;
  /** Corners are listed so that the diagonal from the first to the third lies in the panel. */
  readonly faces: Uint32Array;
  /** Distance of the farthest corner from the centre (F,). */
  readonly radius: Float32Array;
  /** Poses of the state drawn, see POSE. */
  readonly pose: Float32Array;

  private readonly cache = new Map<number, Float32Array>();
  private readonly kept: number;
  private readonly vertices: number;
  private readonly reference: Float32Array;

  constructor(private readonly view: View) {
    this.panels = panelCount(view);
    this.vertices = vertexCount(view);
    this.states = view.positions.length / (3 * this.vertices) || 0;
    this.drives = this.states > 1 ? drives(view) : new Float64Array([0]);
    this.reference = view.flat.length ? raised(view.flat) : view.positions.subarray(0, 3 * this.vertices);
    this.faces = withInnerDiagonal(view.faces, this.reference);
    this.corners = new Float32Array(12 * this.panels);
    this.radius = new Float32Array(this.panels);
    this.pose = new Float32Array(POSE * this.panels);
    this.kept = Math.max(3, Math.floor(KEPT / (POSE * Math.max(1, this.panels))));
    this.measureCorners();
    this.setFold(0);
  }

  /** Share of the way from the first drive to the last. */
  shareOf(drive: number): number {
    return shareOf(this.drives, drive);
  }

  driveAt(share: number): number {
    const first = this.drives[0]!, last = this.drives[this.drives.length - 1]!;
    return first + share * (last - first);
  }

  /** Pose every panel at a share of the way: 0 the first state, 1 the last. */
  setFold(share: number): void {
    if (this.states < 2) {
      this.pose.set(this.posesOf(0));
      return;
    }
    const drive = this.driveAt(Math.min(1, Math.max(0, share)));
    const rising = this.drives[this.states - 1]! > this.drives[0]!;
    let k = 0;
    while (k < this.states - 2 && (rising ? this.drives[k + 1]! <= drive : this.drives[k + 1]! >= drive)) k++;
    const t = (drive - this.drives[k]!) / (this.drives[k + 1]! - this.drives[k]!);
    // A slider's number lies a rounding off a state: the state itself is drawn then.
    if (t < 1e-9) this.pose.set(this.posesOf(k));
    else if (t > 1 - 1e-9) this.pose.set(this.posesOf(k + 1));
    else blend(this.posesOf(k), this.posesOf(k + 1), t, this.pose);
  }

  /** Number of a panel's corner: four times the panel's, and which of the four. */
  cornerOf(panel: number, vertex: number): number {
    const at = 4 * panel;
    for (let k = 0; k < 3; k++) if (this.faces[at + k] === vertex) return at + k;
    return at + 3;
  }

  /** Corners (4, 3) of a panel as drawn. */
  place(panel: number, out: Float32Array | Float64Array): void {
    const { pose, corners } = this;
    const p = POSE * panel;
    turn.fromArray(pose, p);
    centre.fromArray(pose, p + 4);
    for (let corner = 0; corner < 4; corner++) {
      point.fromArray(corners, 12 * panel + 3 * corner).applyQuaternion(turn).add(centre);
      point.toArray(out, 3 * corner);
    }
  }

  /** Largest relative change of the six distances between a panel's corners as drawn. */
  maxStrain(): number {
    const at = new Float64Array(12);
    let largest = 0;
    for (let panel = 0; panel < this.panels; panel++) {
      this.place(panel, at);
      for (let i = 0; i < 4; i++) {
        for (let j = i + 1; j < 4; j++) {
          const u = 3 * this.faces[4 * panel + i]!, v = 3 * this.faces[4 * panel + j]!;
          const before = distance(this.reference, u, v);
          const now = Math.hypot(
            at[3 * i]! - at[3 * j]!, at[3 * i + 1]! - at[3 * j + 1]!, at[3 * i + 2]! - at[3 * j + 2]!,
          );
          largest = Math.max(largest, Math.abs(now - before) / before);
        }
      }
    }
    return largest;
  }

  /** Place of a corner by its number, as drawn. */
  at(corner: number, out: Vector3): Vector3 {
    const p = POSE * (corner >> 2);
    out.fromArray(this.corners, 3 * corner).applyQuaternion(turn.fromArray(this.pose, p));
    return out.add(centre.fromArray(this.pose, p + 4));
  }

  /** Nearest panel that a ray meets in the state drawn, -1 if none. */
  pick(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number): number {
    return this.hit(ox, oy, oz, dx, dy, dz)?.panel ?? -1;
  }

  /** The same, and how far along the ray. */
  hit(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number): { panel: number; along: number } | null {
    const { pose, corners, radius } = this;
    let nearest = Infinity, found = -1;
    for (let panel = 0; panel < this.panels; panel++) {
      const p = POSE * panel;
      const px = ox - pose[p + 4]!, py = oy - pose[p + 5]!, pz = oz - pose[p + 6]!;
      const along = px * dx + py * dy + pz * dz;
      const apart = px * px + py * py + pz * pz - along * along;
      if (apart > radius[panel]! * radius[panel]!) continue;
      // The ray in the panel's frame, where the panel lies in z = 0.
      turn.fromArray(pose, p).conjugate();
      const from = point.set(px, py, pz).applyQuaternion(turn);
      const way = axis.set(dx, dy, dz).applyQuaternion(turn);
      if (Math.abs(way.z) < 1e-12) continue;
      const t = -from.z / way.z;
      if (t <= 0 || t >= nearest) continue;
      const hx = from.x + t * way.x, hy = from.y + t * way.y;
      const c = 12 * panel;
      if (inTriangle(corners, c, c + 3, c + 6, hx, hy) || inTriangle(corners, c, c + 6, c + 9, hx, hy)) {
        nearest = t;
        found = panel;
      }
    }
    return found < 0 ? null : { panel: found, along: nearest };
  }

  /** Poses of a given state. */
  private posesOf(state: number): Float32Array {
    const known = this.cache.get(state);
    if (known) return known;
    if (this.cache.size >= this.kept) this.cache.delete(this.cache.keys().next().value!);
    const poses = new Float32Array(POSE * this.panels);
    const size = 3 * this.vertices;
    const points = this.states ? this.view.positions.subarray(state * size, (state + 1) * size) : this.reference;
    for (let panel = 0; panel < this.panels; panel++) writePose(points, this.faces, panel, poses);
    const { shifts } = this.view;
    if (shifts && this.states) {
      const first = 3 * this.panels * state;
      for (let panel = 0; panel < this.panels; panel++) {
        for (let i = 0; i < 3; i++) poses[POSE * panel + 4 + i]! += shifts[first + 3 * panel + i]!;
      }
    }
    this.cache.set(state, poses);
    return poses;
  }

  /** Points (P, 3) of the flat sheet and over it, each in the frame of its panel. */
  inPanels(points: Float32Array, panels: ArrayLike<number>): Float32Array {
    const own = this.referencePoses();
    const local = new Float32Array(points.length);
    for (let k = 0; k < panels.length; k++) {
      turn.fromArray(own, POSE * panels[k]!).conjugate();
      centre.fromArray(own, POSE * panels[k]! + 4);
      point.fromArray(points, 3 * k).sub(centre).applyQuaternion(turn).toArray(local, 3 * k);
    }
    return local;
  }

  private referencePoses(): Float32Array {
    const own = new Float32Array(POSE * this.panels);
    for (let panel = 0; panel < this.panels; panel++) writePose(this.reference, this.faces, panel, own);
    return own;
  }

  private measureCorners(): void {
    const own = this.referencePoses();
    const { faces, reference, corners, radius } = this;
    for (let panel = 0; panel < this.panels; panel++) {
      turn.fromArray(own, POSE * panel).conjugate();
      centre.fromArray(own, POSE * panel + 4);
      for (let corner = 0; corner < 4; corner++) {
        point.fromArray(reference, 3 * faces[4 * panel + corner]!).sub(centre);
        radius[panel] = Math.max(radius[panel]!, point.length() * 1.001);
        point.applyQuaternion(turn).toArray(corners, 12 * panel + 3 * corner);
      }
    }
  }
}

function raised(flat: Float32Array): Float32Array {
  const points = new Float32Array((flat.length / 2) * 3);
  for (let v = 0; v < flat.length / 2; v++) {
    points[3 * v] = flat[2 * v]!;
    points[3 * v + 1] = flat[2 * v + 1]!;
  }
  return points;
}

function distance(points: Float32Array, u: number, v: number): number {
  return Math.hypot(points[u]! - points[v]!, points[u + 1]! - points[v + 1]!, points[u + 2]! - points[v + 2]!);
}

/** A quad that is notched at its second or fourth corner is listed from the next corner on. */
function withInnerDiagonal(faces: Uint32Array, points: Float32Array): Uint32Array {
  const turned = new Uint32Array(faces);
  for (let f = 0; f < faces.length; f += 4) {
    const [a, b, c, d] = [faces[f]!, faces[f + 1]!, faces[f + 2]!, faces[f + 3]!];
    const n = cross(points, a, c, b, d);
    const first = cross(points, a, b, a, c), second = cross(points, a, c, a, d);
    const inside = dot(first, n) >= 0 && dot(second, n) >= 0;
    if (!inside) turned.set([b, c, d, a], f);
  }
  return turned;
}

function cross(p: Float32Array, a: number, b: number, c: number, d: number): [number, number, number] {
  const x = p[3 * b]! - p[3 * a]!, y = p[3 * b + 1]! - p[3 * a + 1]!, z = p[3 * b + 2]! - p[3 * a + 2]!;
  const u = p[3 * d]! - p[3 * c]!, v = p[3 * d + 1]! - p[3 * c + 1]!, w = p[3 * d + 2]! - p[3 * c + 2]!;
  return [y * w - z * v, z * u - x * w, x * v - y * u];
}

function dot(a: [number, number, number], b: [number, number, number]): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Frame of a panel: first axis along its diagonal, third its normal. */
function writePose(points: Float32Array, faces: Uint32Array, panel: number, out: Float32Array): void {
  const [a, b, c, d] = [0, 1, 2, 3].map((corner) => vertices[corner]!.fromArray(points, 3 * faces[4 * panel + corner]!));
  axis.subVectors(c!, a!).normalize();
  normal.crossVectors(axis, point.subVectors(d!, b!)).normalize();
  frame.makeBasis(axis, point.crossVectors(normal, axis), normal);
  turn.setFromRotationMatrix(frame).toArray(out, POSE * panel);
  a!.add(b!).add(c!).add(d!).divideScalar(4).toArray(out, POSE * panel + 4);
}

/** Poses between two states: the shorter turn, evenly (slerp), and centres straight. */
function blend(from: Float32Array, to: Float32Array, t: number, out: Float32Array): void {
  for (let p = 0; p < out.length; p += POSE) {
    turn.fromArray(from, p).slerp(other.fromArray(to, p), t).toArray(out, p);
    for (let i = p + 4; i < p + 7; i++) out[i] = (1 - t) * from[i]! + t * to[i]!;
  }
}

function inTriangle(c: Float32Array, i: number, j: number, k: number, x: number, y: number): boolean {
  const a = (c[j]! - c[i]!) * (y - c[i + 1]!) - (c[j + 1]! - c[i + 1]!) * (x - c[i]!);
  const b = (c[k]! - c[j]!) * (y - c[j + 1]!) - (c[k + 1]! - c[j + 1]!) * (x - c[j]!);
  const d = (c[i]! - c[k]!) * (y - c[k + 1]!) - (c[i + 1]! - c[k + 1]!) * (x - c[k]!);
  return (a >= 0 && b >= 0 && d >= 0) || (a <= 0 && b <= 0 && d <= 0);
}
