// The ground that a shell stands on: z = 0 of the world at its target where it stands there; in other
// states of its motion as far below the shell's lowest point as there.

import { drives, stateCount, targetPoints, vertexCount, type View } from "./view.ts";

/** A shell whose lowest point is nearer to z = 0 than this share of its height stands there. */
const NEAR = 0.1;
/** What is nearer to the ground than this share of the shell's size stands on it. */
const TOUCHES = 1e-3;

export class Ground {
  constructor(
    private readonly drives: Float64Array,
    private readonly levels: Float64Array,
    /** Height at the target, about the view's origin. */
    readonly atTarget: number,
  ) {}

  /** Height below the state at a drive, about the view's origin. */
  levelAt(drive: number): number {
    return between(this.drives, this.levels, drive);
  }
}

/** What is known in states, by their drives, at a drive between them. */
export function between(drives: ArrayLike<number>, values: ArrayLike<number>, drive: number): number {
  const last = values.length - 1;
  const rising = drives[last]! >= drives[0]!;
  let k = 0;
  while (k < last - 1 && (rising ? drives[k + 1]! <= drive : drives[k + 1]! >= drive)) k++;
  if (last < 1) return values[0] ?? 0;
  const t = (drive - drives[k]!) / (drives[k + 1]! - drives[k]!);
  return values[k]! + Math.min(1, Math.max(0, t)) * (values[k + 1]! - values[k]!);
}

const known = new WeakMap<View, Ground>();

/** The ground of a shell, found once. */
export function groundOf(view: View): Ground {
  const ground = known.get(view) ?? found(view);
  known.set(view, ground);
  return ground;
}

function found(view: View): Ground {
  const count = view.positions.length ? stateCount(view) : 0, size = 3 * vertexCount(view);
  const lows = new Float64Array(count);
  for (let state = 0; state < count; state++) lows[state] = range(view.positions.subarray(state * size, (state + 1) * size))[0];
  const target = targetPoints(view);
  if (!target) return new Ground(new Float64Array([0]), new Float64Array([0]), 0);
  const [low, high] = range(target);
  const zero = -view.header.origin[2];
  const atTarget = Math.abs(zero - low) <= NEAR * (high - low) ? zero : low;
  return new Ground(drives(view), lows.map((each) => each + atTarget - low), atTarget);
}

/** Vertices that stand on the ground at the target. */
export function feetOf(view: View, ground: Ground): number[] {
  const points = targetPoints(view);
  if (!points) return [];
  const [low, high] = range(points);
  const near = TOUCHES * (high - low);
  const feet: number[] = [];
  for (let v = 0; v < points.length / 3; v++) if (Math.abs(points[3 * v + 2]! - ground.atTarget) <= near) feet.push(v);
  return feet;
}

/** Lowest and highest z of points (n, 3). */
function range(points: Float32Array): [number, number] {
  let low = Infinity, high = -Infinity;
  for (let i = 2; i < points.length; i += 3) {
    if (points[i]! < low) low = points[i]!;
    if (points[i]! > high) high = points[i]!;
  }
  return [low, high];
}
