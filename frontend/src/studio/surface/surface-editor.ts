// The target surface: by a formula, three formulas, or a mesh; and the rectangle of it that is covered.

import { sentence } from "../../shared/words.ts";
import { button, numberBox, segmented, setNumber } from "../parts/controls.ts";
import { h, pickFile } from "../parts/dom.ts";
import { listenForFiles } from "../parts/file-target.ts";
import { Note } from "../parts/note.ts";
import { short } from "../parts/numbers.ts";
import { readSurface } from "../server/api.ts";
import { faultOf, isAboutSurface } from "../state/faults.ts";
import { requireSmall } from "../state/file-size.ts";
import { designFor } from "../state/aims.ts";
import { changed } from "../state/changed.ts";
import type { Store } from "../state/store.ts";
import type { Point, SurfaceTable } from "../state/types.ts";
import type { Patch } from "./patch.ts";
import { PlanPlot } from "./plan-plot.ts";
import { READY_MADE } from "./ready-made.ts";
import { SurfaceFields } from "./surface-fields.ts";
import { type Kind, cornersOf, kindOf, patchOf, withCorner, withPatch } from "./surface-table.ts";

export const MESHES = ".obj,.stl,.ply,.glb,.gltf";
const KINDS = [
  { value: "height", text: "z(x, y)", title: "a height over x and y" },
  { value: "map", text: "x, y, z(u, v)", title: "three formulas of u and v" },
  { value: "mesh", text: "Mesh", title: "triangles out of an OBJ, STL, PLY or glTF file" },
] as const;

export class SurfaceEditor {
  readonly element: HTMLElement;
  private readonly kind = segmented<Kind>(
    "How the surface is given",
    KINDS.map((each) => ({ ...each, testid: `mode-surface-${each.value}` })),
    (kind) => this.switchTo(kind),
  );
  private readonly fields: SurfaceFields;
  private readonly plan: PlanPlot;
  private readonly sizes: HTMLElement;
  private readonly boxes: HTMLInputElement[];
  private readonly unit = h("select", { id: "mesh-unit", "data-testid": "mesh-unit" });
  private readonly auto = button({
    label: "Put corners where the rim turns most",
    text: "Corners as found",
    testid: "mesh-corners",
    act: () => {
      const { corners: _, ...rest } = this.table;
      this.set(rest, "corners");
    },
  });
  private readonly mesh = h(
    "div",
    { class: "surface-mesh" },
    h("label", { for: "mesh-unit", title: "the unit in which the file was drawn" }, "Drawn in"),
    this.unit,
    h("span", { class: "spacer" }),
    this.auto,
  );
  /** Of a family that sweeps f along g. */
  private readonly curves = button({
    label: "Go on with the curves f and g that were fitted",
    text: "Go on with f and g",
    testid: "by-curves",
    act: () => this.store.set(this.store.report.value?.by_curves ?? {}, "the curves of the surface"),
  });
  private readonly note = new Note();
  /** Tables as they were left, for the way back. */
  private readonly left = new Map<Kind, SurfaceTable>();
  private shown: SurfaceTable | null = null;

  constructor(
    private readonly store: Store,
    /** Called before another surface takes the place of the present one. */
    private readonly another: () => void,
  ) {
    this.fields = new SurfaceFields((table, gesture) => this.set(table, "formula of the surface", gesture));
    this.plan = new PlanPlot({
      changed: (patch, gesture) => this.set(withPatch(this.table, patch), "rectangle", gesture),
      cornered: (corner, to, gesture) => {
        const drawn = store.surface.value;
        if (drawn) this.set(withCorner(this.table, drawn, corner, to), "a corner", gesture);
      },
      released: () => store.rest(),
    });
    this.boxes = ["Length", "Width", "Turn"].map((name, k) =>
      numberBox({ step: "any", "aria-label": `${name} of the rectangle`, "data-testid": `plan-${name.toLowerCase()}` }, (value) => this.type(k, value)),
    );
    const units = ["", "", "\u00b0"].map((text) => h("span", { class: "unit" }, text));
    this.sizes = h(
      "div",
      { class: "plan-sizes" },
      ...["Length", "Width", "Turn"].map((name, k) => h("label", {}, h("span", {}, name), this.boxes[k]!, units[k]!)),
    );
    this.unit.append(...store.info.units.map((unit) => h("option", { value: unit }, unit)));
    this.unit.addEventListener("change", () => this.set({ ...this.table, unit: this.unit.value }, "unit of the mesh"));
    this.element = h(
      "section",
      { class: "surface-editor", "aria-label": "Surface", "data-testid": "surface-editor" },
      h("div", { class: "surface-head" }, this.kind.element),
      h(
        "div",
        { class: "surface-tools" },
        this.readyMade(),
        button({
          label: "Mesh file: the surface of an OBJ, STL, PLY or glTF",
          icon: "drop",
          text: "Mesh file",
          testid: "file-surface",
          act: () => void pickFile(MESHES).then((file) => file && this.read(file)),
        }),
      ),
      this.fields.element,
      this.mesh,
      this.plan.element,
      this.sizes,
      this.note.element,
      this.curves,
    );
    this.plan.element.append(h("div", { class: "drop-hint" }, "Drop an OBJ, STL, PLY or glTF file"));
    listenForFiles(this.element);
    store.design.bind(() => this.refresh());
    store.surface.watch(() => this.refresh());
    store.surfaceAt.watch(() => this.refresh());
    store.fault.bind(() => this.showFault());
    for (const signal of [store.report, store.freshness]) {
      (signal as { bind(listener: () => void): void }).bind(() => {
        this.curves.hidden = store.freshness.value !== "current" || !Object.keys(store.report.value?.by_curves ?? {}).length;
      });
    }
  }

