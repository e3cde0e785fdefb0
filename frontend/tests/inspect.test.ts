import { Vector3 } from "three";
import { expect, test } from "vitest";

import { edgeLength, foldAngle, neighbour, sectorAngles, sheetOf } from "../src/shared/inspect.ts";
import { Motion } from "../src/shared/rigid.ts";
import { anchorFlat, anchorNow, anchorOf, snapTo, type Pixel } from "../src/shared/snap.ts";
import { nearestOf } from "../src/shared/touching.ts";
import { decodeView, panelCount, stateCount, vertexCount } from "../src/shared/view.ts";
import scipy from "./motion.json";

const view = decodeView(Uint8Array.from(atob(scipy.view), (each) => each.charCodeAt(0)).buffer);
const square: Pixel[] = [[0, 100], [0, 0], [100, 0], [100, 100]];

test("areas of panels add up to the sheet's, and the smallest is the smallest", () => {
  const { areas, smallest, largest, shortest } = sheetOf(view);
  let shoelace = 0;
  for (let f = 0; f < view.faces.length; f += 4) {
    for (let k = 0; k < 4; k++) {
      const a = 2 * view.faces[f + k]!, b = 2 * view.faces[f + ((k + 1) & 3)]!;
      shoelace += (view.flat[a]! * view.flat[b + 1]! - view.flat[b]! * view.flat[a + 1]!) / 2;
    }
  }
  expect(areas.reduce((sum, each) => sum + each, 0)).toBeCloseTo(shoelace, 5);
  expect(areas[smallest]).toBe(Math.min(...areas));
  expect(areas[largest]).toBe(Math.max(...areas));
  const { edges } = sheetOf(view);
  for (let panel = 0; panel < panelCount(view); panel++) {
    const sides = [...edges.subarray(4 * panel, 4 * panel + 4)].map((edge) => edgeLength(view, edge));
    expect(Math.min(...sides)).toBeCloseTo(shortest[panel]!, 9);
    expect(sectorAngles(view, panel).reduce((sum, each) => sum + each, 0)).toBeCloseTo(360, 6);
  }
});

test("fold angles of the last state are those that the design says", () => {
  const motion = new Motion(view);
  motion.setFold(1);
  let folded = 0;
  for (let edge = 0; edge < view.edges.length / 2; edge++) {
    const angle = foldAngle(view, motion, edge), given = view.foldAngles[edge]!;
    if (angle === null) continue;
    if (Math.abs(given) > 1) folded++;
    expect(angle).toBeCloseTo(given, 2);
  }
  expect(folded).toBeGreaterThan(10);
  motion.setFold(0);
  for (let edge = 0; edge < view.edges.length / 2; edge++) expect(foldAngle(view, motion, edge) ?? 0).toBeCloseTo(0, 2);
});

test("a hinge on a part of a side is measured between the flap and the panel that carries it", () => {
  // A square, and a flap at right angles along the middle half of its right side.
  const flat = Float32Array.from([0, 4, 0, 0, 4, 0, 4, 4, 4, 3, 4, 1, 6, 1, 6, 3]);
  const folded = [0, 4, 0, 0, 0, 0, 4, 0, 0, 4, 4, 0, 4, 3, 0, 4, 1, 0, 4, 1, 2, 4, 3, 2];
  const positions = Float32Array.from([...Array.from({ length: 8 }, (_, v) => [flat[2 * v]!, flat[2 * v + 1]!, 0]).flat(), ...folded]);
  const edges = Uint32Array.from([4, 5, 0, 1, 1, 2, 2, 5, 4, 3, 3, 0, 5, 6, 6, 7, 7, 4]);
  const drawn = {
    ...view, flat, positions, edges,
    header: { ...view.header, arrays: { flat: { type: "float32" as const, shape: [8, 2], offset: 0 }, positions: { type: "float32" as const, shape: [2, 8, 3], offset: 0 } } },
    faces: Uint32Array.from([0, 1, 2, 3, 4, 5, 6, 7]),
    assignment: Uint8Array.from([2, 0, 0, 0, 0, 0, 0, 0, 0]),
    foldAngles: Float32Array.from([90, 0, 0, 0, 0, 0, 0, 0, 0]),
  };
  const sheet = sheetOf(drawn);
  expect([...sheet.beside.subarray(0, 2)]).toEqual([1, 0]);
  expect(sheet.hinges.get(2)).toEqual([0]);
  expect([...sheet.edges]).toEqual([1, 2, -1, 5, 0, 6, 7, 8]);
  expect([...sheet.beside.subarray(6, 10)]).toEqual([0, -1, 0, -1]);
  const motion = new Motion(drawn);
  motion.setFold(1);
  expect(foldAngle(drawn, motion, 0)).toBeCloseTo(90, 3);
  expect(foldAngle(drawn, motion, 3)).toBe(null);
});

