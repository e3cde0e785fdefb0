// Numbers as people type them: 6,5 and 1 200, 33/10, 2*pi, 10 mm beside m, 5' 6" beside ft.

/** What a unit measures, and how many of the first one of its kind it is. */
type Unit = [kind: string, times: number];

/** Every unit by its names; what no one types beside such a box is left out. */
const UNITS = new Map<string, Unit>();
function measure(kind: string, names: Record<string, number>): void {
  for (const [each, times] of Object.entries(names)) {
    for (const name of each.split(" ")) UNITS.set(name, [kind, times]);
  }
}
measure("length", {
  "mm": 1e-3, "cm": 1e-2, "dm": 0.1, "m metre metres meter meters": 1, "km": 1e3,
  "in inch inches \" \u2033 \u201d": 0.0254, "ft foot feet ' \u2032 \u2019": 0.3048, "yd": 0.9144,
});
measure("angle", { "\u00b0 deg degree degrees": 1, "rad": 180 / Math.PI, "gon": 0.9 });
measure("pressure", {
  "Pa N/m\u00b2 N/m2": 1, "kPa kN/m\u00b2 kN/m2": 1e3, "MPa N/mm\u00b2 N/mm2": 1e6, "GPa": 1e9,
  "psf": 47.88025898, "kgf/m\u00b2 kgf/m2": 9.80665,
});
measure("speed", { "m/s": 1, "km/h kmh": 1 / 3.6, "mph": 0.44704, "kn": 1852 / 3600 });
measure("mass", { "kg": 1, "g": 1e-3, "t": 1e3, "lb": 0.45359237 });
measure("force", { "N": 1, "kN": 1e3, "MN": 1e6, "lbf": 4.4482216152605 });
measure("line force", { "N/m": 1, "kN/m": 1e3, "N/mm": 1e3 });
measure("mass by area", { "kg/m\u00b2 kg/m2": 1, "g/m\u00b2 g/m2": 1e-3 });
measure("mass by volume", { "kg/m\u00b3 kg/m3": 1, "g/cm\u00b3 g/cm3": 1e3 });
const NAMES = [...UNITS.keys()].sort((one, other) => other.length - one.length);

/** A number, what it measures, nothing if it has no unit, and how many its unit is. */
interface Amount {
  value: number;
  kind: string;
  times: number;
}

/** The number that a text means beside a unit: in that unit, whatever it is typed in. NaN if it is none. */
export function typedNumber(text: string, unit = ""): number {
  const [kind, times] = UNITS.get(unit) ?? ["", 1];
  const own = text.trim();
  const bare = kind || !unit || !own.endsWith(unit) ? own : own.slice(0, -unit.length);
  try {
    const found = new Reader(bare).whole();
    if (!found.kind) return found.value;
    return found.kind === kind ? rounded(found.value / times) : NaN;
  } catch (fault) {
    if (fault instanceof NoNumber) return NaN;
    throw fault;
  }
}

/** Without what is left of changing units: 0.65 and not 0.6500000000000001. */
function rounded(value: number): number {
  return Number(value.toPrecision(14));
}

/** Whether a text is a unit in which numbers may be typed. */
export function isUnit(text: string): boolean {
  return UNITS.has(text);
}

class NoNumber extends Error {}

