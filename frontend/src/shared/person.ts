// A person who stands beside a shell, for its size: a plain silhouette, drawn here.

type Point = [number, number];

/** Metres in a design's units of length. */
const METRES: Record<string, number> = { mm: 0.001, cm: 0.01, m: 1, in: 0.0254, ft: 0.3048 };
const HEIGHT = 1.75;

/** Shells of this many heights of a person are shown with one. */
const SMALLEST = 0.5;
const LARGEST = 40;

/** Whether a person says anything of how large something is, by its longest side. */
export function suitsPerson(size: number, unit: string): boolean {
  const heights = size / heightOfPerson(unit);
  return unit !== "unit" && heights >= SMALLEST && heights <= LARGEST;
}

/** How tall the person is, in a unit of length. */
export function heightOfPerson(unit: string): number {
  return HEIGHT / (METRES[unit] ?? 1);
}

/** Half the width of a person, in its height: over so much room is clear. */
const SHOULDERS = 0.15;

/** Half the side of the square that a person needs clear, in a unit of length. */
export function roomOfPerson(unit: string): number {
  return SHOULDERS * heightOfPerson(unit);
}

/** From the neck down the right side to between the legs. */
const SIDE: Point[] = [
  [0.034, 0.868], [0.036, 0.846], [0.07, 0.832], [0.11, 0.82], [0.133, 0.8], [0.145, 0.765],
  [0.153, 0.69], [0.163, 0.615], [0.17, 0.54], [0.176, 0.475], [0.178, 0.43], [0.168, 0.408],
  [0.154, 0.414], [0.149, 0.47], [0.138, 0.545], [0.128, 0.62], [0.115, 0.7], [0.106, 0.735],
  [0.1, 0.68], [0.09, 0.61], [0.094, 0.55], [0.104, 0.495], [0.105, 0.43], [0.096, 0.35],
  [0.083, 0.28], [0.084, 0.22], [0.078, 0.15], [0.063, 0.06], [0.088, 0.018], [0.086, 0],
  [0.028, 0], [0.022, 0.06], [0.024, 0.15], [0.02, 0.28], [0.014, 0.4], [0.004, 0.462],
];
const HEAD = 7;

/** The outline, clockwise from the crown: x to the right, y up, feet at 0, in units of its height. */
export const PERSON: Point[] = (() => {
  const head = Array.from({ length: HEAD }, (_, i): Point => {
    const angle = (i / HEAD) * 2.55;
    return [0.056 * Math.sin(angle), 0.93 + 0.07 * Math.cos(angle)];
  });
  const right = [...head, ...SIDE];
  return [...right, ...right.slice(1).reverse().map(([x, y]): Point => [-x, y])];
})();
