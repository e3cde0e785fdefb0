// Every format, of the shell at its target, its pack, the flat sheet, or the state on the screen;
// beside them the workshop's settings and its sheets.

import { sentence } from "../../shared/words.ts";
import { exportDesign } from "../server/api.ts";
import { button, segmented } from "../parts/controls.ts";
import { download, h, setAttribute } from "../parts/dom.ts";
import { faultOf } from "../state/faults.ts";
import { SheetPreview } from "./sheet-preview.ts";
import { settled } from "../state/sizing.ts";
import type { Store } from "../state/store.ts";
import type { FileFormat } from "../state/types.ts";
import { WorkshopSettings } from "./workshop-settings.ts";

type State = "target" | "pack" | "flat" | "shown";

export class ExportMenu {
  readonly element: HTMLElement;
  private readonly menu: HTMLElement;
  private readonly sheets: SheetPreview;
  private readonly opener: HTMLButtonElement;
  private readonly note = h("p", { class: "note", role: "status" });
  private readonly states = segmented<State>(
    "State that is written",
    [
      { value: "target", text: "Target", testid: "state-target" },
      { value: "pack", text: "Pack", testid: "state-pack" },
      { value: "flat", text: "Flat", testid: "state-flat" },
      { value: "shown", text: "As shown", testid: "state-shown" },
    ],
    (state) => {
      this.state = state;
      this.explain();
    },
  );
  private state: State = "target";

  constructor(
    private readonly store: Store,
    private readonly frameOf: (frames: number) => number,
  ) {
    this.sheets = new SheetPreview(store);
    this.opener = button({
      label: "Export",
      icon: "export",
      text: "Export",
      testid: "export",
      act: () => {
        this.offerPack();
        this.menu.togglePopover();
      },
    });
    setAttribute(this.opener, "aria-expanded", "false");
    setAttribute(this.opener, "aria-haspopup", "dialog");
    this.menu = h(
      "div",
      { class: "menu export-window", popover: "auto", role: "dialog", "aria-label": "Export" },
      h("div", { class: "export-head" }, h("h2", {}, "Export"), button({ label: "Close", icon: "close", testid: "export-close", act: () => this.menu.hidePopover() })),
      h(
        "section",
        { class: "export-files" },
        h("div", { class: "menu-head" }, h("span", { class: "quiet" }, "State"), this.states.element),
        this.note,
        h("div", { class: "formats" }, ...store.info.formats.map((format) => this.entry(format))),
      ),
      h("section", {}, h("h3", {}, "Workshop: DXF, SVG, PDF, 3MF"), new WorkshopSettings(store).element),
      h("section", {}, h("h3", {}, "Sheets"), this.sheets.element),
    );
    this.menu.addEventListener("toggle", (event) => {
      const open = (event as ToggleEvent).newState === "open";
      setAttribute(this.opener, "aria-expanded", String(open));
      this.sheets.shown(open);
      if (open) this.opened();
    });
    this.states.set("target");
    this.element = h("div", { class: "menu-frame" }, this.opener, this.menu);
    // Settings that do not fit are mended here: the window opens all the same, only nothing is written.
    store.freshness.bind((now, before) => {
      const outdated = now === "outdated";
      for (const format of this.menu.querySelectorAll<HTMLButtonElement>(".format")) format.disabled = outdated;
      if (outdated || before === "outdated") this.explain();
    });
  }

  private opened(): void {
    this.explain();
    this.menu.querySelector<HTMLElement>(".format")?.focus();
  }

  private offerPack(): void {
    const packed = this.store.design.value.deployment?.["from"] === "pack";
    this.states.element.querySelector("[value=pack]")!.closest("label")!.hidden = !packed;
    if (packed || this.state !== "pack") return;
    this.state = "target";
    this.states.set("target");
  }

  private entry(format: FileFormat): HTMLElement {
    return h(
      "button",
      { type: "button", class: "format", "data-testid": `export-${format.name}`, onclick: () => void this.write(format) },
      h("span", { class: "format-name" }, format.name),
      h("span", { class: "format-what" }, format.what),
    );
  }

  /** Number of the frame nearest to the fold on the screen. */
  private frame(): number {
    const frames = Number(this.store.design.value.motion?.["frames"] ?? 25);
    return this.frameOf(frames);
  }

  private explain(): void {
    const words: Record<State, string> = {
      target: "Formats with one state show the shell at its target.",
      pack: "Formats with one state show the pack.",
      flat: "Formats with one state show the flat sheet.",
      shown: `Formats with one state show frame ${this.frame()}, the nearest to the screen.`,
    };
    const outdated = this.store.freshness.value === "outdated";
    this.note.textContent = outdated ? "Nothing is written before the shell works again." : words[this.state];
    this.note.classList.remove("error");
  }

  private async write(format: FileFormat): Promise<void> {
    const { store } = this;
    const state = this.state === "shown" ? this.frame() : this.state;
    this.menu.classList.add("busy");
    this.note.classList.remove("error");
    this.note.textContent = `Writing ${format.name}…`;
    try {
      // Sizes that were chosen are not sought again.
      const current = store.freshness.value === "current";
      const design = current ? settled(store.info, store.design.value, store.report.value) : store.design.value;
      const file = await exportDesign(design, format.name, state, store.name.value);
      download(file.blob, file.name);
      this.note.textContent = `Written: ${file.name}`;
    } catch (error) {
      this.note.textContent = sentence(faultOf(error).message);
      this.note.classList.add("error");
    } finally {
      this.menu.classList.remove("busy");
    }
  }
}
