// One target curve: drawn by hand or point by point, typed as a formula, or read from a file.

import { sentence } from "../../shared/words.ts";
import { readCurve } from "../server/api.ts";
import { type Segmented, button, segmented } from "../parts/controls.ts";
import { CurvePlot } from "./curve-plot.ts";
import * as tables from "./curve-table.ts";
import { BLANK, FALLBACK, FILES, LEVELS, MODES, TITLES, WIDTHS, WORDS } from "./curve-words.ts";
import { Dimensions } from "./dimensions.ts";
import { h, pickFile, setAttribute } from "../parts/dom.ts";
import { hasEnding, listenForFiles } from "../parts/file-target.ts";
import { faultOf, isAbout } from "../state/faults.ts";
import { FormulaFields } from "./formula-fields.ts";
import { headOf, profileGround } from "./ground.ts";
import { Note } from "../parts/note.ts";
import { scaledNote } from "../parts/scaled-note.ts";
import { PointFields } from "./point-fields.ts";
import { fitStroke } from "./spline.ts";
import type { Store } from "../state/store.ts";
import type { CurveName, CurveTable, Point } from "../state/types.ts";

export class CurveEditor {
  readonly element: HTMLElement;
  private readonly plot: CurvePlot;
  private readonly formula: FormulaFields;
  private readonly fields: PointFields;
  private readonly dimensions: Dimensions;
  private readonly note = new Note();
  private readonly mode: Segmented<tables.Mode>;
  private readonly draw: HTMLButtonElement;
  private readonly tools: HTMLElement;
  /** In the panel, while the curve is drawn on the canvas. */
  private readonly away: HTMLElement;
  private large = false;
  /** The formula that the curve had, for the way back from the spline. */
  private remembered: CurveTable;
  private shown: CurveTable | null = null;
  private stale = false;
  /** What the present drawing has made: who goes back beyond it begins anew. */
  private drawn = new Set<CurveTable>();

  constructor(
    private readonly store: Store,
    private readonly name: CurveName,
    /** The curve is to be drawn on the canvas. */
    private readonly sketch: () => void,
  ) {
    this.remembered = FALLBACK[name];
    this.mode = segmented<tables.Mode>(
      `How ${name} is given`,
      MODES.map((each) => ({ ...each, testid: `mode-${name}-${each.value}` })),
      (mode) => this.switchTo(mode),
    );
    const moved = (index: number, to: Point, gesture: string): void =>
      store.setCurve(name, tables.moved(this.table, index, to), `a point of ${name}`, gesture);
    const removed = (index: number): void => this.removePoint(index);
    this.plot = new CurvePlot(
      name,
      `Curve ${name}, ${WORDS[name]}. Arrow keys move the view, plus and minus zoom, 0 fits, D draws anew.`,
      {
        moved,
        removed,
        released: () => store.rest(),
        added: (at) => this.addPoint(at),
        selected: (index) => {
          if (index !== null) this.fields.select(index);
          this.plot.select(index);
        },
        clicked: (at) => this.putPoint(at),
        stroked: (track) => this.take([...this.begun, ...fitStroke(track)], true, `a stroke of ${name}`),
        turned: (on) => this.turned(on),
        wanted: () => this.startDrawing(),
        last: () => this.begun.at(-1) ?? null,
        beside: () => (name === "f" && store.figure.value ? headOf(this.samples, this.unit) : []),
        backdrop: (plane) => [
          ...(name === "f" ? profileGround(plane, this.standing, this.unit, store.figure.value) : []),
          ...(this.large ? this.dimensions.layOut(plane, this.samples) : []),
        ],
      },
    );
    this.fields = new PointFields(name, {
      moved,
      removed,
      added: (after) => {
        const at = tables.placeAfter(this.table, after);
        if (at) this.addPoint(at);
      },
    });
    this.formula = new FormulaFields(name, (table, gesture) =>
      store.setCurve(name, table, `formula of ${name}`, gesture),
    );
    this.dimensions = new Dimensions(name, (table, what, gesture) => {
      if (this.large) this.plot.refit();
      store.setCurve(name, table, what, gesture);
    });
    this.draw = button({
      label: `Draw ${name} anew`,
      icon: "pencil",
      text: "Draw",
      testid: `draw-${name}`,
      class: "button draw",
      act: () => (this.plot.drawing.active ? this.plot.drawing.turn(false) : this.startDrawing()),
    });
    this.tools = h(
      "div",
      { class: "curve-tools" },
      this.draw,
      button({
        label: `Read ${name} from a CSV, SVG or DXF file`,
        icon: "drop",
        testid: `file-${name}`,
        act: () => void pickFile(FILES).then((file) => file && this.read(file)),
      }),
      this.dimensions.element,
    );
    this.away = h("p", { class: "note curve-away" }, `The ${TITLES[name]} ${name} is being drawn on the canvas.`);
    this.element = this.build();
    listenForFiles(this.element, (file) => {
      const taken = hasEnding(file, FILES);
      if (taken) void this.read(file);
      return taken;
    });
    store.design.bind(() => this.refresh());
    store.curves.bind(() => {
      this.stale = false;
      this.refresh();
    });
    store.fault.bind(() => this.showFault());
    store.figure.watch(() => this.plot.draw());
  }

