// The top: name, undo, redo, examples, files, unit, theme, help, export; on a phone most of it in a menu.

import { button } from "../parts/controls.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { icon } from "../parts/icons.ts";
import { nameField } from "./name-field.ts";
import type { Store } from "../state/store.ts";
import { theme, toggleTheme } from "../parts/theme.ts";

export interface ToolbarEvents {
  blank(): void;
  open(): void;
  save(): void;
  link(): void;
  share(): void;
  help(): void;
  examples(): void;
}

const MENU = "toolbar-menu";
/** A button whose word only the menu of a phone shows. */
const QUIET = "button icon-only";

export class Toolbar {
  readonly element: HTMLElement;
  private readonly more = button({ label: "More", icon: "more", class: "button icon-only more", testid: "toolbar-more", act: () => {} });

  constructor(
    private readonly store: Store,
    exportMenu: HTMLElement,
    events: ToolbarEvents,
  ) {
    store.name.bind((text) => (document.title = `${text} – orishell studio`));
    const undo = button({ label: "Undo", icon: "undo", keys: "Ctrl+Z", testid: "undo", act: () => store.undo() });
    const redo = button({ label: "Redo", icon: "redo", keys: "Ctrl+Shift+Z", testid: "redo", act: () => store.redo() });
    store.steps.bind(() => {
      this.describe(undo, "Undo", store.undoable);
      this.describe(redo, "Redo", store.redoable);
    });
    this.element = h(
      "header",
      { class: "toolbar" },
      h("h1", { class: "brand" }, h("span", { class: "brand-mark", "aria-hidden": "true" }), "orishell", h("span", { class: "brand-room" }, "studio")),
      nameField(store),
      h("div", { class: "group" }, undo, redo),
      this.menu(
        button({ label: "Examples", icon: "examples", text: "Examples", testid: "examples", act: events.examples }),
        button({ label: "New design, to be drawn", icon: "blank", text: "New", testid: "new", act: events.blank }),
        button({ label: "Open a design file, or a crease pattern", icon: "open", text: "Open", keys: "Ctrl+O", testid: "open", act: events.open }),
        button({ label: "Save the design file", icon: "save", text: "Save", keys: "Ctrl+S", testid: "save", act: events.save }),
        button({ label: "Copy link, which holds the whole design; it opens where this studio runs", icon: "link", text: "Copy link", class: QUIET, testid: "link", act: events.link }),
        this.units(),
        h("span", { class: "spacer" }),
        this.themeButton(),
        button({ label: "Help: a short tour, keys and gestures", icon: "help", text: "Help", class: QUIET, keys: "?", testid: "help", act: events.help }),
      ),
      button({ label: "Share: the shell to turn and fold in one file, for any browser", icon: "share", text: "Share", testid: "share", act: events.share }),
      exportMenu,
      this.more,
    );
  }

  /** In the bar where that has room, else behind a button. */
  private menu(...content: HTMLElement[]): HTMLElement {
    const menu = h("div", { id: MENU, class: "menu toolbar-menu", popover: "auto", role: "group", "aria-label": "Design, unit and help" }, ...content);
    setAttribute(this.more, "popovertarget", MENU);
    menu.addEventListener("click", (event) => {
      if (event.composedPath().some((each) => each instanceof HTMLButtonElement) && menu.matches(":popover-open")) menu.hidePopover();
    });
    return menu;
  }

  private describe(control: HTMLButtonElement, word: string, what: string | null): void {
    // Not disabled: it would lose the focus in the middle of a run of undos.
    setAttribute(control, "aria-disabled", what === null ? "true" : "false");
    control.title = what === null ? `Nothing to ${word.toLowerCase()}` : `${word}: ${this.store.labels.said(what)}`;
  }

  private units(): HTMLElement {
    const { store } = this;
    const select = h(
      "select",
      {
        "data-testid": "unit",
        "aria-label": "Unit of length",
        title: "Unit of length; numbers keep their values",
        onchange: () => store.set({ "shell.unit": select.value }, "unit"),
      },
      ...store.info.units.map((unit) => h("option", { value: unit }, unit)),
    );
    store.design.bind((design) => (select.value = design.shell.unit));
    return h("label", { class: "unit-choice" }, h("span", { class: "quiet" }, "Unit"), select);
  }

  private themeButton(): HTMLElement {
    const control = button({ label: "Dark colours", icon: "moon", text: "", class: QUIET, testid: "theme", act: toggleTheme });
    theme.bind((value) => {
      const label = value === "dark" ? "Light colours" : "Dark colours";
      control.replaceChildren(icon(value === "dark" ? "sun" : "moon"), h("span", { class: "word" }, label));
      control.title = label;
      setAttribute(control, "aria-label", label);
    });
    return control;
  }
}
