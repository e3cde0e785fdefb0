// A design as the text of a design file, where the server that writes better ones does not answer.

type Table = { [key: string]: unknown };

/** The text of a design file: tables in their order, values before the tables within. */
export function tomlOf(tables: object): string {
  return `${written(tables as Table, []).join("\n").trim()}\n`;
}

function written(table: Table, path: string[]): string[] {
  const entries = Object.entries(table).filter(([, value]) => value !== undefined && value !== null);
  const values = entries.filter(([, value]) => !isTable(value) && !isListOfTables(value));
  const lines = values.map(([key, value]) => `${keyOf(key)} = ${valueOf(value)}`);
  if (path.length && (lines.length || !entries.length)) lines.unshift("", `[${path.map(keyOf).join(".")}]`);
  for (const [key, value] of entries) {
    if (isTable(value)) lines.push(...written(value, [...path, key]));
    else if (isListOfTables(value)) {
      for (const each of value) {
        lines.push("", `[[${[...path, key].map(keyOf).join(".")}]]`);
        lines.push(...Object.entries(each).map(([name, item]) => `${keyOf(name)} = ${valueOf(item)}`));
      }
    }
  }
  return lines;
}

function isTable(value: unknown): value is Table {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** Lists at the top of a file that hold tables, as [[load_case]]; within tables they stay in line. */
function isListOfTables(value: unknown): value is Table[] {
  return Array.isArray(value) && value.length > 0 && value.every((each) => isTable(each) && Object.keys(each).length > 2);
}

function keyOf(key: string): string {
  return /^[A-Za-z0-9_-]+$/.test(key) ? key : JSON.stringify(key);
}

function valueOf(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(valueOf).join(", ")}]`;
  if (isTable(value)) {
    const inside = Object.entries(value).map(([key, each]) => `${keyOf(key)} = ${valueOf(each)}`);
    return `{ ${inside.join(", ")} }`;
  }
  if (typeof value === "number") return numberOf(value);
  // Strings of TOML know the escapes of JSON; what is above U+FFFF JSON leaves as it is.
  return JSON.stringify(value).replaceAll("\u007f", "\\u007f");
}

function numberOf(value: number): string {
  if (Number.isFinite(value)) return String(value);
  return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
}
