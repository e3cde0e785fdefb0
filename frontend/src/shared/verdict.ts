// The verdict on a shell: independent rows, worst first, as terminal and report have them. A row says
// its sign and subject, and its finding when it is opened.

import type { Row } from "./api-types.ts";
import type { Known } from "./view.ts";
import { capital, sentence } from "./words.ts";

export const SIGNS = { fails: "\u2715", warns: "!", holds: "\u2713" } as const;
export const PENDING = "\u2026";
export const MEANS = { fails: "fails", warns: "attention", holds: "holds" } as const;
/** The row of what nobody looked at. */
const UNCHECKED = "unchecked";
const HEADS = { fails: "Fails", warns: "Needs attention", holds: "Holds" } as const;

export type Tone = keyof typeof SIGNS;
type Judged = Row & { sign: Tone };

/** The rows that judge; what only informs stands among the figures. */
export function judged(report: Known | null): Judged[] {
  return (report?.verdict ?? []).filter((row): row is Judged => row.sign !== "says");
}

/** The worst of the rows, and which they are. */
export function headline(rows: readonly Judged[]): [string, Tone] | null {
  const tone = rows[0]?.sign;
  if (!tone) return null;
  const checked = rows.filter(({ subject }) => subject !== UNCHECKED);
  if (tone === "warns" && checked.length && checked.every(({ sign }) => sign === "holds")) return ["Holds as far as it is checked", tone];
  // Two ends that are closed are two rows.
  const subjects = new Set(rows.filter(({ sign }) => sign === tone).map(({ subject }) => capital(subject)));
  return [`${HEADS[tone]}: ${[...subjects].join(", ")}`, tone];
}

/** What is said of rows that are not known. */
export interface Missing {
  words: string;
  sign?: Tone;
  /** Makes the button that looks again. */
  mend?: () => HTMLElement;
}

/** A row as it is shown now: what was found, or what is said as long as nothing is. */
export interface Shown {
  subject: string;
  sign: Tone | "pending";
  words: string;
  /** None of what is not known. */
  row: Judged | null;
}

/** The rows of a report in their order, what is not known first. `missing`: what is said of rows that nobody
 * has looked at so far, if more is to come; `found`: whether the others are known. */
export function shownRows(report: Known | null, missing: Missing | null, found: boolean): Shown[] {
  const rows = judged(report);
  const isOpen = (row: Judged): boolean => missing !== null && row.subject !== UNCHECKED && !(found && row.known);
  const open = rows.filter(isOpen).map(({ subject }) => subject);
  if (found && missing?.sign && !open.length) open.push("remedies");
  const known = missing && !found ? [] : rows.filter((row) => !isOpen(row));
  return [
    ...open.map((subject): Shown => ({ subject, sign: missing!.sign ?? "pending", words: missing!.words, row: null })),
    ...known.map((row): Shown => ({ subject: row.subject, sign: row.sign, words: row.finding, row })),
  ];
}

export class Verdict {
  readonly element = document.createElement("ul");
  /** By their subjects, the rows that were opened or closed. */
  private readonly chosen = new Map<string, boolean>();

  /** `said` puts texts into the page's words; `mend` makes a button of what mends a row; `beside` has what
   * stands below a note, or below a row that says it. */
  constructor(
    private readonly said = (text: string): string => text,
    private readonly mend = (_: Pick<Row, "changes">): HTMLElement | null => null,
    private readonly beside = (_note: string): HTMLElement | null => null,
  ) {
    this.element.className = "orishell-verdict";
    this.element.setAttribute("aria-label", "Verdict");
  }

  /** Rows as `shownRows` has them. */
  show(report: Known | null, missing: Missing | null = null, found = false): void {
    const shown = shownRows(report, missing, found);
    const items = shown.map((each, place) => (each.row ? this.row(each.row, !missing && place === 0 && each.sign !== "holds") : this.unknown(each, missing!, place === 0)));
    this.element.replaceChildren(...items, ...(missing && !found ? [] : this.notesOf(report)));
  }

  /** Open a row; it is given back, if it is there to be read. */
  open(subject: string): HTMLElement | null {
    const item = this.element.querySelector<HTMLElement>(`[data-row="${subject}"]`);
    const row = item?.querySelector("details");
    if (row) this.chosen.set(subject, (row.open = true));
    return item;
  }

  /** The row of all notes, if there are any. */
  private notesOf(report: Known | null): HTMLElement[] {
    const rows = new Set(judged(report).map(({ finding }) => finding));
    const notes = new Set([...(report?.warnings ?? []), ...(report?.structure?.warnings ?? [])].filter((note) => !rows.has(note)));
    return notes.size ? [this.notes(notes)] : [];
  }

  private row(row: Judged, first: boolean): HTMLElement {
    const text = document.createElement("span");
    text.className = "orishell-finding";
    text.textContent = ` ${this.said(row.finding)}`;
    const item = this.item(row.sign, row.subject, first, text);
    // What a row says in a note's words is mended as the note is.
    item.firstElementChild!.append(...[this.beside(row.finding) ?? []].flat());
    if (!row.remedy) return item;
    const mends = document.createElement("p");
    mends.textContent = `\u2192 ${this.said(row.remedy)}`;
    item.firstElementChild!.append(mends, ...[this.mend(row) ?? []].flat());
    return item;
  }

  /** A row of which nothing is known; the first has what looks again. */
  private unknown({ subject }: Shown, { words, mend, sign }: Missing, first: boolean): HTMLElement {
    const said = document.createElement("span");
    said.className = "orishell-pending";
    said.textContent = ` ${words}`;
    if (sign) {
      const item = this.item(sign, subject, true, said);
      if (mend && first) item.firstElementChild!.append(mend());
      return item;
    }
    const dots = document.createElement("span");
    dots.setAttribute("aria-hidden", "true");
    dots.textContent = PENDING;
    return listed("pending", subject, dots, bold(subject), said);
  }

  private notes(notes: ReadonlySet<string>): HTMLElement {
    const item = this.item("warns", notes.size === 1 ? "1 note" : `${notes.size} notes`, false, "", "notes");
    for (const text of notes) {
      const line = document.createElement("p");
      line.className = "orishell-warning";
      line.textContent = sentence(this.said(text));
      item.firstElementChild!.append(line, ...[this.beside(text) ?? []].flat());
    }
    return item;
  }

  private item(tone: Tone, subject: string, first: boolean, finding: string | Node, name = subject): HTMLElement {
    const row = document.createElement("details");
    row.open = this.chosen.get(name) ?? first;
    const head = document.createElement("summary");
    head.dataset["testid"] = `verdict-${name}`;
    head.addEventListener("click", () => this.chosen.set(name, !row.open));
    head.append(signOf(tone), bold(subject), finding);
    row.append(head);
    return listed(tone, name, row);
  }
}

export function signOf(tone: Tone): HTMLElement {
  const mark = document.createElement("span");
  mark.textContent = SIGNS[tone];
  mark.setAttribute("role", "img");
  mark.setAttribute("aria-label", MEANS[tone]);
  return mark;
}

function bold(subject: string): HTMLElement {
  const name = document.createElement("b");
  name.textContent = capital(subject);
  return name;
}

function listed(sign: string, name: string, ...parts: Node[]): HTMLElement {
  const item = document.createElement("li");
  item.dataset["sign"] = sign;
  item.dataset["row"] = name;
  item.append(...parts);
  return item;
}