  private get table(): CurveTable {
    // While a surface is followed, the curve that was followed last.
    return this.store.design.value.target?.[this.name] ?? this.shown ?? FALLBACK[this.name];
  }

  private get unit(): string {
    return this.store.design.value.shell.unit;
  }

  private get samples(): Point[] {
    return tables.samplesOf(this.table) ?? this.store.curves.value?.[this.name] ?? [];
  }

  /** How wide the plane is where there is no curve. */
  private get width(): number {
    return WIDTHS[this.unit] ?? 8;
  }

  /** What stands on the ground: before there is a curve, the ground is at 0. */
  private get standing(): Point[] {
    const { samples } = this;
    return samples.length > 1 ? samples : [[-this.width / 2, 0], [this.width / 2, 0]];
  }

  /** The points that the present drawing has put. */
  private get begun(): Point[] {
    const { points } = this.table;
    return this.drawn.has(this.table) && Array.isArray(points) ? points : [];
  }

  private build(): HTMLElement {
    const { name } = this;
    this.plot.element.append(h("div", { class: "drop-hint" }, "Drop a CSV, SVG or DXF file"));
    return h(
      "section",
      { class: "curve-editor", "aria-label": `Curve ${name}`, "data-curve": name },
      h(
        "header",
        { class: "curve-head" },
        h("h3", { title: WORDS[name] }, h("span", { class: `curve-badge curve-${name}` }, name), h("span", { class: "curve-word" }, TITLES[name])),
        this.mode.element,
      ),
      this.tools,
      this.plot.element,
      this.fields.element,
      this.formula.element,
      scaledNote(this.store, name),
      this.note.element,
    );
  }

  private refresh(): void {
    const { table, unit } = this;
    const mode = tables.modeOf(table);
    const handles = tables.handlesIn(table);
    if (this.shown !== table) {
      // What was said was of another curve.
      if (!isAbout(this.store.fault.value, this.name)) this.note.say("");
      const before = this.shown && tables.modeOf(this.shown);
      const drawn = handles.length > 0 && mode !== "file";
      // Another kind of curve, or one from elsewhere: show all of it.
      if (before !== mode && !(drawn && before && before !== "file")) this.plot.refit();
      if (Array.isArray(table.points) && !table.points.length) this.clear();
      else if (!tables.isCurve(table) || this.begun.length) this.drawn.add(table);
      this.shown = table;
      this.stale = !tables.samplesOf(table);
      if (mode === "formula") this.remembered = table;
      this.mode.set(mode);
      this.fields.element.hidden = !drawn;
      this.formula.element.hidden = mode !== "formula";
      if (mode === "formula") this.formula.show(table);
      if (drawn) this.fields.show(handles.map(({ at }) => at));
      if (mode === "file") this.note.say(`The design names a file; drop it here: ${tables.fileOf(table)}`);
    }
    const blank = Array.isArray(table.points) && !table.points.length;
    this.plot.show({
      samples: this.samples,
      stale: this.stale,
      handles,
      joined: mode === "spline" || mode === "lines",
      blank: blank ? { words: BLANK[this.name], width: this.width, level: LEVELS[this.name] } : null,
    });
    this.plot.select(this.fields.selected);
    this.dimensions.show(table, this.samples, unit);
  }

