// The drawn sheet of a design: read from the file of a crease pattern, and what is known of it.

import { capital, sentence } from "../../shared/words.ts";
import { button, numberBox, setNumber } from "../parts/controls.ts";
import { h, pickFile } from "../parts/dom.ts";
import { hasEnding, listenForFiles } from "../parts/file-target.ts";
import { Note } from "../parts/note.ts";
import { short } from "../parts/numbers.ts";
import { describeDrawing, looksLikePattern, readPattern } from "../server/api.ts";
import { ServerFault, faultOf } from "../state/faults.ts";
import { requireSmall } from "../state/file-size.ts";
import type { Work } from "../state/named.ts";
import { ofFile } from "../state/stale.ts";
import type { Store } from "../state/store.ts";
import type { Design, DrawingTable } from "../state/types.ts";

export const PATTERNS = ".fold,.svg,.dxf,.cp";

export class DrawingForm {
  readonly element: HTMLElement;
  private readonly unit = h("select", { id: "drawing-unit", "data-testid": "drawing-unit" });
  private readonly scale = numberBox({ step: "any", min: 0, id: "drawing-scale", "data-testid": "drawing-scale" }, (value) => {
    if (value > 0) this.store.set({ "target.pattern.scale": value }, "scale of the drawing", "type-drawing-scale");
  });
  /** Of a drawing without a unit: how wide the sheet is, which says how large a unit of it is. */
  private readonly width = numberBox({ step: "any", min: 0, id: "drawing-width", "data-testid": "drawing-width" }, (value) => {
    if (value > 0) this.store.set({ "target.pattern.scale": Number((value / this.drawn).toPrecision(15)) }, "size of the drawing", "type-drawing-width");
  });
  private readonly widthUnit = h("span", { class: "unit" });
  private readonly asks: HTMLElement;
  /** How wide the sheet is as it is drawn. */
  private drawn = 1;
  private readonly facts = h("dl", { "data-testid": "drawing-facts" });
  private readonly note = new Note();
  private shown: DrawingTable | null = null;

  constructor(
    private readonly store: Store,
    /** Take another design in place of the present one. */
    private readonly begin: (work: Work) => void,
  ) {
    this.unit.append(...store.info.units.map((unit) => h("option", { value: unit }, unit)));
    this.unit.addEventListener("change", () => store.set({ "target.pattern.unit": this.unit.value }, "unit of the drawing"));
    this.asks = h(
      "div",
      { class: "drawing-asks", "data-testid": "drawing-asks", hidden: true },
      h("label", { for: "drawing-width" }, "The drawing has no unit: how wide is the sheet?"),
      h("div", { class: "drawing-width" }, this.width, this.widthUnit),
    );
    this.element = h(
      "section",
      { class: "drawing-form", "aria-label": "Drawing", "data-testid": "drawing-form" },
      button({
        label: "Read a crease pattern: FOLD, SVG, DXF or CP",
        icon: "drop",
        text: "Pattern file",
        testid: "file-drawing",
        act: () => void pickFile(PATTERNS).then((file) => file && this.read(file)),
      }),
      this.asks,
      this.facts,
      h(
        "div",
        { class: "surface-mesh" },
        h("label", { for: "drawing-unit", title: "the unit in which it was drawn" }, "Drawn in"),
        this.unit,
        h("label", { for: "drawing-scale", title: "what all lengths are multiplied with" }, "Scale"),
        this.scale,
      ),
      this.note.element,
    );
    listenForFiles(this.element, (file) => {
      const taken = hasEnding(file, PATTERNS);
      if (taken) void this.read(file);
      return taken;
    });
    store.design.bind((now, before) => void this.refresh(now, before));
  }

  private async refresh(now: Design, before: Design): Promise<void> {
    const table = now.target?.pattern;
    if (!table) return;
    if (table !== this.shown && table.vertices !== this.shown?.vertices) this.note.say("");
    const same = table === this.shown && now.shell === before.shell;
    this.shown = table;
    this.unit.value = table.unit ?? now.shell.unit;
    setNumber(this.scale, short(table.scale ?? 1, 8));
    const xs = (table.vertices ?? []).flat().map(([x]) => x);
    this.drawn = xs.length ? Math.max(...xs) - Math.min(...xs) || 1 : 1;
    this.asks.hidden = !xs.length || table.unit !== undefined || (table.scale !== undefined && document.activeElement !== this.width);
    this.widthUnit.textContent = now.shell.unit;
    setNumber(this.width, short((table.scale ?? 1) * this.drawn, 6));
    if (!same) await this.describe(now);
  }

  private async describe(design: Design): Promise<void> {
    const { files } = this.store;
    files.set(files.value + 1);
    try {
      const { rows } = await describeDrawing(design);
      if (design.target?.pattern !== this.shown) return;
      this.facts.replaceChildren(...rows.flatMap(({ subject, finding }) => [h("dt", {}, capital(subject)), h("dd", {}, finding)]));
    } catch (error) {
      // What is wrong with it is said when the shell is asked for.
      if (!(error instanceof ServerFault)) throw error;
      this.facts.replaceChildren();
    } finally {
      files.set(files.value - 1);
    }
  }

  /** Whether a drawing is a crease pattern by its looks; one that cannot be looked at is asked about. */
  async looksRight(file: File): Promise<boolean> {
    const { files, info } = this.store;
    if (file.size > info.limits.bytes / 2) return false;
    files.set(files.value + 1);
    try {
      return await looksLikePattern(file);
    } catch {
      return false;
    } finally {
      files.set(files.value - 1);
    }
  }

  /** Take the pattern of a file as another design; what is asked of its reader mends what it refused. */
  async read(file: File, asked: Record<string, unknown> = {}): Promise<void> {
    const { store } = this, { files, info } = store;
    const { unit } = store.design.value.shell;
    files.set(files.value + 1);
    try {
      requireSmall(file, info.limits.bytes, "patterns");
      const { table, note } = await readPattern(file, unit, asked);
      const family = Object.keys(info.families).find((name) => info.families[name]!.aims.includes("drawing"))!;
      const design: Design = { shell: { family, unit }, target: { pattern: table as DrawingTable }, pattern: {} };
      // It is in no design file yet.
      this.begin({ name: file.name.replace(/\.\w+$/, ""), design, home: { file: null, slot: null, text: "" } });
      this.note.say(sentence(note));
      if (!this.asks.hidden) this.width.select();
    } catch (error) {
      const fault = faultOf(error);
      if (fault.kind === "network") return store.fault.set(fault);
      const mended = fault.remedies.length ? { remedy: "", again: (changes: Record<string, unknown>) => void this.read(file, changes) } : {};
      store.refused.set(error instanceof ServerFault ? error.drawing : null);
      store.fault.set(ofFile({ ...fault, place: fault.where, ...mended }));
    } finally {
      files.set(files.value - 1);
    }
  }
}
