// What the curves are called, and what stands where there is none.

import type { CurveName, CurveTable } from "../state/types.ts";

export const FILES = ".csv,.txt,.svg,.dxf";
export const TITLES: Record<CurveName, string> = { f: "profile", g: "path" };
export const WORDS: Record<CurveName, string> = {
  f: "the profile that is swept",
  g: "the path that f is swept along",
};
export const VIEWS: Record<CurveName, string> = { f: "seen from the front", g: "seen from above" };
export const BLANK: Record<CurveName, string> = {
  f: "The profile from the front:",
  g: "The path from above:",
};
/** How high y = 0 lies in an empty plane: the ground is below, a plan has it in the middle. */
export const LEVELS: Record<CurveName, number> = { f: 0.25, g: 0.5 };
/** How wide an empty plane is, in units of length. */
export const WIDTHS: Record<string, number> = { mm: 400, cm: 80, m: 8, in: 16, ft: 24 };
export const FALLBACK: Record<CurveName, CurveTable> = {
  f: { formula: "-x**2", range: [-1, 1] },
  g: { formula: "0.25*sin(pi*x/2)", range: [0, 4] },
};
export const MODES = [
  { value: "spline", text: "Spline", title: "a smooth curve through points that can be dragged" },
  { value: "lines", text: "Lines", title: "straight lines between points that can be dragged" },
  { value: "path", text: "Path", title: "lines, arcs and Bézier curves with handles" },
  { value: "formula", text: "Formula", title: "type y(x), or x(t) and y(t)" },
] as const;