  /** Show all of the curve when it is next drawn: another design has been opened. */
  refit(): void {
    this.plot.drawing.turn(false);
    this.plot.refit();
  }

  /** Move to a place on the canvas, or back into the panel. */
  enlarge(place: HTMLElement | null): void {
    this.large = place !== null;
    this.plot.drawing.turn(false);
    if (place) {
      this.element.replaceWith(this.away);
      place.append(this.element);
      this.plot.element.append(this.dimensions.element);
    } else {
      this.away.replaceWith(this.element);
      this.tools.append(this.dimensions.element);
    }
    this.dimensions.separate(this.large);
    this.plot.refit();
    this.refresh();
  }

  /** Take the next clicks, strokes and keys as a drawing. */
  begin(): void {
    this.plot.drawing.turn(true);
    this.plot.takeFocus();
  }

  private startDrawing(): void {
    if (this.large) this.begin();
    else this.sketch();
  }

  /** Nothing is drawn yet: the plane on the canvas waits for it. */
  private clear(): void {
    this.drawn.clear();
    this.plot.refit();
    this.plot.drawing.turn(this.large);
  }

  private turned(on: boolean): void {
    this.drawn.clear();
    setAttribute(this.draw, "aria-pressed", String(on));
    this.store.rest();
    if (on) return;
    this.refresh();
    if (this.large && tables.isCurve(this.table)) this.dimensions.takeFocus();
  }

  private putPoint(at: Point): void {
    const rounded = at.map((value) => Number(value.toPrecision(6)) + 0) as Point;
    const points = [...this.begun, rounded];
    this.take(points, this.table.smooth !== false || this.table.path !== undefined, `point ${points.length} of ${this.name}`);
  }

  private take(points: Point[], smooth: boolean, what: string): void {
    const table: CurveTable = { points, smooth };
    this.drawn.add(table);
    this.store.setCurve(this.name, table, what);
  }

  private addPoint(at: Point): void {
    const found = tables.withPointNear(this.table, at);
    if (!found) return;
    this.store.setCurve(this.name, found.table, `a point of ${this.name}`);
    this.fields.select(found.index);
    this.plot.focus(found.index);
  }

  private removePoint(index: number): void {
    this.store.setCurve(this.name, tables.removed(this.table, index), `point ${index + 1} of ${this.name} removed`);
    this.plot.focus(Math.min(index, tables.handlesIn(this.table).length - 1));
  }

  private switchTo(mode: tables.Mode): void {
    const now = tables.modeOf(this.table);
    if (mode === now || mode === "file") return;
    this.plot.drawing.turn(false);
    if (mode === "formula") {
      this.store.setCurve(this.name, this.remembered, `formula of ${this.name}`);
      return;
    }
    const table = tables.given(this.table, mode, this.samples);
    if (!table) {
      this.mode.set(now);
      this.note.say("There is no curve yet to put points on.");
      return;
    }
    this.store.setCurve(this.name, table, `${this.name} as ${mode === "spline" ? "a spline" : mode === "lines" ? "lines" : "a path"}`);
  }

  /** Take the curve of a CSV, SVG or DXF file. */
  async read(file: File): Promise<void> {
    try {
      const { table, note } = await readCurve(file, this.unit);
      this.plot.drawing.turn(false);
      this.plot.refit();
      this.store.setCurve(this.name, table as CurveTable, `${this.name} from ${file.name}`);
      const beyond = tables.piecesBeyond(table as CurveTable);
      this.note.say(sentence(note) + (beyond ? " These are too many to be dragged one by one: Spline puts few points on it." : ""));
    } catch (error) {
      this.note.say(sentence(faultOf(error).message), true);
    }
  }

  private showFault(): void {
    const fault = this.store.fault.value;
    const mine = isAbout(fault, this.name);
    this.element.classList.toggle("faulty", mine);
    this.note.showFault(mine ? this.store.labels.said(fault!.what) : null);
  }
}