test("one walks from panel to panel, and not beyond the sheet", () => {
  const [rows, columns] = view.header.grid!;
  expect(neighbour(view, 0, 0, 1)).toBe(1);
  expect(neighbour(view, 0, 1, 0)).toBe(columns - 1);
  expect(neighbour(view, 0, -1, 0)).toBe(null);
  expect(neighbour(view, columns - 2, 0, 1)).toBe(null);
  expect(neighbour(view, (rows - 1) * (columns - 1) - 1, 1, 0)).toBe(null);
});

test("corners catch within reach, sides everywhere else", () => {
  expect(snapTo(square, [5, 93], 10)).toMatchObject({ side: 0, along: 0 });
  expect(snapTo(square, [3, 75], 10)).toMatchObject({ side: 0, along: 0.25, away: 3 });
  expect(snapTo(square, [60, 48], 10)).toMatchObject({ side: 2, away: 40 });
  expect(snapTo(square, [97, 20], 0)).toMatchObject({ side: 2, along: 0.2 });
});

test("distances along a panel's sides are the same flat and folded; across a crease they shrink", () => {
  const motion = new Motion(view);
  motion.setFold(1);
  const columns = view.header.grid![1];
  const one = anchorOf(view, columns, { side: 0, along: 0.3 }), other = anchorOf(view, columns, { side: 1, along: 0.6 });
  const far = anchorOf(view, panelCount(view) - 1, { side: 2, along: 0 });
  const flat = (a: typeof one, b: typeof one) => anchorFlat(view, a).distanceTo(anchorFlat(view, b));
  const now = (a: typeof one, b: typeof one) => anchorNow(motion, a).distanceTo(anchorNow(motion, b));
  expect(now(one, other)).toBeCloseTo(flat(one, other), 5);
  expect(now(one, far)).toBeLessThan(0.9 * flat(one, far));
});

test("two panels are nearest at corners, along edges, or in their middle", () => {
  const quad = (z: number, x = 0) => [[0, 0], [1, 0], [1, 1], [0, 1]].map(([u, v]) => new Vector3(u! + x, v!, z));
  const upright = [[0.5, 0.5, 0.2], [0.9, 0.5, 1], [0.5, 0.5, 2], [0.1, 0.5, 1]].map(([x, y, z]) => new Vector3(x, y, z));
  expect(nearestOf(quad(0), upright)).toMatchObject({ gap: 0.2 });
  expect(nearestOf(quad(0), upright).point.toArray()).toEqual([0.5, 0.5, 0.1]);
  expect(nearestOf(quad(0), quad(0, 1.5)).gap).toBeCloseTo(0.5, 12);
  expect(nearestOf(quad(0), quad(0.3, 0.4)).gap).toBeCloseTo(0.3, 12);
});

test("a sheet of sixty thousand vertices is measured and does not hang", () => {
  const side = 245;
  const flat = Float32Array.from({ length: 2 * side * side }, (_, i) => (i & 1 ? -Math.floor((i >> 1) / side) : (i >> 1) % side));
  const faces: number[] = [], edges: number[] = [];
  for (let v = 0; v < side * side; v++) {
    const right = v % side < side - 1, down = v < side * (side - 1);
    if (right && down) faces.push(v, v + side, v + side + 1, v + 1);
    if (right) edges.push(v, v + 1);
    if (down) edges.push(v, v + side);
  }
  const arrays = { flat: { type: "float32" as const, shape: [side * side, 2], offset: 0 } };
  const large = { ...view, header: { ...view.header, arrays, grid: [side, side] as [number, number] }, flat, faces: Uint32Array.from(faces), edges: Uint32Array.from(edges) };
  expect(vertexCount(large)).toBe(60_025);
  const start = performance.now();
  const { areas } = sheetOf(large);
  expect(areas.every((area) => area === 1)).toBe(true);
  expect(performance.now() - start).toBeLessThan(60_000); // a hang
  expect(stateCount(view)).toBeGreaterThan(1);
});
