// Designs to begin with: those that people would build, and one of each family.

import canopy from "../../../../examples/canopy.toml?raw";
import dome from "../../../../examples/dome.toml?raw";
import shelter from "../../../../examples/shelter.toml?raw";
import snow from "../../../../examples/shelter_snow.toml?raw";
import tunnel from "../../../../examples/tunnel.toml?raw";
import type { Info } from "../state/types.ts";

export interface Example {
  name: string;
  title: string;
  /** In a line, what it is. */
  what: string;
  /** Its design file. */
  text: string;
}

/** What the studio opens with. */
export const FIRST: Example = {
  name: "shelter", title: "Shelter", text: shelter,
  what: "3 m by 6 m with 2 m of headroom; it travels as a bundle, and ties hold its feet.",
};
const BUILT: Example[] = [
  {
    name: "shelter_snow", title: "Shelter for winter", text: snow,
    what: "3 m by 6 m; it carries 1 kN/m² of snow and wind of 25 m/s on free hinges. Its 95 load cases take a while.",
  },
  FIRST,
  { name: "canopy", title: "Canopy", text: canopy, what: "A ring of a roof about an open court." },
  { name: "tunnel", title: "Tunnel", text: tunnel, what: "A covered way round a bend, on level ground." },
  { name: "dome", title: "Dome", text: dome, what: "Over a square of 6 m, of boards on a membrane. Fitting its sheet takes a while." },
];

export function examplesOf({ examples, families }: Info): Example[] {
  return [...BUILT, ...examples.map(({ name, title, text }) => ({ name, title, text, what: `${families[name]!.what}.` }))];
}
