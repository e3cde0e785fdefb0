// The spline that the server draws through control points: cubic over chord length, its third
// derivative continuous at the second and the last but one point ("not a knot").

import type { Point } from "../state/types.ts";

const FEWEST = 4;
const MOST = 17;
/** Distance of a fitted spline from the curve, relative to the curve's size. */
const CLOSE = 0.003;
/** The same of a stroke that was drawn by hand, and the points that it is smoothed with. */
const BY_HAND = 0.012;
const STROKE = 80;

/** The spline as a function of the share of the whole chord length. */
export function splineThrough(points: Point[]): (share: number) => Point {
  const knots = chordLengths(points);
  const total = knots.at(-1)!;
  const bends = [0, 1].map((axis) => secondDerivatives(knots, points.map((p) => p[axis]!)));
  return (share) => {
    const t = share * total;
    let k = 0;
    while (k < knots.length - 2 && t > knots[k + 1]!) k++;
    const step = knots[k + 1]! - knots[k]!;
    const b = (t - knots[k]!) / step;
    const a = 1 - b;
    return [0, 1].map((axis) => {
      const [m, n] = [bends[axis]![k]!, bends[axis]![k + 1]!];
      const chord = a * points[k]![axis]! + b * points[k + 1]![axis]!;
      return chord + (((a ** 3 - a) * m + (b ** 3 - b) * n) * step * step) / 6;
    }) as Point;
  };
}

/** As few control points as put a spline on a curve that is given by close samples. */
export function fitPoints(samples: Point[], close = CLOSE): Point[] {
  const lengths = chordLengths(samples);
  const size = Math.hypot(extent(samples, 0), extent(samples, 1));
  let points: Point[] = [];
  for (let count = FEWEST; count <= MOST; count++) {
    points = Array.from({ length: count }, (_, i) => pointAt(samples, lengths, i / (count - 1)));
    if (samples.length <= count) return samples.map(tidy(size));
    if (farthest(samples, splineThrough(points)) < close * size) break;
  }
  return points.map(tidy(size));
}

/** The control points of the cubic pieces between neighbours, two each. */
export function splineControls(points: Point[]): [Point, Point][] {
  const knots = chordLengths(points);
  const bends = [0, 1].map((axis) => secondDerivatives(knots, points.map((p) => p[axis]!)));
  return points.slice(1).map((to, k) => {
    const from = points[k]!;
    const step = knots[k + 1]! - knots[k]!;
    const control = (first: boolean) =>
      [0, 1].map((axis) => {
        const [m, n] = [bends[axis]![k]!, bends[axis]![k + 1]!];
        const third = (to[axis]! - from[axis]!) / 3;
        const bent = (step * step) / 18;
        return first ? from[axis]! + third - bent * (2 * m + n) : to[axis]! - third - bent * (m + 2 * n);
      }) as Point;
    return [control(true), control(false)];
  });
}

/** Few control points for a stroke that a hand drew, its trembling smoothed out. */
export function fitStroke(track: Point[]): Point[] {
  const lengths = chordLengths(track);
  let smooth = Array.from({ length: STROKE }, (_, i) => pointAt(track, lengths, i / (STROKE - 1)));
  for (let pass = 0; pass < 4; pass++) {
    smooth = smooth.map(([x, y], i): Point => {
      const [a, b] = [smooth[i - 1], smooth[i + 1]];
      return a && b ? [(a[0] + 2 * x + b[0]) / 4, (a[1] + 2 * y + b[1]) / 4] : [x, y];
    });
  }
  return fitPoints(smooth, BY_HAND);
}

/**
 * Where a new point goes among the others: between the two neighbours whose part of the curve is
 * nearest, or at an end that it lies beyond.
 */
