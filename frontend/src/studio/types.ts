// What the studio and its server say to each other.

export type Value = string | number | boolean | Value[];
export type CurveName = "f" | "g";
export type Point = [number, number];
export type Bound = number | string;

/** A table [target.f] or [target.g] of a design file; points may be given in place of a path. */
export interface CurveTable {
  formula?: string | [string, string];
  /** Numbers, or formulas of constants. */
  range?: [Bound, Bound];
  part?: [Bound, Bound];
  points?: Point[] | string;
  smooth?: boolean;
  scale?: number;
  [more: string]: Value | undefined;
}

export interface Tolerance {
  surface: number;
  panel_min?: number;
  panel_max?: number;
}

/** The tables of a design file. */
export interface Design {
  shell: { family: string; unit: string; ground?: "z0" | "as-drawn" };
  target: { f: CurveTable; g: CurveTable };
  pattern: Record<string, Value>;
  tolerance?: Tolerance;
  motion?: Record<string, Value>;
  workshop?: Record<string, Value>;
}

export interface Parameter {
  key: string;
  label: string;
  help: string;
  kind: "integer" | "number" | "choice" | "angles4" | "flag";
  auto: boolean;
  choices?: string[];
  /** Null: the design must give it. */
  default: Value | null;
  slider?: [number, number];
  step?: number;
  unit: "length" | "deg" | "";
}

export interface Family {
  label: string;
  what: string;
  parameters: Parameter[];
}

export interface Example {
  name: string;
  title: string;
  text: string;
}

export interface Format {
  name: string;
  file: string;
  what: string;
}

export interface Info {
  version: string;
  units: string[];
  families: Record<string, Family>;
  examples: Example[];
  formats: Format[];
  limits: { vertices: number; bytes: number; seconds: number };
  /** The design file that the studio was started with. */
  start?: { name: string; design: Design } | null;
}

export type Curves = Record<CurveName, Point[]>;

export interface Fault {
  kind: string;
  message: string;
  what: string;
  where: string;
  got: string;
  expected: string;
  remedy: string;
  place: string;
  size: string;
  /** What limits, where nothing was found that works. */
  limit: string;
  /** What was tried and works, the nearest first. */
  remedies: Remedy[];
  /** Whether what works is still being looked for. */
  searching: boolean;
}

/** Values of keys of the design file, the tables in front of them; null removes a key. */
export interface Remedy {
  text: string;
  changes: Record<string, Value | null>;
}

export interface Range {
  /** Values that were tried. */
  span?: [number, number];
  intervals: [number, number][];
  below: string;
  above: string;
}
export type Ranges = Record<string, Range>;

export interface FirstContact {
  drive_deg: number;
  panels: [[number, number], [number, number]];
  kind: string;
}

export interface Lock {
  drive_deg: number | null;
  cause: "flaps" | "clash" | "crease" | null;
  target_drive_deg: number;
  first_contact: FirstContact | null;
}

/** The parts of report.json that the studio reads itself. */
export interface Report {
  rows?: number;
  columns?: number;
  parameters?: Record<string, unknown>;
  warnings?: string[];
  lock?: Lock;
  feasible?: boolean | null;
  [more: string]: unknown;
}

export interface Verified {
  report: Report;
  contact: { drive_deg: number; panels: [number, number] } | null;
  /** Float32 numbers in base64. */
  distance?: string | null;
  /** Why the design is refused although its shell can be shown: panels meet before it locks. */
  refusal?: Fault | null;
  /** A view in base64 that takes the place of the one shown. */
  view?: string | null;
}
