// The binary view of a shell, as orishell.io.view writes it: little endian, a JSON header, arrays.

import type * as Api from "./api-types.ts";

export type Contact = Api.FirstContact;

/** The report has only rows of sizes if a file of a sheet was read, and what only the proof can say may be
 * left out; see figures.ts. */
export type Known = Partial<Omit<Api.Report, "deviation">> & { deviation?: Partial<Api.DeviationReport> | null };
export type Header = Omit<Api.Header, "report"> & { report: Known };

export interface Lattice {
  rows: number;
  columns: number;
  points: Float32Array;
}

/** Convex plates fixed on panels: see orishell.motion.boards. */
export interface Boards {
  /** Number (B,) of the panel that carries each. */
  panels: Uint32Array;
  heights: number;
  corners: number;
  /** Outlines (B, heights, corners, 3), lowest first: in the flat sheet, and over it. */
  outlines: Float32Array;
}

/** The shell as it was meshed, and what every load case does to it. */
export interface Loaded {
  cases: Api.NamedCase[];
  /** (N, 3) without loads */
  points: Float32Array;
  /** (T, 3), those of what stiffens the sheet last */
  triangles: Uint32Array;
  /** (T,) the panel of each triangle, or which stiffener it is of, which are numbered behind all panels */
  panels: Uint32Array;
  /** How many triangles are those of panels. */
  ofPanels: number;
  /** What a panel or stiffener is called. */
  called: (number: number) => string;
  /** (K, 2) ends of ties */
  ties: Uint32Array;
  /** (C, N, 3) */
  displacements: Float32Array;
  /** (C, T) in MPa, NaN where it is not known */
  stresses: Float32Array;
  /** (C, P, 3) loads on panels (N) */
  loads: Float32Array;
  /** The largest force along every crease, where a case is in balance. */
  creases: { panels: Uint32Array; forces: Float32Array; what: readonly string[]; cases: readonly string[] } | null;
  /** (S, 2) supported nodes, and how each is held: see Held. */
  held: Uint32Array;
}

export interface View {
  header: Header;
  /** (V, 2); empty if only folded states are known. */
  flat: Float32Array;
  /** (K, V, 3); empty if only the flat sheet is known. */
  positions: Float32Array;
  /** (E, 2) */
  edges: Uint32Array;
  /** (E,), see Assignment */
  assignment: Uint8Array;
  /** (E,) at the target, valley positive, NaN unknown */
  foldAngles: Float32Array;
  /** (F, 4), counter-clockwise seen from +z of the flat sheet */
  faces: Uint32Array;
  /** (V,) signed distance of each vertex from the target surface, NaN not compared */
  distance?: Float32Array;
  /** (k, 3) beside the target state */
  curveF?: Float32Array;
  curveG?: Float32Array;
  surface?: Lattice;
  /** Where panels have a thickness. */
  boards?: Boards;
  /** (K, F, 3) how far panels are moved with whole boards, whose hinges stand beside the creases. */
  shifts?: Float32Array;
  /** Where it was analysed as a structure. */
  loaded?: Loaded;
  /** Strips of flaps that are clipped on at the target, about the same origin. */
  clipped: View[];
}

export const Held = { up: 0, pinned: 1, clamped: 2 } as const;
export const Assignment = { border: 0, mountain: 1, valley: 2, unfolded: 3, cut: 4 } as const;

const KINDS = { float32: Float32Array, uint32: Uint32Array, uint8: Uint8Array } as const;

/** Arrays of the view lie in the buffer itself, from a byte on; nothing is copied. */
export function decodeView(buffer: ArrayBuffer, from = 0): View {
  const length = new DataView(buffer).getUint32(from, true);
  const first = from + 4 + length;
  const text = new TextDecoder().decode(new Uint8Array(buffer, from + 4, length));
  const header = JSON.parse(text) as Header;
  if (header.version !== 1) {
    throw new Error(`this view has version ${header.version}; the viewer reads version 1`);
  }

  function find<T extends Float32Array | Uint32Array | Uint8Array>(name: string): T | undefined {
    const place = header.arrays[name];
    if (!place) return undefined;
    const size = place.shape.reduce((product, side) => product * side, 1);
    return new KINDS[place.type](buffer, first + place.offset, size) as T;
  }
  function array<T extends Float32Array | Uint32Array | Uint8Array>(name: string): T {
    const found = find<T>(name);
    if (!found) throw new Error(`the view has no array "${name}"`);
    return found;
  }

  const view: View = {
    header,
    flat: array("flat"),
    positions: array("positions"),
    edges: array("edges"),
    assignment: array("assignment"),
    foldAngles: array("fold_angles_deg"),
    faces: array("faces"),
    clipped: [],
  };
  const distance = find<Float32Array>("distance");
  const curveF = find<Float32Array>("curve_f");
  const curveG = find<Float32Array>("curve_g");
  const points = find<Float32Array>("surface");
  if (distance) view.distance = distance;
  if (curveF) view.curveF = curveF;
  if (curveG) view.curveG = curveG;
  if (points) {
    const [rows = 0, columns = 0] = header.arrays["surface"]!.shape;
    view.surface = { rows, columns, points };
  }
  const outlines = find<Float32Array>("boards");
  if (outlines) {
    const [, heights = 0, corners = 0] = header.arrays["boards"]!.shape;
    view.boards = { panels: array("board_panels"), heights, corners, outlines };
    const shifts = find<Float32Array>("panel_shifts");
    if (shifts) view.shifts = shifts;
  }
  const nodes = find<Float32Array>("loaded_points");
  if (nodes && header.cases) {
    const panels = array<Uint32Array>("loaded_panels"), sheet = panelCount(view);
    const stiffeners = new Map(Object.entries(header.stiffeners ?? {}).map(([name, number]) => [number, name]));
    const behind = panels.findIndex((panel) => panel >= sheet);
    view.loaded = {
      cases: header.cases,
      points: nodes,
      triangles: array("loaded_triangles"),
      panels,
      ofPanels: behind < 0 ? panels.length : behind,
      called: (number) => stiffeners.get(number) ?? panelName(view, number),
      ties: array("loaded_ties"),
      displacements: array("displacements"),
      stresses: array("stresses"),
      loads: array("panel_loads"),
      creases: header.creases ? { ...header.creases, panels: array("crease_panels"), forces: array("crease_forces") } : null,
      held: array("held"),
    };
  }
  for (let place; (place = header.arrays[`clipped_${view.clipped.length}`]); ) {
    view.clipped.push(decodeView(buffer, first + place.offset));
  }
  return view;
}

