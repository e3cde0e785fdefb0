import { expect, test } from "vitest";

import { Motion } from "../src/shared/rigid.ts";
import { decodeView, outlines, panelCount, panelName, stateCount, vertexCount } from "../src/shared/view.ts";
import scipy from "./motion.json";

const view = decodeView(Uint8Array.from(atob(scipy.view), (each) => each.charCodeAt(0)).buffer);
/** Places that are compared: coordinates are single precision, and so are turns. */
const DIGITS = 5;

test("panels are where the mechanism and SciPy's even turns have them", () => {
  const motion = new Motion(view);
  const at = new Float64Array(12);
  scipy.folds.forEach((fold, k) => {
    motion.setFold(fold);
    for (let panel = 0; panel < motion.panels; panel++) {
      motion.place(panel, at);
      const vertices = [...view.faces.subarray(4 * panel, 4 * panel + 4)];
      for (let i = 0; i < 4; i++) {
        const corner = vertices.indexOf(motion.faces[4 * panel + i]!);
        for (let axis = 0; axis < 3; axis++) {
          const expected = scipy.corners[k]![panel]![corner]![axis]! - view.header.origin[axis]!;
          expect(at[3 * i + axis]).toBeCloseTo(expected, DIGITS);
        }
      }
    }
  });
});

test("panels keep their shape between states", () => {
  const motion = new Motion(view);
  for (let fold = 0; fold <= 1; fold += 0.05) {
    motion.setFold(fold);
    expect(motion.maxStrain()).toBeLessThan(2e-6);
  }
});

test("whole boards shift their panels, evenly between states", () => {
  const size = 3 * panelCount(view), shifts = new Float32Array(size * stateCount(view));
  for (let state = 0; state < stateCount(view); state++) {
    for (let panel = 0; panel < panelCount(view); panel++) shifts[size * state + 3 * panel + 2] = state * panel;
  }
  const plain = new Motion(view), moved = new Motion({ ...view, shifts });
  const from = new Float64Array(12), to = new Float64Array(12);
  for (const fold of [0, 0.3, 1]) {
    plain.setFold(fold);
    moved.setFold(fold);
    plain.place(2, from);
    moved.place(2, to);
    const share = fold * (stateCount(view) - 1);
    for (let corner = 0; corner < 4; corner++) {
      expect(to[3 * corner]).toBeCloseTo(from[3 * corner]!, DIGITS);
      expect(to[3 * corner + 2]! - from[3 * corner + 2]!).toBeCloseTo(2 * share, 4);
    }
  }
});

test("the nearest panel under a ray is found, and none beside the sheet", () => {
  const motion = new Motion(view);
  motion.setFold(0);
  const at = new Float64Array(12);
  motion.place(3, at);
  const [x, y, z] = [0, 1, 2].map((axis) => (at[axis]! + at[3 + axis]! + at[6 + axis]! + at[9 + axis]!) / 4);
  expect(motion.pick(x!, y!, z! + 10, 0, 0, -1)).toBe(3);
  expect(motion.pick(x!, y!, z! - 10, 0, 0, 1)).toBe(3);
  expect(motion.pick(x! + 100, y!, z! + 10, 0, 0, -1)).toBe(-1);
});

test("a view says its sizes and names its panels", () => {
  const [rows, columns] = view.header.grid!;
  expect(vertexCount(view)).toBe(rows * columns);
  expect(panelCount(view)).toBe((rows - 1) * (columns - 1));
  expect(stateCount(view)).toBe(4);
  expect(panelName(view, columns)).toBe("panel 1,1");
  const [loop, ...others] = outlines(view);
  expect(others).toEqual([]);
  expect(loop!.length).toBe(2 * (rows - 1) + 2 * (columns - 1));
});
