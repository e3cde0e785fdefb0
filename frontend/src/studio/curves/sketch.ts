// The canvas as the plane of the curves: they are drawn there one after the other, each at its size.

import { type CurveEditor } from "./curve-editor.ts";
import { NO_CURVE, isCurve } from "./curve-table.ts";
import { TITLES, VIEWS } from "./curve-words.ts";
import { button } from "../parts/controls.ts";
import { h, setAttribute } from "../parts/dom.ts";
import type { Home, Work } from "../state/named.ts";
import type { Store } from "../state/store.ts";
import type { CurveName } from "../state/types.ts";

interface Task {
  names: CurveName[];
  at: number;
  /** The design that Cancel brings back. */
  before: Work;
  /** Another design, or none of curves, ends it. */
  home: Home;
}

export class Sketch {
  readonly element: HTMLElement;
  private readonly words = h("p", { class: "sketch-step", role: "status", "data-testid": "sketch-step" });
  private readonly place = h("div", { class: "sketch-place" });
  private readonly finish = button({ label: "Finish", text: "Finish", class: "button primary", testid: "sketch-finish", act: () => this.proceed() });
  private task: Task | null = null;

  constructor(
    private readonly store: Store,
    private readonly editors: Record<CurveName, CurveEditor>,
  ) {
    this.element = h(
      "section",
      { class: "sketch", "aria-label": "Sketch", "data-testid": "sketch", hidden: true },
      h(
        "header",
        { class: "sketch-head" },
        this.words,
        button({ label: "Undo", icon: "undo", keys: "Ctrl+Z", testid: "sketch-undo", act: () => store.undo() }),
        button({ label: "Cancel: bring back what was there before", text: "Cancel", keys: "Escape", testid: "sketch-cancel", act: () => this.cancel() }),
        this.finish,
      ),
      this.place,
    );
    this.element.addEventListener("keydown", (event) => this.pressed(event));
    store.design.watch(() => {
      if (this.task && (store.named.home !== this.task.home || !store.design.value.target?.f)) this.close();
      this.describe();
    });
  }

  /** Draw curves one after the other; `before` is what Cancel brings back. */
  begin(names: CurveName[], before = this.store.named): void {
    this.close();
    this.task = { names, at: 0, before, home: this.store.named.home };
    this.element.hidden = false;
    this.show();
  }

  private get editor(): CurveEditor {
    return this.editors[this.task!.names[this.task!.at]!];
  }

  private show(): void {
    this.editor.enlarge(this.place);
    this.describe();
    this.editor.begin();
  }

  private describe(): void {
    if (!this.task) return;
    const { names, at } = this.task;
    const name = names[at]!, next = names[at + 1];
    const words = `draw the ${TITLES[name]} ${name}, ${VIEWS[name]}`;
    this.words.textContent = names.length > 1 ? `${at + 1} of ${names.length}: ${words}` : `D${words.slice(1)}`;
    const label = next ? `Next: ${TITLES[next]} ${next}` : "Finish";
    this.finish.textContent = label;
    this.finish.title = this.whole ? label : "Two points at least make a curve";
    setAttribute(this.finish, "aria-label", label);
    setAttribute(this.finish, "aria-disabled", String(!this.whole));
  }

  /** Whether there is a curve to go on with. */
  private get whole(): boolean {
    const { names, at } = this.task!;
    return isCurve(this.store.design.value.target?.[names[at]!] ?? NO_CURVE);
  }

  private proceed(): void {
    const { task } = this;
    if (!task || !this.whole) return;
    if (task.at + 1 === task.names.length) {
      this.close();
      return document.querySelector<HTMLElement>(".scene canvas")?.focus();
    }
    this.editor.enlarge(null);
    task.at++;
    this.show();
  }

  private cancel(): void {
    const { task, store } = this;
    if (!task) return;
    this.close();
    if (store.named === task.before) return;
    store.backTo(task.before);
    store.said.set("Nothing was drawn; redo brings it back");
  }

  private close(): void {
    if (!this.task) return;
    this.editor.enlarge(null);
    this.task = null;
    this.element.hidden = true;
  }

  private pressed(event: KeyboardEvent): void {
    const target = event.target as Element;
    if (event.key === "Escape") this.cancel();
    else if (event.key === "Enter" && target.closest(".plot-frame") && !target.closest("button")) this.proceed();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
