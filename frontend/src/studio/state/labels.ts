// Keys of the design file in the words of the page: the labels of its controls.

import { capital } from "../../shared/words.ts";
import type { Info, Remedy, Value } from "./types.ts";

export class Labels {
  private readonly families = new Map<string, Map<string, string>>();
  /** Of all tables but the pattern's. */
  private readonly others: Map<string, string>;
  /** What numbers of the table [pattern] are measured in. */
  private readonly units = new Map<string, string>();

  constructor(
    families: Info["families"],
    private readonly tables: Info["tables"],
    /** Family and unit of the present design. */
    private readonly shell: () => { family: string; unit: string },
  ) {
    for (const [name, { parameters }] of Object.entries(families)) {
      this.families.set(name, new Map(parameters.map(({ key, label }) => [key, label])));
      for (const { key, unit } of parameters) this.units.set(key, unit);
    }
    this.others = new Map(Object.values(tables).flatMap(({ keys }) => Object.entries(keys).map(([key, { label }]) => [key, label])));
  }

  /** The label of a key of the table [pattern]; the key itself where it has no control. */
  of(key: string): string {
    return this.find(key) ?? key;
  }

  /** The label of a key with its tables in front of it. */
  place(place: string): string {
    const [table = "", ...rest] = place.split(".");
    const curve = table === "target" ? ofTarget(rest.shift()!) : "";
    const names = rest.filter((each) => !isPlace(each));
    const label = this.at(table, names[0]!) ?? capital(names.join(" ").replaceAll("_", " "));
    // Places in a list are counted from 1.
    return [label, ...rest.filter(isPlace).map((each) => Number(each) + 1)].join(" ") + curve;
  }

  /** The section of the page, or the table, that a key stands in. */
  section(place: string): string {
    const [table = ""] = place.split(".");
    return this.page(table) ?? capital(table.replaceAll("_", " "));
  }

  /** A text of the server with labels for keys, and sections of the page for tables; without what only
   * says, in brackets, how that is written in a file. */
  said(text: string): string {
    return text
      .replace(/ \(([^()]*)\)/g, (whole, inner: string) => (this.isOfFile(inner) ? "" : whole))
      .replace(/\b([a-z][a-z_]*) = "([^"]*)"/g, (_, key: string, value: string) => this.choice(key, value))
      .replace(/ (in|of) \[(\w+)\]/g, (_, __, table: string) => ` under ${this.section(table)}`)
      .replace(/\[(target\.)?([fg])\] ?/g, "curve $2: ")
      .replace(/\[target\.surface\] ?/g, "surface: ")
      .replace(/\[([a-z_]{2,})\]/g, (_, table: string) => this.section(table))
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

  /** Whether words are keys of a table, or begin with a value of a key. */
  private isOfFile(words: string): boolean {
    const [, key, next] = /^([a-z][a-z_.]*)( = |, | or | and | in )/.exec(words) ?? [];
    if (key === undefined) return false;
    return / in \[[a-z_.]+\]( and \[[a-z_.]+\])?$/.test(words) || / = ("[^"]*"|true|false)$/.test(words) || (next === " = " && this.find(key) !== undefined);
  }

  /** A value that is a word, in the words of its control. */
  private choice(key: string, value: string): string {
    const words = Object.values(this.tables).find(({ keys }) => keys[key]?.choices[value])?.keys[key]?.choices[value];
    return `${small(this.find(key) ?? key.replaceAll("_", " "))}: ${words ? small(words) : value}`;
  }

  /** What a remedy changes, in words. */
  remedy({ changes }: Remedy): string {
    const given: string[] = [];
    const without: string[] = [];
    for (const [place, value] of Object.entries(changes)) {
      const [table = "", ...rest] = place.split(".");
      const key = rest.at(-1) ?? table;
      const within = [table, ...rest.slice(0, -1)].filter((each) => !isPlace(each)).join(".");
      const words = within in this.tables ? within : table;
      const curve = table === "target" && words === table ? ofTarget(rest[0]!) : "";
      const label = `${small(this.at(words, key) ?? key.replaceAll("_", " "))}${curve}`;
      if (value === null) without.push(label);
      else if (typeof value === "number") given.push(`${label} = ${value}${this.unit(words, key)}`);
      else if (Array.isArray(value)) given.push(`${label} = ${written(value as Value)}`);
      else given.push(`${label}: ${typeof value === "object" ? written(value as Value) : this.worded(words, key, value as string | boolean)}`);
    }
    return given.join(" and ") + (without.length ? ` without ${without.join(", ")}` : "");
  }

  /** A word or a switch as its control has it. */
  private worded(table: string, key: string, value: string | boolean): string {
    if (typeof value === "boolean") return value ? "yes" : "no";
    const words = this.tables[table]?.keys[key]?.choices[value];
    return words ? small(words) : value;
  }

  /** What follows a number. */
  private unit(table: string, key: string): string {
    if (key.endsWith("_deg")) return "°";
    const unit = table === "pattern" ? this.units.get(key) : this.tables[table]?.keys[key]?.unit;
    return unit === "length" ? ` ${this.shell().unit}` : "";
  }

  /** The label of a key of a table. */
  private at(table: string, key: string): string | undefined {
    return table === "pattern" ? this.find(key) : this.tables[table]?.keys[key]?.label;
  }

  /** The section of the page that has the controls of a table. */
  private page(table: string): string | undefined {
    return this.tables[table]?.label || undefined;
  }

  private find(key: string): string | undefined {
    const own = this.families.get(this.shell().family)?.get(key);
    if (own) return own;
    for (const family of this.families.values()) if (family.has(key)) return family.get(key);
    return this.others.get(key);
  }
}

/** Within a sentence a label begins small. */
function small(label: string): string {
  return label.charAt(0).toLowerCase() + label.slice(1);
}

/** The curve that something is of, or the surface. */
function ofTarget(name: string): string {
  const whole: Record<string, string> = { surface: " of the surface", fit: " of the built shell", inner: " of the second skin" };
  return whole[name] ?? ` of ${name}`;
}

function isPlace(name: string): boolean {
  return /^\d+$/.test(name);
}

function written(value: Value): string {
  if (typeof value !== "object") return String(value);
  return Object.values(value).map(written).join(", ");
}
