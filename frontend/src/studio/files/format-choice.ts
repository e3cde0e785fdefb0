// The formats of a task, one of them chosen; those that the design has nothing for say what is missing.

import { h, uniqueId } from "../parts/dom.ts";
import type { Design, ExportTask, FileFormat } from "../state/types.ts";

const MISSING = { "": "", thickness: "needs a thickness of panels", loads: "needs supports and loads" };

export class FormatChoice {
  readonly element: HTMLElement;
  private readonly rows: { format: FileFormat; input: HTMLInputElement; what: HTMLElement }[];

  constructor(task: ExportTask, formats: readonly FileFormat[], changed: () => void) {
    const name = uniqueId("format");
    this.rows = formats.map((format) => ({
      format,
      input: h("input", { type: "radio", name, value: format.name, "data-testid": `format-${format.name}`, onchange: changed }),
      what: h("span", { class: "format-what" }),
    }));
    this.element = h(
      "div",
      { class: "formats", role: "radiogroup", "aria-label": `Format: ${task.label}` },
      ...this.rows.map(({ format, input, what }) => h("label", { class: "format" }, input, h("span", { class: "format-name" }, format.name.toUpperCase()), what)),
    );
  }

  get chosen(): FileFormat | undefined {
    return this.rows.find(({ input }) => input.checked)?.format;
  }

  /** Offer what a design has; without a choice that stands, the first that shows most of it is taken. */
  offer(design: Design): void {
    for (const { format, input, what } of this.rows) {
      const lacks = !has(design, format.needs);
      input.disabled = lacks;
      if (lacks) input.checked = false;
      what.textContent = lacks ? MISSING[format.needs] : format.what;
    }
    if (this.chosen) return;
    const offered = this.rows.filter(({ input }) => !input.disabled);
    const first = offered.find(({ format }) => format.needs) ?? offered[0];
    if (first) first.input.checked = true;
  }
}

/** Whether a design has what a format needs. */
export function has(design: Design, needs: FileFormat["needs"]): boolean {
  if (needs === "thickness") return Number(design.panel?.["thickness"] ?? 0) > 0;
  if (needs === "loads") return Boolean(design.structure);
  return true;
}
