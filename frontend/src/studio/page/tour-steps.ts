// The steps of the tour, and where its card stands.

export interface Step {
  /** What is shown; the whole page where there is nothing to point at. */
  region: string | null;
  title: string;
  text: string;
}

export const STEPS: Step[] = [
  {
    region: ".families",
    title: "Choose a family",
    text: "Ways to lay panels out along curves, or over a surface. Each says what it can follow; the design stays yours when you change between them.",
  },
  {
    region: ".inputs > .target",
    title: "Say what it follows",
    text: "Two curves: f is the profile, g the path that it is swept along. Or a surface: type a formula, or drop a mesh. Drag points and corners; drop a drawing or crease pattern.",
  },
  {
    region: ".parameters",
    title: "Set the pattern",
    text: "More rows and columns follow the curves more closely. The coloured part of a slider is what can be made; below it stands why not more.",
  },
  {
    region: ".scene-frame",
    title: "Turn it and fold it",
    text: "The shell follows every change. Drag it to turn it, zoom with the wheel or two fingers. The slider below folds it; Space plays the motion.",
  },
  {
    region: ".results",
    title: "Read the proof",
    text: "When you rest, it is proved that nothing touches on the way, or said what does and what would help. Pattern and figures stand beside it.",
  },
  {
    region: ".toolbar",
    title: "Take it along",
    text: "Name the design here, save it as a file, copy it as a link, and export what workshops and other programs read. Unsaved work is kept in this browser.",
  },
];

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Between card and region, and between card and window. */
const GAP = 12;

/** Where a card stands in a window: beside the region if there is room, else over its far end. */
export function placeCard(region: Box | null, card: Pick<Box, "width" | "height">, window: Pick<Box, "width" | "height">): { left: number; top: number } {
  const right = window.width - card.width - GAP;
  const bottom = window.height - card.height - GAP;
  const clamp = (value: number, high: number): number => Math.max(GAP, Math.min(value, high));
  if (!region) return { left: clamp(right / 2 + GAP / 2, right), top: clamp(bottom / 2 + GAP / 2, bottom) };
  const level = clamp(region.top, bottom);
  const middle = clamp(region.left + (region.width - card.width) / 2, right);
  const east = region.left + region.width + GAP;
  const west = region.left - card.width - GAP;
  const south = region.top + region.height + GAP;
  const north = region.top - card.height - GAP;
  if (east <= right) return { left: east, top: level };
  if (west >= GAP) return { left: west, top: level };
  if (south <= bottom) return { left: middle, top: south };
  if (north >= GAP) return { left: middle, top: north };
  return { left: middle, top: clamp(bottom, bottom) };
}
