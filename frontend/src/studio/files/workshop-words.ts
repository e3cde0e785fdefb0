// Words for what the workshop's settings are set to, and for the layers of its drawings.

import type { LayerPen } from "../../shared/api-types.ts";

const CHOICES: Record<string, Record<string, string>> = {
  palette: { plain: "Plain", lightburn: "LightBurn", glowforge: "Glowforge", epilog: "Epilog", shop: "Laser shop", plotter: "Plotter" },
  creases: { score: "Scored", dashes: "Dashes", perforation: "Perforated" },
  labels: { none: "None", panels: "Panels", creases: "Creases", both: "Panels and creases" },
  joint: { tabs: "Tabs", strips: "Strips" },
};

/** A choice as a person reads it. */
export function wordsOfChoice(key: string, value: string): string {
  return CHOICES[key]?.[value] ?? value;
}

export const LAYERS: Record<LayerPen["layer"], string> = {
  CUT: "Cut",
  MOUNTAIN: "Mountain creases",
  VALLEY: "Valley creases",
  ENGRAVE: "Engraved",
  LABEL: "Beside the work",
};

/** Settings that say nothing while others have these values, and so are not shown. */
export function isIdle(key: string, value: (key: string) => unknown): boolean {
  switch (key) {
    case "dash":
    case "duty":
      return value("creases") === "score";
    case "margin":
    case "spacing":
    case "joint":
    case "joint_width":
      return !Array.isArray(value("stock"));
    default:
      return false;
  }
}

/** A share as a percentage. */
export function percent(share: number): string {
  return `${Math.round(100 * share)} %`;
}
