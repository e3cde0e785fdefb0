// What handles at the shell are: how long panels are, how deep folds, how wide flaps, how far f and g go.

import type { Vector3 } from "three";
import { scaleOf, withExtent } from "../curves/curve-table.ts";
import { boxOf } from "../curves/plane.ts";
import { clamp, short } from "../parts/numbers.ts";
import { aimOf } from "../state/aims.ts";
import type { Store } from "../state/store.ts";
import type { CurveName, Parameter, Point } from "../state/types.ts";

/** From where to where a handle is drawn, in space. */
export interface Span {
  from: Vector3;
  to: Vector3;
}

/** The vertices of a shell. */
export interface Vertices {
  rows: number;
  columns: number;
  /** Columns of flaps at either end. */
  flaps: number;
  at(row: number, column: number): Vector3;
  /** Across the flap that is nearest to the eye, from its column to its free edge; null without flaps. */
  flap(): Span | null;
}

export interface Kind {
  label(store: Store): string;
  /** Null where it is not to be set by hand. */
  value(store: Store): number | null;
  isLength: boolean;
  step(store: Store, value: number): number;
  span(vertices: Vertices): Span | null;
  /** The value, once its line, which is so long, is drawn so many times as long. */
  drawn(value: number, times: number, length: number): number;
  /** Sets it, beginning with what it is now. */
  begin(store: Store): (wanted: number, gesture: string) => void;
}

/** The end of a curve has a handle where it is so far from the other, of the curve's extent. */
const OPEN = 0.4;
/** A tenth of the leading digit's place. */
const fine = (_: Store, value: number): number => 10 ** Math.floor(Math.log10(value || 1) - 1);

export const KINDS: Record<string, Kind> = {
  // From a vertex in the middle over some panels to another: longer panels are fewer.
  rows: counted("rows", ({ rows, columns, at }) => {
    const [row, column] = [rows >> 1, columns >> 1];
    return { from: at(row, column), to: at(Math.min(rows - 1, row + Math.ceil(rows / 5)), column) };
  }),
  columns: counted("columns", ({ rows, columns, at }) => {
    const [row, column] = [rows >> 1, columns >> 1];
    return { from: at(row, column), to: at(row, Math.min(columns - 1, column + Math.ceil(columns / 5))) };
  }),
  // From the middle of a fold to its crest.
  depth: {
    label: (store) => store.labels.of("depth"),
    value: (store) => patternValue(store, "depth"),
    isLength: true,
    step: fine,
    span: ({ rows, columns, at }) => {
      const [row, column] = [rows >> 1, columns >> 1];
      return { from: at(row - 1, column).lerp(at(row + 1, column), 0.5), to: at(row, column) };
    },
    drawn: (value, times, length) => value + (times - 1) * length,
    begin: (store) => (wanted, gesture) => setNew(store, "depth", Number(short(Math.max(0, wanted), 3)), gesture),
  },
  flap: {
    label: (store) => store.labels.of("flap"),
    value: (store) => patternValue(store, "flap"),
    isLength: true,
    step: fine,
    span: ({ flap }) => flap(),
    drawn: (value, times) => value * times,
    begin: (store) => (wanted, gesture) => setNew(store, "flap", Number(short(Math.max(0, wanted), 3)), gesture),
  },
  f: extent("f", "Span", ({ rows, columns, at }) => ({ from: at(0, columns >> 1), to: at(rows - 1, columns >> 1) })),
  g: extent("g", "Length", ({ rows, columns, flaps, at }) => ({ from: at(rows >> 1, flaps), to: at(rows >> 1, columns - 1 - flaps) })),
};

function counted(key: "rows" | "columns", span: Kind["span"]): Kind {
  return {
    label: (store) => store.labels.of(key),
    value: (store) => patternValue(store, key),
    isLength: false,
    step: (store) => parameterOf(store, key)?.step ?? 1,
    span,
    drawn: (value, times) => value / times,
    begin: (store) => (wanted, gesture) => {
      const { slider = [1, Infinity], step = 1 } = parameterOf(store, key)!;
      const [low, high] = slider;
      setNew(store, key, clamp(low + step * Math.round((wanted - low) / step), low, high), gesture);
    },
  };
}

/** What is as it was is no step of the history. */
function setNew(store: Store, key: string, value: number, gesture: string): void {
  if (value !== store.design.value.pattern[key]) store.setPattern(key, value, gesture);
}

/** How far a curve goes, as the boxes beside its plane have it; not where sizes of the shell are asked for. */
function extent(name: CurveName, word: string, span: Kind["span"]): Kind {
  const along = (store: Store): { axis: 0 | 1; size: number } | null => {
    const box = boxOf(store.curves.value?.[name] ?? []);
    if (!box) return null;
    const [x, y] = [box.high[0] - box.low[0], box.high[1] - box.low[1]];
    const axis = name === "g" && y > x ? 1 : 0;
    return { axis, size: axis ? y : x };
  };
  return {
    label: () => `${word} of ${name}`,
    value: (store) => {
      const { design, freshness } = store;
      if (aimOf(design.value) !== "curves" || design.value.target?.fit || freshness.value === "outdated") return null;
      return along(store)?.size || null;
    },
    isLength: true,
    step: fine,
    span,
    drawn: (value, times) => value * times,
    begin: (store) => {
      const now = along(store), table = store.design.value.target?.[name];
      // Samples follow the design later.
      if (!now || !table || store.freshness.value !== "current") return () => undefined;
      const scale = scaleOf(table);
      return (wanted, gesture) => {
        const size = Number(short(wanted, 3));
        if (!(size > 0)) return;
        store.setCurve(name, withExtent(table, now.axis, size, scale.with(now.axis, (scale[now.axis] * size) / now.size) as Point), `${word.toLowerCase()} of ${name}`, gesture);
      };
    },
  };
}

/** Whether the ends of a line are far enough apart to be told by it. */
export function isOpen({ from, to }: Span, value: number): boolean {
  return from.distanceTo(to) > OPEN * value;
}

function parameterOf({ info, design }: Store, key: string): Parameter | undefined {
  return info.families[design.value.shell.family]?.parameters.find((each) => each.key === key && each.only !== "none");
}

/** Not where it is chosen by a tolerance, nor of a drawn sheet. */
function patternValue(store: Store, key: string): number | null {
  const { design, report } = store;
  if (!parameterOf(store, key) || design.value.tolerance || !["curves", "surface"].includes(aimOf(design.value))) return null;
  const given = design.value.pattern[key];
  const value = given === "auto" || given === undefined ? report.value?.parameters[key] : given;
  return typeof value === "number" ? value : null;
}