export function placeAmong(points: Point[], point: Point, smooth = true): number {
  const last = points.length - 1;
  if (last < 1) return last + 1;
  let best = { gap: Infinity, index: 1 };
  const knots = chordLengths(points);
  const spline = splineThrough(points);
  for (let k = 0; k < last; k++) {
    for (let i = 0; i <= 20; i++) {
      const t = i / 20;
      const [a, b] = [points[k]!, points[k + 1]!];
      const at: Point = smooth
        ? spline((knots[k]! + t * (knots[k + 1]! - knots[k]!)) / knots[last]!)
        : [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
      const gap = distance(at, point);
      // The nearest place is an end: the curve goes on there.
      const beyond = (k === 0 && i === 0) || (k === last - 1 && i === 20);
      if (gap < best.gap) best = { gap, index: beyond ? (i === 0 ? 0 : last + 1) : k + 1 };
    }
  }
  return best.index;
}

/** A point of the spline halfway between two neighbouring control points. */
export function between(points: Point[], index: number): Point {
  const knots = chordLengths(points);
  return splineThrough(points)((knots[index]! + knots[index + 1]!) / 2 / knots.at(-1)!);
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

function chordLengths(points: Point[]): number[] {
  const lengths = [0];
  for (let i = 1; i < points.length; i++) {
    lengths.push(lengths[i - 1]! + distance(points[i - 1]!, points[i]!));
  }
  return lengths;
}

function extent(points: Point[], axis: 0 | 1): number {
  const values = points.map((p) => p[axis]);
  return Math.max(...values) - Math.min(...values);
}

function pointAt(samples: Point[], lengths: number[], share: number): Point {
  const at = share * lengths.at(-1)!;
  let k = 0;
  while (k < samples.length - 2 && at > lengths[k + 1]!) k++;
  const step = lengths[k + 1]! - lengths[k]!;
  const part = step > 0 ? (at - lengths[k]!) / step : 0;
  const [a, b] = [samples[k]!, samples[k + 1]!];
  return [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
}

function tidy(size: number): (point: Point) => Point {
  const places = Math.max(0, 3 - Math.floor(Math.log10(size || 1)));
  return ([x, y]) => [Number(x.toFixed(places)) + 0, Number(y.toFixed(places)) + 0];
}

function farthest(samples: Point[], spline: (share: number) => Point): number {
  const drawn = Array.from({ length: 400 }, (_, i) => spline(i / 399));
  let worst = 0;
  for (const sample of samples) {
    let nearest = Infinity;
    for (const point of drawn) nearest = Math.min(nearest, distance(sample, point));
    worst = Math.max(worst, nearest);
  }
  return worst;
}

function secondDerivatives(knots: number[], values: number[]): number[] {
  const n = values.length;
  if (n === 2) return [0, 0];
  const h = Array.from({ length: n - 1 }, (_, i) => knots[i + 1]! - knots[i]!);
  const slope = h.map((step, i) => (values[i + 1]! - values[i]!) / step);
  if (n === 3) return new Array<number>(3).fill((2 * (slope[1]! - slope[0]!)) / (h[0]! + h[1]!));
  const rows: number[][] = [];
  for (let i = 0; i < n; i++) {
    const row = new Array<number>(n + 1).fill(0);
    if (i === 0 || i === n - 1) {
      const k = i === 0 ? 1 : n - 2;
      row[k - 1] = h[k]!;
      row[k] = -(h[k - 1]! + h[k]!);
      row[k + 1] = h[k - 1]!;
    } else {
      row[i - 1] = h[i - 1]!;
      row[i] = 2 * (h[i - 1]! + h[i]!);
      row[i + 1] = h[i]!;
      row[n] = 6 * (slope[i]! - slope[i - 1]!);
    }
    rows.push(row);
  }
  return solve(rows);
}

/** Gaussian elimination with pivots; the last entry of each row is its right-hand side. */
function solve(rows: number[][]): number[] {
  const n = rows.length;
  for (let i = 0; i < n; i++) {
    let pivot = i;
    for (let r = i + 1; r < n; r++) {
      if (Math.abs(rows[r]![i]!) > Math.abs(rows[pivot]![i]!)) pivot = r;
    }
    [rows[i], rows[pivot]] = [rows[pivot]!, rows[i]!];
    for (let r = i + 1; r < n; r++) {
      const factor = rows[r]![i]! / rows[i]![i]!;
      if (factor !== 0) for (let c = i; c <= n; c++) rows[r]![c]! -= factor * rows[i]![c]!;
    }
  }
  const result = new Array<number>(n).fill(0);
  for (let i = n - 1; i >= 0; i--) {
    let sum = rows[i]![n]!;
    for (let c = i + 1; c < n; c++) sum -= rows[i]![c]! * result[c]!;
    result[i] = sum / rows[i]![i]!;
  }
  return result;
}
