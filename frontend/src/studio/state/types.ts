// What the page holds beside what the server sends: the design as it is edited, faults of its own.

import type * as Api from "../../shared/api-types.ts";
import type { Remedy } from "../../shared/api-types.ts";
import type { Known } from "../../shared/view.ts";

export type { Curves, DroppedCurve, ExportTask, FileFormat, Info, Lock, Parameter, Range, Remedy, Verified } from "../../shared/api-types.ts";

export type Value = string | number | boolean | Value[];
export type CurveName = "f" | "g";
export type Point = [number, number];
export type Place = [number, number, number];
export type Bound = number | string;

/** A table [target.f] or [target.g] of a design file; points may be given in place of a path. */
export interface CurveTable {
  formula?: string | [string, string];
  /** Numbers, or formulas of constants. */
  range?: [Bound, Bound];
  part?: [Bound, Bound];
  points?: Point[] | string;
  smooth?: boolean;
  /** SVG path data. */
  path?: string;
  /** One factor, or one along x and one along y. */
  scale?: number | [number, number];
  [more: string]: Value | undefined;
}

export type Ends = [Bound, Bound];

/** The table [target.surface] of a design file: one formula of x and y, three of u and v, or a mesh. */
export interface SurfaceTable {
  formula?: string | [string, string, string];
  x?: Ends;
  y?: Ends;
  u?: Ends;
  v?: Ends;
  /** A mesh. */
  vertices?: Place[];
  triangles?: [number, number, number][];
  mesh?: string;
  unit?: string;
  /** Of a mesh: places at or next to the corners of its rim. */
  corners?: Place[];
  /** A rectangle in plan. */
  centre?: Point;
  size?: Point;
  turn_deg?: number | "auto";
  [more: string]: Value | undefined;
}

/** The table [target.pattern] of a design file: a drawn sheet, by its vertices and creases. */
export interface DrawingTable {
  vertices?: Point[][];
  row_creases?: string[];
  column_creases?: string[];
  unit?: string;
  scale?: number;
  [more: string]: Value | undefined;
}

/** What a shell is to follow: two curves, or a surface, or a drawn sheet. */
export interface Target {
  f?: CurveTable;
  g?: CurveTable;
  surface?: SurfaceTable;
  pattern?: DrawingTable;
  /** The curve of a second skin, in the plane of f. */
  inner?: CurveTable;
  /** Sizes that the built shell is to have. */
  fit?: { [key: string]: number | string };
}

export interface Tolerance {
  surface: number;
  panel_min?: number;
  panel_max?: number;
  least_share?: number;
  steepest_chamfer_deg?: number;
}

/** What a key may be in a search: all from one number to another, or one of a list. */
export type Variable = { low: number; high: number; step?: number } | Value[];

export interface Limit {
  least?: number;
  most?: number;
}

/** The table [search] of a design file. */
export interface SearchTable {
  variables: Record<string, Variable>;
  minimise: string[];
  subject_to?: Record<string, Limit>;
  evaluations?: number;
  population?: number;
  seed?: number;
  method?: string;
}

/** The tables of a design file. */
export interface Design {
  shell: { family: string; unit: string; ground?: "z0" | "as-drawn" };
  /** None: the sheet is designed by its own numbers. */
  target?: Target;
  pattern: Record<string, Value>;
  tolerance?: Tolerance;
  deployment?: Record<string, Value>;
  panel?: Record<string, Value>;
  stiffeners?: Record<string, Value>;
  end_wall?: Record<string, Value>[];
  motion?: Record<string, Value>;
  workshop?: Record<string, Value>;
  structure?: Record<string, Value>;
  load_case?: Record<string, Value>[];
  search?: SearchTable;
}

/** The report of the shell on the screen: while it changes, without what only the proof can say. */
export type Report = Omit<Api.Report, "lock" | "deviation"> & Pick<Known, "lock" | "deviation">;

export type Ranges = Api.Ranges["ranges"];

/** Why something did not work: as the server says it, or found by the page itself. */
export type Fault = Omit<Api.Fault, "kind"> & {
  kind: Api.Fault["kind"] | "network" | "http" | "page";
  /** Whether what works is still being looked for. */
  searching: boolean;
  /** Of a file: read it again with changes that mend it. */
  again?: (changes: Remedy["changes"]) => void;
};
