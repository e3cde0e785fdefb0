import { Quaternion, Vector3 } from "three";
import { expect, test } from "vitest";

import { Boards3D, surfaceOf } from "../src/shared/boards3d.ts";
import { Motion, POSE } from "../src/shared/rigid.ts";
import { decodeView } from "../src/shared/view.ts";
import python from "./boards.json";

/** Places that are compared: coordinates are single precision, and so are turns. */
const DIGITS = 5;

function shown(name: "sandwich" | "bevel") {
  const { view: text, folds, outlines, volumes } = python[name];
  const view = decodeView(Uint8Array.from(atob(text), (each) => each.charCodeAt(0)).buffer);
  const motion = new Motion(view);
  const boards = new Boards3D({ covered: { value: 0 } });
  boards.show(motion, view);
  const { geometry } = boards.solids;
  const [points, corners] = ["point", "corner"].map((each) => geometry.getAttribute(each)!.array as Float32Array);
  const place = (vertex: number): Vector3 => {
    const pose = POSE * Math.floor(corners![vertex]! / 4);
    const turn = new Quaternion().fromArray(motion.pose, pose);
    return new Vector3().fromArray(points!, 3 * vertex).applyQuaternion(turn).add(new Vector3().fromArray(motion.pose, pose + 4));
  };
  return { view, motion, boards, geometry, place, folds, outlines, volumes };
}

for (const name of ["sandwich", "bevel"] as const) {
  test(`boards of a ${name} are where Python carries them`, () => {
    const { view, motion, boards, geometry, place, folds, outlines } = shown(name);
    const { heights, corners, panels } = view.boards!;
    const size = heights * corners;
    const each = geometry.getAttribute("point")!.count / panels.length;
    expect(boards.solids.visible).toBe(true);
    folds.forEach((fold, k) => {
      motion.setFold(fold);
      for (let board = 0; board < panels.length; board++) {
        for (let corner = 0; corner < size; corner++) {
          const at = place(board * each + corner).toArray();
          const expected = 3 * ((k * panels.length + board) * size + corner);
          at.forEach((x, axis) => expect(x + view.header.origin[axis]!).toBeCloseTo(outlines[expected + axis]!, DIGITS));
        }
      }
    });
  });
}

test("solid panels hold the volumes that Python measures, seen from outside", () => {
  const { view, geometry, place, volumes } = shown("bevel");
  const index = geometry.getIndex()!;
  const each = index.count / view.boards!.panels.length;
  volumes.forEach((volume, board) => {
    let sum = 0;
    for (let i = board * each; i < (board + 1) * each; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => place(index.getX(i + k)));
      sum += a!.dot(b!.cross(c!)) / 6;
    }
    expect(sum / volume).toBeCloseTo(1, 4);
  });
});

test("a surface is closed: every side is run through once either way", () => {
  for (const [heights, corners] of [[2, 4], [3, 8]] as const) {
    const { sources, triangles } = surfaceOf({ heights, corners }, true, true);
    const sides = new Map<string, number>();
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] = triangles.slice(i, i + 3).map((vertex) => sources[vertex]!.join());
      for (const [from, to] of [[a, b], [b, c], [c, a]]) {
        const key = `${from}>${to}`;
        sides.set(key, (sides.get(key) ?? 0) + 1);
      }
    }
    for (const [key, count] of sides) {
      expect(count).toBe(1);
      expect(sides.get(key.split(">").reverse().join(">"))).toBe(1);
    }
  }
});

test("between two boards of a sandwich nothing is drawn but the membrane", () => {
  const { view, geometry } = shown("sandwich");
  const { corners, heights, panels } = view.boards!;
  // One face of K triangles instead of two.
  expect(geometry.getIndex()!.count).toBe(3 * panels.length * (corners + 2 * corners * (heights - 1)));
});