export function panelCount(view: View): number {
  return view.faces.length / 4;
}

export function vertexCount(view: View): number {
  const { shape } = view.header.arrays["flat"]!;
  return shape[0] || (view.header.arrays["positions"]?.shape[1] ?? 0);
}

export function stateCount(view: View): number {
  return view.header.drives_deg.length;
}

/** Vertices (V, 3) of the shell as it stands: the target, or the last state; null if none is known. */
export function targetPoints(view: View): Float32Array | null {
  const size = 3 * vertexCount(view);
  const number = view.header.named["target"] ?? stateCount(view) - 1;
  return view.positions.length ? view.positions.subarray(number * size, (number + 1) * size) : null;
}

/** Drives nearer to the target than this are the target (degrees). */
const SAME = 1e-6;

/** Whether panels touch before the target: flaps that meet there, and the folds of a pack, are
 * meant to. */
export function isEarly(contact: Pick<Contact, "drive_deg">, lock: Known["lock"]): boolean {
  return !lock || contact.drive_deg < lock.target_drive_deg - SAME;
}

/** Row and column of a panel, or its number where panels are not a grid's. */
export function panelName(view: View, panel: number): string {
  const { grid, names } = view.header;
  if (names) return `panel ${names[panel]}`;
  if (!grid) return `panel ${panel}`;
  const columns = grid[1] - 1;
  return `panel ${Math.floor(panel / columns)},${panel % columns}`;
}

/** The number of a panel by its row and column; -1 if it is none of the sheet's. */
export function numberOf(view: View, [row, column]: readonly [number, number]): number {
  const { grid, names } = view.header;
  if (names) return names.indexOf(`${row},${column}`);
  const columns = (grid?.[1] ?? 1) - 1;
  return grid && row >= 0 && column >= 0 && row < grid[0] - 1 && column < columns ? row * columns + column : -1;
}

/** Drives as numbers, in order; evenly spread where states have none. */
export function drives(view: View): Float64Array {
  const given = view.header.drives_deg;
  const known = given.every((drive) => drive !== null);
  const falling = known && given.every((drive, k) => k === 0 || drive! < given[k - 1]!);
  const rising = known && given.every((drive, k) => k === 0 || drive! > given[k - 1]!);
  return Float64Array.from(given, (drive, k) => (rising || falling ? drive! : k));
}

/** Mountains and valleys that the design tells apart. */
export function assignmentCounts(view: View): number[] {
  const counts = [0, 0, 0, 0, 0];
  for (const each of view.assignment) counts[each]!++;
  return counts;
}

/** Adjacent panels (E, 2) of every edge: -1 where there is none. */
export function edgePanels(view: View): Int32Array {
  const { edges, faces } = view;
  const vertices = vertexCount(view);
  const numbers = new Map<number, number>();
  const count = edges.length / 2;
  for (let e = 0; e < count; e++) {
    const a = edges[2 * e]!, b = edges[2 * e + 1]!;
    numbers.set(a < b ? a * vertices + b : b * vertices + a, e);
  }
  const panels = new Int32Array(2 * count).fill(-1);
  for (let i = 0; i < faces.length; i++) {
    const a = faces[i]!, b = faces[(i & ~3) | ((i + 1) & 3)]!;
    const e = numbers.get(a < b ? a * vertices + b : b * vertices + a);
    if (e === undefined) continue;
    const slot = panels[2 * e] === -1 ? 2 * e : 2 * e + 1;
    panels[slot] = i >> 2;
  }
  return panels;
}

/** Loops of vertices around the sheet, and around its holes. */
export function outlines(view: View): Uint32Array[] {
  const { faces } = view;
  const vertices = vertexCount(view);
  const sides = new Set<number>();
  const side = (i: number): [number, number] => [faces[i]!, faces[(i & ~3) | ((i + 1) & 3)]!];
  for (let i = 0; i < faces.length; i++) {
    const [a, b] = side(i);
    // A side that a neighbour runs the other way lies inside.
    if (!sides.delete(b * vertices + a)) sides.add(a * vertices + b);
  }
  const next = new Map<number, number>();
  for (const code of sides) next.set(Math.floor(code / vertices), code % vertices);
  const loops: Uint32Array[] = [];
  while (next.size) {
    const loop: number[] = [];
    let vertex = next.keys().next().value!;
    for (let after = next.get(vertex); after !== undefined; after = next.get(vertex)) {
      loop.push(vertex);
      next.delete(vertex);
      vertex = after;
    }
    loops.push(Uint32Array.from(loop));
  }
  return loops;
}
