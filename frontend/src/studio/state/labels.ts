// Keys of the design file in the words of the page: the labels of its controls.

import { capital } from "../../shared/words.ts";
import type { Info, Remedy, Value } from "./types.ts";

/** Tables whose controls are not listed by the server, or that have none. */
const TABLES: Record<string, Record<string, string>> = {
  deployment: {
    from: "Opened from", flap_attachment: "Flaps", ties: "Ties", largest_fold_deg: "Hinges close to",
  },
  panel: {
    thickness: "Thickness", membrane: "Membrane", gap: "Gap", construction: "Construction",
    stop_deg: "Stop of the flaps", largest_setback: "Largest setback",
  },
  tolerance: { surface: "Surface", panel_min: "Shortest edge", panel_max: "Longest edge" },
  shell: { family: "Family", unit: "Unit", ground: "Ground" },
  motion: { frames: "Frames", contact_tolerance: "Contact tolerance" },
  workshop: {
    corner_gap: "Corner gap", relief_hole: "Relief hole", joint_width: "Joint width", title_block: "Title block",
    paper_scale: "Paper scale", model_scale: "Model scale", areal_density: "Areal density",
  },
};
const SECTIONS: Record<string, string> = {
  pattern: "Pattern", deployment: "Deployment", panel: "Panels", tolerance: "Tolerance", shell: "Shell", workshop: "Workshop",
};

export class Labels {
  private readonly families = new Map<string, Map<string, string>>();
  /** Of all tables but the pattern's. */
  private readonly others = new Map<string, string>();

  constructor(
    families: Info["families"],
    /** The family of the present design. */
    private readonly family: () => string,
  ) {
    for (const [name, { parameters }] of Object.entries(families)) {
      this.families.set(name, new Map(parameters.map(({ key, label }) => [key, label])));
    }
    for (const table of Object.values(TABLES)) for (const [key, label] of Object.entries(table)) this.others.set(key, label);
  }

  /** The label of a key of the table [pattern]; the key itself where it has no control. */
  of(key: string): string {
    return this.find(key) ?? key;
  }

  /** The label of a key with its tables in front of it. */
  place(place: string): string {
    const [table = "", ...rest] = place.split(".");
    const curve = table === "target" ? ` of ${rest.shift()}` : "";
    const names = rest.filter((each) => !isPlace(each));
    const label = (table === "pattern" ? this.find(names[0]!) : TABLES[table]?.[names[0]!]) ?? capital(names.join(" ").replaceAll("_", " "));
    // Places in a list are counted from 1.
    return [label, ...rest.filter(isPlace).map((each) => Number(each) + 1)].join(" ") + curve;
  }

  /** The section of the page, or the table, that a key stands in. */
  section(place: string): string {
    const [table = ""] = place.split(".");
    return table === "target" ? "Curves" : (SECTIONS[table] ?? capital(table.replaceAll("_", " ")));
  }

  /** A text of the server with labels for keys, and sections of the page for tables. */
  said(text: string): string {
    return text
      .replace(/ (in|of) \[(\w+)\]/g, (whole, _, table: string) => (SECTIONS[table] ? ` under ${SECTIONS[table]}` : whole))
      .replace(/\[(target\.)?([fg])\] ?/g, "curve $2: ")
      .replace(/\[(\w+)\]/g, (whole, table: string) => SECTIONS[table] ?? whole)
      .replace(/\b([a-z][a-z_]*)( = (-?[\d.]+)?)?/g, (whole, key: string, equals = "", number = "", at: number) => {
        // A plain word is a key only where it is given a value.
        const label = equals || key.includes("_") ? this.find(key) : undefined;
        if (!label) return whole;
        // The full stop that ends a sentence belongs to no number.
        const plain = String(number).replace(/\.$/, "");
        const after = `${equals.slice(0, equals.length - String(number).length)}${plain}${plain && key.endsWith("_deg") ? "°" : ""}`;
        return `${at ? small(label) : label}${after}${number === plain ? "" : "."}`;
      });
  }

  /** What a remedy changes, in words. */
  remedy({ changes }: Remedy): string {
    const given: string[] = [];
    const without: string[] = [];
    for (const [place, value] of Object.entries(changes)) {
      const [table = "", ...rest] = place.split(".");
      const key = rest.at(-1) ?? table;
      const curve = table === "target" ? ` of ${rest[0]}` : "";
      const label = `${small((table === "pattern" ? this.find(key) : TABLES[table]?.[key]) ?? key.replaceAll("_", " "))}${curve}`;
      if (value === null) without.push(label);
      else given.push(`${label} = ${written(value as Value)}${key.endsWith("_deg") && typeof value === "number" ? "°" : ""}`);
    }
    return given.join(" with ") + (without.length ? ` without ${without.join(", ")}` : "");
  }

  private find(key: string): string | undefined {
    const own = this.families.get(this.family())?.get(key);
    if (own) return own;
    for (const family of this.families.values()) if (family.has(key)) return family.get(key);
    return this.others.get(key);
  }
}

/** Within a sentence a label begins small. */
function small(label: string): string {
  return label.charAt(0).toLowerCase() + label.slice(1);
}

function isPlace(name: string): boolean {
  return /^\d+$/.test(name);
}

function written(value: Value): string {
  return Array.isArray(value) ? value.map(written).join(", ") : String(value);
}
