// One target curve: drawn as a spline, typed as a formula, or read from a file.

import { readCurve } from "./api.ts";
import { type Segmented, button, segmented } from "./controls.ts";
import { CurvePlot } from "./curve-plot.ts";
import { h, pickFile } from "./dom.ts";
import { faultOf, isAbout, sentence } from "./faults.ts";
import { FormulaFields } from "./formula-fields.ts";
import { icon } from "./icons.ts";
import { PointFields } from "./point-fields.ts";
import { between, fitPoints, placeAmong } from "./spline.ts";
import type { Store } from "./store.ts";
import type { CurveName, CurveTable, Point } from "./types.ts";

type Mode = "spline" | "lines" | "formula" | "file";
const FILES = ".csv,.txt,.svg,.dxf";
const TITLES: Record<CurveName, string> = { f: "profile", g: "path" };
const WORDS: Record<CurveName, string> = {
  f: "the profile that is swept",
  g: "the path that f is swept along",
};
const FALLBACK: Record<CurveName, CurveTable> = {
  f: { formula: "-x**2", range: [-1, 1] },
  g: { formula: "0.25*sin(pi*x/2)", range: [0, 4] },
};

export class CurveEditor {
  readonly element: HTMLElement;
  private readonly plot: CurvePlot;
  private readonly formula: FormulaFields;
  private readonly fields: PointFields;
  private readonly note = h("p", { class: "note", hidden: true });
  private readonly mode: Segmented<Mode>;
  /** The formula that the curve had, for the way back from the spline. */
  private remembered: CurveTable;
  private shown: CurveTable | null = null;

  constructor(
    private readonly store: Store,
    private readonly name: CurveName,
  ) {
    this.remembered = FALLBACK[name];
    this.mode = segmented<Mode>(
      `How ${name} is given`,
      [
        { value: "spline", text: "Spline", testid: `mode-${name}-spline`, title: "a smooth curve through points that can be dragged" },
        { value: "lines", text: "Lines", testid: `mode-${name}-lines`, title: "straight lines between points that can be dragged" },
        { value: "formula", text: "Formula", testid: `mode-${name}-formula`, title: "type y(x), or x(t) and y(t)" },
      ],
      (mode) => this.switchTo(mode),
    );
    const moved = (index: number, to: Point, gesture: string): void => this.move(index, to, gesture);
    const removed = (index: number): void => this.removePoint(index);
    this.plot = new CurvePlot(
      name,
      `Curve ${name}, ${WORDS[name]}. Arrow keys move the view, plus and minus zoom, 0 fits.`,
      {
        moved,
        removed,
        released: () => store.rest(),
        added: (at) => this.addPoint(at),
        selected: (index) => {
          if (index !== null) this.fields.select(index);
          this.plot.select(index);
        },
      },
    );
    this.fields = new PointFields(name, {
      moved,
      removed,
      added: (after) => this.addAfter(after),
    });
    this.formula = new FormulaFields(name, (table, gesture) =>
      store.setCurve(name, table, `formula of ${name}`, gesture),
    );
    this.element = this.build();
    this.listenForFiles();
    store.design.bind(() => this.refresh());
    store.curves.bind(() => this.refresh());
    store.fault.bind(() => this.showFault());
  }

  private get table(): CurveTable {
    return this.store.design.value.target[this.name];
  }

  /** Control points as they are drawn: enlarged by the table's scale. */
  private get points(): Point[] {
    const { points, scale = 1 } = this.table;
    if (!Array.isArray(points)) return [];
    return scale === 1 ? points : points.map(([x, y]) => [x * scale, y * scale]);
  }

  private build(): HTMLElement {
    const { name } = this;
    const tools = h(
      "div",
      { class: "plot-tools" },
      button({ label: `Zoom in on ${name}`, icon: "plus", act: () => this.plot.zoom(1.25) }),
      button({ label: `Zoom out of ${name}`, icon: "minus", act: () => this.plot.zoom(0.8) }),
      button({ label: `Fit ${name} into view`, icon: "fit", act: () => this.plot.fit() }),
    );
    this.plot.element.append(tools, h("div", { class: "drop-hint" }, "Drop a CSV, SVG or DXF file"));
    return h(
      "section",
      { class: "curve-editor", "aria-label": `Curve ${name}`, "data-curve": name },
      h(
        "header",
        { class: "curve-head" },
        h("h3", { title: WORDS[name] }, h("span", { class: `curve-badge curve-${name}` }, name), h("span", { class: "curve-word" }, TITLES[name])),
        button({
          label: `Read ${name} from a CSV, SVG or DXF file`,
          icon: "drop",
          testid: `file-${name}`,
          act: () => void pickFile(FILES).then((file) => file && this.read(file)),
        }),
        this.mode.element,
      ),
      this.plot.element,
      this.fields.element,
      this.formula.element,
      this.note,
    );
  }

