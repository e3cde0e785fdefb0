// Which of the designs that were tried is nearest to where sliders stand.

import type { Variant, VariantsPage } from "../shared/api-types.ts";

/** Of two designs equally near the one with the value of the slider that was moved comes first. */
const MOVED = 100;

/** The design with these values, by their numbers, if it was tried. */
export function numbered({ variants }: VariantsPage, at: readonly number[]): Variant | undefined {
  return variants.find((each) => each.at.every((value, k) => value === at[k]));
}

/** Number of the design with a shell that is nearest, most of all in the variable that was moved last. */
export function nearest({ variables, variants }: VariantsPage, at: readonly number[], moved: number): number {
  let best = -1, least = Infinity;
  variants.forEach((variant, number) => {
    if (variant.view === null) return;
    let far = 0;
    variant.at.forEach((value, k) => {
      const { shares } = variables[k]!;
      far += (k === moved ? MOVED : 1) * (shares[value]! - shares[at[k]!]!) ** 2;
    });
    if (far < least) [best, least] = [number, far];
  });
  return best;
}