const SPACES = /[\s\u00a0\u2009\u202f]*/y;
const OPERATORS: Record<string, string> = { "\u00d7": "*", "\u00b7": "*", ":": "/", "\u00f7": "/", "\u2212": "-", "\u2013": "-" };
const NUMBER = /(?:\d{1,3}(?:[ \u00a0\u2009\u202f'\u2019]\d{3})+(?!\d)|\d+)?(?:[.,]\d*)*(?:[eE][-+]?\d+)?/y;
const HALVES: Record<string, number> = { "\u00bd": 0.5, "\u00bc": 0.25, "\u00be": 0.75 };

/** Reads sums, products, brackets and powers of numbers with units. */
class Reader {
  private at = 0;

  constructor(private readonly text: string) {}

  whole(): Amount {
    const found = this.sum();
    if (this.next() !== "" || !Number.isFinite(found.value)) throw new NoNumber();
    return found;
  }

  private next(): string {
    SPACES.lastIndex = this.at;
    SPACES.exec(this.text);
    this.at = SPACES.lastIndex;
    const found = this.text.charAt(this.at);
    return OPERATORS[found] ?? found;
  }

  private takes(...wanted: string[]): string | null {
    const found = this.next();
    if (found === "" || !wanted.includes(found)) return null;
    this.at += 1;
    return found;
  }

  private sum(): Amount {
    let found = this.product();
    for (let sign = this.takes("+", "-"); sign; sign = this.takes("+", "-")) {
      const other = this.product();
      if (other.kind !== found.kind) throw new NoNumber();
      found = { ...found, value: found.value + (sign === "+" ? other.value : -other.value) };
    }
    return found;
  }

  private product(): Amount {
    let found = this.signed();
    for (let sign = this.takes("*", "/"); sign; sign = this.takes("*", "/")) {
      const other = this.signed();
      if (other.kind && found.kind) throw new NoNumber();
      // The unit behind a fraction is that of the whole: 1/2 in is half an inch.
      const by = sign === "*" ? other.value : other.times ** 2 / other.value;
      found = { ...(found.kind ? found : other), value: found.value * by };
    }
    return found;
  }

  private signed(): Amount {
    const sign = this.takes("+", "-");
    if (!sign) return this.power();
    const found = this.signed();
    return { ...found, value: sign === "-" ? -found.value : found.value };
  }

  private power(): Amount {
    const base = this.amount();
    if (!this.takes("^")) return base;
    const raised = this.signed();
    if (base.kind || raised.kind) throw new NoNumber();
    return { ...base, value: base.value ** raised.value };
  }

  /** A number with its unit; feet and inches, metres and centimetres one behind the other. */
  private amount(): Amount {
    const found = this.single();
    while (found.kind && /[\d.,]/.test(this.next())) {
      const more = this.single();
      if (more.kind !== found.kind || found.value < 0) throw new NoNumber();
      found.value += more.value;
      found.times = NaN; // not behind a fraction
    }
    return found;
  }

  private single(): Amount {
    let value = NaN;
    if (this.takes("(")) {
      const inside = this.sum();
      if (!this.takes(")")) throw new NoNumber();
      if (inside.kind) return inside;
      value = inside.value;
    } else if (this.word("pi") || this.takes("\u03c0")) {
      value = Math.PI;
    } else {
      value = this.digits();
      if (this.takes("\u03c0") || this.word("pi")) value *= Math.PI;
    }
    const [kind, times] = this.unit() ?? ["", 1];
    return { kind, times, value: value * times };
  }

  private digits(): number {
    this.next();
    NUMBER.lastIndex = this.at;
    const found = NUMBER.exec(this.text)?.[0] ?? "";
    this.at += found.length;
    const half = HALVES[this.text.charAt(this.at)];
    if (half !== undefined) this.at += 1;
    if (!/\d/.test(found)) {
      if (half === undefined || found) throw new NoNumber();
      return half;
    }
    return plain(found) + (half ?? 0);
  }

  private word(wanted: string): boolean {
    this.next();
    const there = this.text.startsWith(wanted, this.at) && !/[a-z]/i.test(this.text.charAt(this.at + wanted.length));
    if (there) this.at += wanted.length;
    return there;
  }

  private unit(): Unit | null {
    this.next();
    const name = NAMES.find((each) => this.text.startsWith(each, this.at) && !(/[a-z]$/i.test(each) && /[a-z]/i.test(this.text.charAt(this.at + each.length))));
    if (name === undefined) return null;
    this.at += name.length;
    return UNITS.get(name)!;
  }
}

/** The value of digits with commas or points: the last one of two kinds is the decimal one. */
function plain(digits: string): number {
  const [body = "", power = "0"] = digits.replace(/[ \u00a0\u2009\u202f'\u2019]/g, "").toLowerCase().split("e");
  const marks = [...body].filter((each) => each === "." || each === ",");
  const decimal = marks.length > 1 && new Set(marks).size === 1 ? "" : (marks.at(-1) ?? "");
  const grouped = marks.length > 1;
  const [whole = "", fraction = ""] = decimal ? splitLast(body, decimal) : [body];
  const groups = whole.split(/[.,]/);
  if (grouped && !groups.every((each, k) => (k ? each.length === 3 : each.length > 0 && each.length <= 3))) throw new NoNumber();
  return Number(`${groups.join("")}.${fraction}e${power}`);
}

function splitLast(text: string, mark: string): [string, string] {
  const at = text.lastIndexOf(mark);
  return [text.slice(0, at), text.slice(at + 1)];
}
