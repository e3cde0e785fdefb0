// The window of files by what one writes them for: each task has its formats, the settings that matter to it,
// a preview and one button. The last lists every format.

import { sentence } from "../../shared/words.ts";
import { button, segmented } from "../parts/controls.ts";
import { download, h, setAttribute } from "../parts/dom.ts";
import { exportDesign } from "../server/api.ts";
import { faultOf } from "../state/faults.ts";
import { settled } from "../state/sizing.ts";
import type { Store } from "../state/store.ts";
import type { ExportTask, FileFormat } from "../state/types.ts";
import { FormatChoice } from "./format-choice.ts";
import { SheetPreview, type Subject } from "./sheet-preview.ts";
import { WorkshopSettings } from "./workshop-settings.ts";

type State = "target" | "pack" | "flat" | "shown";
/** The task that lists its formats as buttons. */
const ALL = "all";
/** Of the picture of the shell, in pixels. */
const [WIDTH, HEIGHT] = [560, 400];

export class ExportMenu {
  readonly element: HTMLElement;
  private readonly menu: HTMLElement;
  private readonly sheets: SheetPreview;
  private readonly settings: WorkshopSettings;
  private readonly opener: HTMLButtonElement;
  private readonly note = h("p", { class: "note", role: "status", "data-testid": "export-note" });
  private readonly what = h("p", { class: "export-what" });
  private readonly shell = h("div", { class: "export-shell", "data-testid": "export-shell", role: "img", "aria-label": "The shell as it is on the screen" });
  private readonly stateRow: HTMLElement;
  private readonly list: HTMLElement;
  private readonly choices: Map<string, FormatChoice>;
  private readonly go = button({ label: "Write", text: "Write", class: "button primary", testid: "export-write", act: () => this.writeChosen() });
  private readonly tabs;
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
  private task: ExportTask;

  constructor(
    private readonly store: Store,
    private readonly frameOf: (frames: number) => number,
    private readonly picture: (width: number, height: number) => HTMLCanvasElement,
  ) {
    const { tasks, formats } = store.info;
    this.task = tasks[0]!;
    this.sheets = new SheetPreview(store);
    this.settings = new WorkshopSettings(store);
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
    this.tabs = segmented(
      "What for",
      tasks.map(({ name, label }) => ({ value: name, text: label, testid: `task-${name}` })),
      (name) => this.turnTo(tasks.find((each) => each.name === name)!),
    );
    this.choices = new Map(
      tasks
        .filter(({ name }) => name !== ALL)
        .map((task) => [task.name, new FormatChoice(task, [...task.archives, ...formats.filter(({ name }) => task.formats.includes(name))], () => this.explain())]),
    );
    this.list = h("div", { class: "formats" }, ...formats.map((format) => this.entry(format)));
    this.stateRow = h("div", { class: "menu-head" }, h("span", { class: "quiet" }, "State"), this.states.element);
    this.menu = h(
      "div",
      { class: "menu export-window", popover: "auto", role: "dialog", "aria-label": "Export" },
      h("div", { class: "export-head" }, h("h2", {}, "Export"), this.tabs.element, button({ label: "Close", icon: "close", testid: "export-close", act: () => this.menu.hidePopover() })),
      h(
        "section",
        { class: "export-files" },
        this.what,
        ...[...this.choices.values()].map(({ element }) => element),
        this.list,
        this.stateRow,
        this.settings.element,
        this.go,
        this.note,
      ),
      h("section", { class: "export-preview" }, this.sheets.element, this.shell),
    );
    this.menu.addEventListener("toggle", (event) => {
      const open = (event as ToggleEvent).newState === "open";
      setAttribute(this.opener, "aria-expanded", String(open));
      if (open) this.opened();
      else this.sheets.shown(false);
    });
    this.states.set("target");
    this.element = h("div", { class: "menu-frame" }, this.opener, this.menu);
    store.design.watch(() => this.open && this.explain());
    // Settings that do not fit are mended here: the window opens all the same, only nothing is written.
    store.freshness.bind((now, before) => {
      const outdated = now === "outdated";
      for (const each of this.list.querySelectorAll("button")) each.disabled = outdated;
      this.go.disabled = outdated;
      if (outdated || before === "outdated") this.explain();
    });
  }

  private get open(): boolean {
    return this.menu.matches(":popover-open");
  }

  private opened(): void {
    this.tabs.set(this.task.name);
    this.turnTo(this.task);
    this.menu.querySelector<HTMLElement>(".export-head input:checked")?.focus();
  }

  private turnTo(task: ExportTask): void {
    this.task = task;
    this.what.textContent = task.what;
    for (const [name, { element }] of this.choices) element.hidden = name !== task.name;
    this.list.hidden = task.name !== ALL;
    this.go.hidden = task.name === ALL;
    this.stateRow.hidden = !task.state;
    const drawn = task.preview !== "shell";
    this.sheets.element.hidden = !drawn;
    this.shell.hidden = drawn;
    if (!drawn) this.shell.replaceChildren(this.picture(WIDTH, HEIGHT));
    this.explain();
    this.sheets.shown(drawn);
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

  /** Say what would be written now. */
  private explain(): void {
    const choice = this.choices.get(this.task.name);
    choice?.offer(this.store.design.value);
    const format = choice?.chosen;
    if (format) this.go.textContent = `Write ${format.name.toUpperCase()}`;
    this.settings.only(this.task.archives.find((each) => each === format)?.settings ?? this.task.settings);
    const { preview } = this.task;
    if (preview !== "shell") this.sheets.of(preview === "booklet" && format ? (format.name as Subject) : preview);
    const words: Record<State, string> = {
      target: "Formats with one state show the shell at its target.",
      pack: "Formats with one state show the pack.",
      flat: "Formats with one state show the flat sheet.",
      shown: `Formats with one state show frame ${this.frame()}, the nearest to the screen.`,
    };
    const outdated = this.store.freshness.value === "outdated";
    const said = this.task.state ? words[this.state] : "";
    this.note.textContent = outdated ? "Nothing is written before the shell works again." : said;
    this.note.classList.remove("error");
  }

  private writeChosen(): void {
    const format = this.choices.get(this.task.name)?.chosen;
    if (format) void this.write(format);
  }

  private async write(format: FileFormat): Promise<void> {
    const { store } = this;
    const chosen = this.task.state ? this.state : "target";
    const state = chosen === "shown" ? this.frame() : chosen;
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