  private refresh(): void {
    const { table } = this;
    const mode = modeOf(table);
    const samples = this.store.curves.value?.[this.name] ?? [];
    if (this.shown !== table) {
      // What was said was of another curve.
      if (!isAbout(this.store.fault.value, this.name)) this.say("");
      const drawn = mode === "spline" || mode === "lines";
      // Another kind of curve, or one from elsewhere: show all of it.
      const before = this.shown && modeOf(this.shown);
      if (before !== mode && !(drawn && before && before !== "file")) this.plot.refit();
      this.shown = table;
      if (mode === "formula") this.remembered = table;
      this.mode.set(mode);
      this.fields.element.hidden = !drawn;
      this.formula.element.hidden = mode !== "formula";
      if (mode === "formula") this.formula.show(table);
      if (drawn) this.fields.show(this.points);
      if (mode === "file") this.say(`The design names a file; drop it here: ${fileOf(table)}`);
    }
    this.plot.show(samples, this.points);
    this.plot.select(this.fields.selected);
  }

  /** Show all of the curve when it is next drawn: another design has been opened. */
  refit(): void {
    this.plot.refit();
  }

  private move(index: number, to: Point, gesture: string): void {
    const points = this.points.map((point, i) => (i === index ? to : point));
    this.setPoints(points, `point ${index + 1} of ${this.name}`, gesture);
  }

  private addPoint(at: Point): void {
    const { points } = this;
    if (points.length < 2) return;
    this.insert(placeAmong(points, at), at);
  }

  private addAfter(after: number): void {
    const { points } = this;
    const index = Math.min(after, points.length - 2);
    this.insert(index + 1, between(points, index));
  }

  private insert(index: number, at: Point): void {
    const rounded = at.map((value) => Number(value.toPrecision(6))) as Point;
    this.setPoints(this.points.toSpliced(index, 0, rounded), `a point of ${this.name}`);
    this.fields.select(index);
    this.plot.focus(index);
  }

  private removePoint(index: number): void {
    if (this.points.length <= 2) return;
    this.setPoints(this.points.toSpliced(index, 1), `point ${index + 1} of ${this.name} removed`);
    this.plot.focus(Math.min(index, this.points.length - 1));
  }

  private setPoints(points: Point[], what: string, gesture = ""): void {
    const { scale = 1 } = this.table;
    const own = scale === 1 ? points : points.map(([x, y]): Point => [x / scale, y / scale]);
    this.store.setCurve(this.name, { ...this.table, points: own }, what, gesture);
  }

  private switchTo(mode: Mode): void {
    const now = modeOf(this.table);
    if (mode === now) return;
    if (mode === "formula") {
      this.store.setCurve(this.name, this.remembered, `formula of ${this.name}`);
      return;
    }
    const smooth = mode === "spline";
    const what = `${this.name} as ${smooth ? "a spline" : "lines"}`;
    if (now !== "formula" && now !== "file") {
      this.store.setCurve(this.name, { ...this.table, smooth }, what);
      return;
    }
    const samples = this.store.curves.value?.[this.name];
    if (!samples || samples.length < 2) {
      this.mode.set(now);
      this.say("There is no curve yet to put points on.");
      return;
    }
    this.store.setCurve(this.name, { points: fitPoints(samples), smooth }, what);
  }

  /** Take the curve of a CSV, SVG or DXF file. */
  async read(file: File): Promise<void> {
    try {
      const curve = await readCurve(file, this.store.design.value.shell.unit);
      const table: CurveTable = { points: curve.points, smooth: curve.smooth };
      this.plot.refit();
      this.store.setCurve(this.name, table, `${this.name} from ${file.name}`);
      this.say(sentence(curve.note));
    } catch (error) {
      this.say(sentence(faultOf(error).message), true);
    }
  }

  private listenForFiles(): void {
    const { element } = this;
    const files = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
    element.addEventListener("dragover", (event) => {
      if (!files(event)) return;
      event.preventDefault();
      element.classList.add("dropping");
    });
    element.addEventListener("dragleave", (event) => {
      if (!element.contains(event.relatedTarget as Node | null)) element.classList.remove("dropping");
    });
    element.addEventListener("drop", (event) => {
      element.classList.remove("dropping");
      const file = event.dataTransfer?.files[0];
      if (!file || /\.toml$/i.test(file.name)) return;
      event.preventDefault();
      event.stopPropagation();
      void this.read(file);
    });
  }

  private showFault(): void {
    const fault = this.store.fault.value;
    const mine = isAbout(fault, this.name);
    this.element.classList.toggle("faulty", mine);
    if (mine) this.say(sentence(this.store.labels.said(fault!.what)), true);
    else if (this.note.classList.contains("error")) this.say("");
  }

  private say(text: string, wrong = false): void {
    this.note.replaceChildren(...(wrong ? [icon("warning"), text] : [text]));
    this.note.hidden = !text;
    this.note.classList.toggle("error", wrong);
  }
}

function modeOf(table: CurveTable): Mode {
  if (table.formula !== undefined) return "formula";
  if (!Array.isArray(table.points)) return "file";
  return table.smooth === false ? "lines" : "spline";
}

function fileOf(table: CurveTable): string {
  return String(table.points ?? table["svg"] ?? table["dxf"] ?? "");
}
