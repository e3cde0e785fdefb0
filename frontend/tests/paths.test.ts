import { expect, test } from "vitest";

import { bulgeOf, middleOf, withBulge } from "../src/studio/curves/arcs.ts";
import { given, handlesIn, moved, removed, withPointNear, withScale } from "../src/studio/curves/curve-table.ts";
import { type Arc, readPath, writePath } from "../src/studio/curves/path-data.ts";
import { splineThrough } from "../src/studio/curves/spline.ts";
import type { CurveTable, Point } from "../src/studio/state/types.ts";

const HALF = "M-3 0 A3 3 0 0 0 3 0";

function close(found: Point, wanted: Point): void {
  expect(found[0]).toBeCloseTo(wanted[0], 9);
  expect(found[1]).toBeCloseTo(wanted[1], 9);
}

test("every command is read as what it means", () => {
  const path = readPath("m1,2 h3 v-1 q1 1 2 0 t 1 1 c 1 1 2 2 3 -1 s 1 1 2 2 a 4 2 30 1 0 3 3 L20 1-5.5.5")!;
  expect(writePath(path)).toBe(
    "M1 2 L4 2 L4 1 Q5 2 6 1 Q7 0 7 2 C8 3 9 4 10 1 C11 -2 11 2 12 3 A4 2 30 1 0 15 6 L20 1 L-5.5 0.5",
  );
  for (const none of ["", "L1 1", "M0 0", "M0 0 L1 1 Z", "M0 0L1 1M2 2L3 3", "M0 0 A1 1 0 2 0 1 1", "M0 0 L1"]) {
    expect(readPath(none)).toBeNull();
  }
});

test("an arc's bulge says where its middle is, and makes it again", () => {
  for (const data of [HALF, "M0 0 A2 2 0 1 1 1 1", "M0 0 A5 2 25 0 1 3 1", "M1 0 A5 2 -70 1 0 3 1"]) {
    const { start, pieces } = readPath(data)!;
    const arc = pieces[0] as Arc;
    const again = withBulge(start, arc, bulgeOf(start, arc)) as Arc;
    expect([again.large, again.sweep, again.turn]).toEqual([arc.large, arc.sweep, arc.turn]);
    close(again.radii, arc.radii);
  }
  const half = readPath(HALF)!;
  close(middleOf(half.start, half.pieces[0]!), [0, 3]);
});

test("the end of an arc is dragged, and it stays half a circle; its bulge makes another, or a line", () => {
  const half: CurveTable = { path: HALF };
  expect(handlesIn(half).map(({ kind }) => kind)).toEqual(["point", "point", "bulge"]);
  expect(moved(half, 1, [5, 0]).path).toBe("M-3 0 A4 4 0 0 0 5 0");
  expect(moved(half, 2, [0, 1]).path).toBe("M-3 0 A5 5 0 0 0 3 0");
  expect(moved(half, 2, [0, -9]).path).toBe("M-3 0 A5 5 0 1 1 3 0");
  expect(moved(half, 2, [1, 0]).path).toBe("M-3 0 L3 0");
  expect(removed(half, 2).path).toBe("M-3 0 L3 0");
});

test("handles are drawn enlarged, and dragged so", () => {
  const table: CurveTable = { path: HALF, scale: [2, 0.5] };
  expect(handlesIn(table).map(({ at }) => at)).toEqual([[-6, 0], [6, 0], [expect.closeTo(0), expect.closeTo(1.5)]]);
  expect(moved(table, 1, [10, 0]).path).toBe("M-3 0 A4 4 0 0 0 5 0");
  expect(withScale(table, [1, 1])).toEqual({ path: HALF });
  expect(withScale(table, [2, 2])).toEqual({ path: HALF, scale: 2 });
});

test("tangents of a smooth joint turn together; a point takes them along", () => {
  const table: CurveTable = { path: "M0 0 C0 1 1 2 2 2 C3 2 4 1 4 0" };
  const kinds = handlesIn(table).map(({ kind }) => kind);
  expect(kinds).toEqual(["point", "point", "point", "tangent", "tangent", "tangent", "tangent"]);
  expect(moved(table, 4, [2, 1]).path).toBe("M0 0 C0 1 2 1 2 2 C2 3 4 1 4 0");
  expect(moved(table, 1, [2, 3]).path).toBe("M0 0 C0 1 1 3 2 3 C3 3 4 1 4 0");
});

test("a point more leaves the curve what it is", () => {
  const arc = withPointNear({ path: HALF }, [0, 2.8])!;
  expect(arc.index).toBe(1);
  const parts = readPath(arc.table.path!)!;
  for (const piece of parts.pieces) expect((piece as Arc).radii).toEqual([3, 3]);
  close(parts.pieces[0]!.to, [0, 3]);
  const cubic = withPointNear({ path: "M0 0 C0 1 1 2 2 2" }, [0.8, 1.4])!;
  expect(readPath(cubic.table.path!)!.pieces.length).toBe(2);
});

test("a spline as a path is the same curve", () => {
  const points: Point[] = [[-2, 0], [-1, 1.5], [0.5, 2], [2, 0]];
  const path = readPath(given({ points, smooth: true }, "path", [])!.path!)!;
  const spline = splineThrough(points);
  const lengths = points.slice(1).map(([x, y], i) => Math.hypot(x - points[i]![0], y - points[i]![1]));
  const total = lengths.reduce((sum, each) => sum + each, 0);
  let [start, before] = [path.start, 0];
  path.pieces.forEach((piece, k) => {
    if (piece.kind !== "B") throw new Error("an arc");
    const middle = [0, 1].map(
      (axis) => (start[axis]! + 3 * piece.control[0]![axis]! + 3 * piece.control[1]![axis]! + piece.to[axis]!) / 8,
    ) as Point;
    close(middle, spline((before + lengths[k]! / 2) / total));
    before += lengths[k]!;
    start = piece.to;
  });
});
