// front.html: the front of a search, the shells of its members, and two of them compared.

import type { FrontPage } from "../shared/api-types.ts";
import { inflated } from "../shared/packed.ts";
import { decodeView, type View } from "../shared/view.ts";
import { element } from "../viewer/elements.ts";
import { adoptStyles } from "../viewer/styles.ts";
import { Theme } from "../viewer/theme.ts";
import { stepsOf, tableOf } from "./details.ts";
import looks from "./front.css?inline";
import { keyOf } from "./key.ts";
import { Plot } from "./plot.ts";
import { Shells, type Shown } from "./shells.ts";
import { nameOf } from "./words.ts";

export class Page {
  chosen: number;
  pinned: number | null = null;
  /** Nothing is being unpacked. */
  idle = false;
  readonly shells = new Shells();
  private readonly plot: Plot;
  private readonly key = element("ul", "key");
  private readonly title = element("h2", "");
  private readonly compare = element("button", "compare", { type: "button" });
  private readonly hint = element("p", "hint");
  private readonly file = element("p", "file");
  private readonly table = element("div", "figures-frame");
  private readonly steps = element("div", "");
  private readonly said = element("p", "hidden", { role: "status" });
  private readonly views = new Map<number, View>();
  private pair: [number, number];

  constructor(private readonly page: FrontPage) {
    adoptStyles(document, looks);
    const root = element("main", "orishell-viewer orishell-front");
    const theme = new Theme(document.documentElement);
    const head = element("header", "head");
    const words = element("div", "");
    words.append(element("h1", "", {}, `${page.title}: the front of a search`), element("p", "", {}, page.said));
    head.append(words, theme.button());

    const objectives = page.figures.filter(({ minimised }) => minimised).length;
    this.pair = [0, Math.min(1, objectives - 1)];
    this.plot = new Plot(page, this.pair);
    this.plot.onPick = (number, compared) => (compared ? this.pin(number) : this.pick(number));
    const drawing = element("section", "plot", { "aria-label": "The front" });
    const sheet = element("div", "plot-sheet");
    sheet.append(this.plot.element);
    if (objectives > 2) drawing.append(this.axes(objectives));
    drawing.append(sheet, this.key, element("p", "note", {}, "Click a point, or go from one to the next by arrow keys. Shift and click compares."));

    const details = element("section", "details", { "aria-label": "The design that is chosen" });
    const line = element("div", "details-head");
    line.append(this.title, this.compare);
    this.compare.hidden = page.members.length < 2;
    this.compare.addEventListener("click", () => this.pin(this.pinned === null ? this.chosen : null));
    details.append(line, this.hint, this.table, this.steps, this.file, this.said);
    const left = element("div", "left");
    left.append(head, drawing, details);
    root.append(left, this.shells.element);
    document.body.append(root);

    this.chosen = page.knee;
    new ResizeObserver(() => this.draw()).observe(sheet);
    this.draw();
    void this.show();
  }

  /** Choose a member. */
  pick(number: number): void {
    this.chosen = number;
    void this.show();
  }

  /** Compare with a member, or with none. */
  pin(number: number | null): void {
    this.pinned = number;
    void this.show();
  }

  private draw(): void {
    this.plot.draw();
    this.key.replaceChildren(...keyOf(this.page, this.plot.outside));
  }

  private axes(objectives: number): HTMLElement {
    const names = this.page.figures.slice(0, objectives).map(({ name }) => name);
    const bar = element("div", "axes");
    const boxes = ["Across", "Up"].map((label, axis) => {
      const box = element("select", "");
      names.forEach((name, k) => box.add(new Option(name, String(k), false, k === this.pair[axis])));
      const frame = element("label", "", {}, label);
      frame.append(box);
      bar.append(frame);
      return box;
    }) as [HTMLSelectElement, HTMLSelectElement];
    boxes.forEach((box, axis) => box.addEventListener("change", () => {
      const other = 1 - axis;
      // The one takes the place of the other.
      if (box.value === boxes[other]!.value) boxes[other]!.value = String(this.pair[axis]);
      this.pair = [Number(boxes[0].value), Number(boxes[1].value)];
      this.plot.show(this.pair);
      this.draw();
    }));
    return bar;
  }

  private async show(): Promise<void> {
    const { chosen, page } = this;
    const other = this.pinned === chosen ? null : this.pinned;
    this.idle = false;
    this.plot.mark(chosen, this.pinned);
    const numbers = other === null ? [chosen] : [chosen, other];
    const views = await Promise.all(numbers.map((number) => this.view(number)));
    if (chosen !== this.chosen || other !== (this.pinned === chosen ? null : this.pinned)) return;
    const shown = numbers.map((number, k): Shown => ({ name: this.name(number), view: views[k]!, missing: page.members[number]!.missing }));
    this.shells.show(shown[0]!, shown[1] ?? null);

    this.title.textContent = this.name(chosen);
    this.compare.textContent = this.pinned === null ? "Compare" : "Stop comparing";
    this.compare.setAttribute("aria-pressed", String(this.pinned !== null));
    this.hint.textContent = this.pinned !== null && other === null ? `Choose another point to see it beside ${this.name(chosen)}.` : "";
    this.table.replaceChildren(tableOf(page, numbers, views));
    const steps = stepsOf(page, chosen, (to) => this.pick(to));
    this.steps.replaceChildren(...(steps.children.length ? [element("h3", "", {}, "Its neighbours on the front"), steps] : []));
    const { file } = page.members[chosen]!;
    this.file.replaceChildren("Its design file, beside this page: ", element("code", "", {}, file));
    this.said.textContent = shown.map(({ name }) => name).join(" compared with ");
    this.idle = true;
  }

  private name(number: number): string {
    return nameOf(this.page.members[number]!.file) + (number === this.page.knee ? ", the knee" : "");
  }

  private async view(number: number): Promise<View | null> {
    const packed = this.page.members[number]!.view;
    if (packed === null) return null;
    const known = this.views.get(number) ?? decodeView(await inflated(packed));
    this.views.set(number, known);
    return known;
  }
}
