// The middle: the shell in space, its colours and overlays, the fold.

import { LoadedControls } from "../../shared/loaded-controls.ts";
import { type Colouring, Shell3D } from "../../shared/shell3d.ts";
import { button, segmented } from "../parts/controls.ts";
import { contactOf } from "../../shared/stops.ts";
import { h } from "../parts/dom.ts";
import { FoldBar } from "./fold-bar.ts";
import type { Load } from "../../shared/api-types.ts";
import { aimOf, isSlow } from "../state/aims.ts";
import { worstCase } from "../structure/worst.ts";
import { isFound, type Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";

const COLOURS: { value: Colouring; text: string; title: string }[] = [
  { value: "plain", text: "Paper", title: "the two sides of the sheet" },
  { value: "signs", text: "Mountain, valley", title: "creases by their sign" },
  { value: "angle", text: "Fold angle", title: "creases and panels by fold angle" },
  { value: "distance", text: "Distance", title: "from the target surface, at the target" },
];
const OVERLAYS = [
  { name: "surface", text: "Target" },
  { name: "f", text: "f" },
  { name: "g", text: "g" },
] as const;

export class Stage {
  readonly element: HTMLElement;
  readonly fold: FoldBar;
  readonly shell: Shell3D;
  /** The switches of what is shown, and the frame that tools and cards lie over. */
  readonly overlays: HTMLElement;
  readonly frame: HTMLElement;
  /** Tools over the scene: others join the first. */
  readonly tools: HTMLElement;
  private readonly scene = h("div", { class: "scene", "data-testid": "scene" });
  /** The load case that is shown. */
  readonly loads: LoadedControls;
  private readonly state = h("div", { class: "scene-state", "data-testid": "freshness" });
  private readonly boxes: Partial<Record<"surface" | "f" | "g", HTMLInputElement>> = {};
  /** A load that was typed, whose worst case is to be shown. */
  private typed: Load["kind"] | null = null;
  private keepCamera = false;
  private keepFold = false;

  constructor(
    private readonly store: Store,
    banner: HTMLElement,
  ) {
    this.fold = new FoldBar(store);
    const colours = segmented<Colouring>(
      "Colours of the panels",
      COLOURS.map((each) => ({ ...each, testid: `colour-${each.value}` })),
      (mode) => this.shell.setColouring(mode),
    );
    colours.set("plain");
    this.overlays = h(
      "div",
      { class: "overlays", role: "group", "aria-label": "Shown beside the shell" },
      ...OVERLAYS.map(({ name, text }) => this.overlay(name, text)),
      this.thickness(),
    );
    this.shell = new Shell3D(this.scene, { label: "Shell in space" });
    this.loads = new LoadedControls(this.shell, (on) => this.fold.hold(on));
    this.tools = h(
      "div",
      { class: "scene-tools", role: "group", "aria-label": "Fit, measure and compare" },
      button({ label: "Fit the shell into view", icon: "fit", testid: "fit", act: () => this.shell.fit() }),
    );
    this.frame = h("div", { class: "scene-frame" }, this.scene, h("div", { class: "computing", "aria-hidden": "true" }), this.state, this.tools);
    this.element = h(
      "section",
      { class: "stage", "aria-label": "Shell in space" },
      h(
        "div",
        { class: "stage-tools" },
        colours.element,
        this.overlays,
        this.loads.element,
      ),
      this.frame,
      banner,
      this.fold.element,
    );
    this.fold.share.bind((share) => this.shell.setFold(share));
    this.fold.put.watch((share) => this.shell.setPut(share));
    store.freshness.bind(() => this.showState());
    store.view.bind(() => this.showState());
    store.busy.bind(() => this.showState());
    store.fault.bind(() => this.showState());
    store.proof.watch(() => this.showProof());
    store.design.bind((now, before) => this.aim(now, before));
    store.surface.watch((drawn) => drawn && this.shell.setSurface(drawn.glass));
  }

  /** Draw the store's view; the camera stays unless another design has been opened. */
  draw(): void {
    const view = this.store.view.value;
    if (!view) return;
    if (!this.keepFold) this.fold.toTarget();
    this.shell.show(view, this.keepCamera);
    this.shell.setFold(this.fold.share.value);
    this.loads.show(view);
    this.keepCamera = this.keepFold = true;
  }

  /** Show the worst case that has a load, as soon as it is known. */
  showLoad(kind: Load["kind"]): void {
    this.typed = kind;
    this.fold.toTarget();
  }

  /** The next shell is of another design: look anew, at its target. */
  beginAnew(): void {
    this.keepCamera = this.keepFold = false;
  }

  /** Look anew at the next shell. */
  forgetCamera(): void {
    this.keepCamera = false;
  }

  private overlay(name: "surface" | "f" | "g", text: string): HTMLElement {
    const input = h("input", {
      type: "checkbox",
      "data-testid": `overlay-${name}`,
      onchange: () => this.shell.setOverlay(name, input.checked),
    });
    this.boxes[name] = input;
    return h("label", { class: `check overlay-${name}` }, input, text);
  }

  /** A surface is seen with the shell in it, and has no curves. */
  private aim(now: Design, before: Design): void {
    const aim = aimOf(now);
    if (aim === aimOf(before) && now !== before) return;
    for (const name of ["f", "g"] as const) this.boxes[name]!.parentElement!.hidden = aim !== "curves";
    const { surface } = this.boxes;
    surface!.parentElement!.hidden = aim === "none";
    if ((aim === "surface") !== surface!.checked) surface!.click();
  }

  /** Only where panels have one. */
  private thickness(): HTMLElement {
    const input = h("input", {
      type: "checkbox",
      checked: true,
      "data-testid": "thickness",
      onchange: () => this.shell.setThickness(input.checked),
    });
    const label = h("label", { class: "check", title: "panels as the boards they are built of" }, input, "Thickness");
    this.store.view.bind((view) => (label.hidden = !view?.boards));
    return label;
  }

  /** The load that was typed, once it is analysed: remedies may still be looked for. */
  private showTyped(): void {
    const view = this.store.view.value;
    const worst = view && this.typed && isFound(this.store.proof.value) ? worstCase(view, this.typed) : null;
    if (!worst) return;
    this.typed = null;
    this.loads.want(worst.name);
  }

  private showProof(): void {
    const view = this.store.view.value;
    const proof = this.store.proof.value;
    this.showTyped();
    if (proof.state === "running" || !isFound(proof) || !view) return;
    this.shell.setDistance(view.distance ?? null);
    const contact = contactOf(view);
    this.shell.setContact(contact?.panels ?? null, contact?.drive_deg);
  }

  private showState(): void {
    const { freshness, view, busy, fault } = this.store;
    this.element.dataset["freshness"] = freshness.value;
    this.element.dataset["empty"] = String(!view.value);
    const outdated = freshness.value === "outdated" && view.value;
    const { design } = this.store;
    // A fit that was stopped says so itself.
    const stopped = isSlow(design.value) && !design.value.tolerance && !fault.value;
    const why = design.value.tolerance && !fault.value ? "choose rows and columns" : "the last shell that worked";
    this.state.textContent = busy.value ? `${busy.value}…` : outdated && !stopped ? `Out of date: ${why}` : "";
    this.state.hidden = !this.state.textContent;
  }
}