  private get table(): SurfaceTable {
    return this.store.design.value.target?.surface ?? {};
  }

  private set(table: SurfaceTable, what: string, gesture = ""): void {
    this.store.set({ "target.surface": table }, what, gesture);
  }

  /** Show all of another surface, and of its shell, when they are drawn. */
  refit(): void {
    this.plan.refit();
    this.another();
  }

  private refresh(): void {
    const { target, shell } = this.store.design.value;
    const table = target?.surface;
    if (!table) {
      this.shown = null;
      return;
    }
    const kind = kindOf(table);
    const drawn = this.store.surface.value;
    if (this.shown !== table) {
      if (!isAboutSurface(this.store.fault.value)) this.note.say("");
      if (!this.shown || kindOf(this.shown) !== kind) this.plan.refit();
      this.shown = table;
      this.left.set(kind, table);
      this.kind.set(kind);
      this.fields.show(table);
    }
    const patch = patchOf(table, drawn);
    this.plan.show(drawn, patch, cornersOf(table, drawn), this.store.surfaceAt.value !== table);
    this.mesh.hidden = kind !== "mesh";
    this.unit.value = table.unit ?? shell.unit;
    this.auto.disabled = !table.corners;
    this.sizes.hidden = !patch;
    if (!patch) return;
    [...patch.size, patch.turn_deg].forEach((value, k) => setNumber(this.boxes[k]!, short(value, 6)));
    [...this.sizes.querySelectorAll(".unit")].slice(0, 2).forEach((each) => (each.textContent = shell.unit));
  }

  private type(which: number, value: number): void {
    const patch = patchOf(this.table, this.store.surface.value);
    if (!patch || (which < 2 && value <= 0)) return;
    const size = patch.size.map((each, axis) => (axis === which ? value : each)) as Point;
    const typed: Patch = { ...patch, size, turn_deg: which === 2 ? value : patch.turn_deg };
    this.set(withPatch(this.table, typed), "rectangle", `type-plan-${which}`);
  }

  private readyMade(): HTMLElement {
    const select = h(
      "select",
      { "aria-label": "Surfaces to begin with", "data-testid": "ready-made" },
      h("option", { value: "" }, "Begin with\u2026"),
      ...READY_MADE.map(({ name }, k) => h("option", { value: k }, name)),
    );
    select.addEventListener("change", () => {
      const found = READY_MADE[Number(select.value)];
      select.value = "";
      if (!found) return;
      this.refit();
      this.set(found.table(this.store.design.value.shell.unit), found.name.toLowerCase());
    });
    return select;
  }

  private switchTo(kind: Kind): void {
    const now = kindOf(this.table);
    if (kind === now) return;
    this.refit();
    const { unit } = this.store.design.value.shell;
    const other = this.left.get(kind) ?? READY_MADE.map((each) => each.table(unit)).find((table) => kindOf(table) === kind);
    if (other) return this.set(other, "surface");
    // There is no mesh yet.
    this.kind.set(now);
    this.note.say("Drop an OBJ, STL, PLY or glTF file here, or choose one.");
    void pickFile(MESHES).then((file) => file && this.read(file));
  }

  /** Take the mesh of a file. */
  async read(file: File): Promise<void> {
    const { files } = this.store;
    files.set(files.value + 1);
    this.note.say(`Reading ${file.name}\u2026`);
    try {
      requireSmall(file, this.store.info.limits.bytes, "meshes", ": make it coarser, or write it in a binary format");
      const { table, note } = await readSurface(file, this.store.design.value.shell.unit);
      this.refit();
      const { store } = this;
      store.change(changed(designFor(store, "surface"), { target: { surface: table } }), `surface from ${file.name}`);
      this.note.say(sentence(note));
    } catch (error) {
      this.note.say(sentence(faultOf(error).message), true);
    } finally {
      files.set(files.value - 1);
    }
  }

  private showFault(): void {
    const fault = this.store.fault.value;
    const mine = isAboutSurface(fault);
    this.element.classList.toggle("faulty", mine);
    this.note.showFault(mine ? this.store.labels.said(fault!.what) : null);
  }
}
