// Puts the studio together.

import { blankCover, blankDesign } from "./curves/blank.ts";
import { Banner } from "./page/banner.ts";
import { BuiltSizes } from "./design/built-sizes.ts";
import { CurveEditor } from "./curves/curve-editor.ts";
import { h } from "./parts/dom.ts";
import { StructureControls } from "./structure/structure.ts";
import { EndWallControls } from "./design/end-walls.ts";
import { DeploymentControls } from "./design/deployment.ts";
import { Drop } from "./files/drop.ts";
import { ExampleCards } from "./files/example-cards.ts";
import { examplesOf } from "./files/example-list.ts";
import { ExportMenu } from "./files/export-menu.ts";
import { Families } from "./design/families.ts";
import { familyTrials } from "./design/family-trials.ts";
import { Files } from "./files/files.ts";
import { Help } from "./page/help.ts";
import { addInspection } from "./shell/inspection.ts";
import { Live } from "./server/live.ts";
import { PanelControls } from "./design/panel.ts";
import { StiffenerControls } from "./design/stiffeners.ts";
import { Parameters } from "./design/parameters.ts";
import { publishProbe } from "./probe.ts";
import { Results } from "./shell/results.ts";
import { saidElement } from "./page/said.ts";
import { listenForShortcuts } from "./page/shortcuts.ts";
import { SearchCard } from "./search/search.ts";
import { skipLinks } from "./page/skip.ts";
import { Stage } from "./shell/stage.ts";
import { forgetWhatIsStale } from "./state/stale.ts";
import type { Store } from "./state/store.ts";
import { announceTheme } from "./parts/theme.ts";
import { aimOf } from "./state/aims.ts";
import { DrawingForm, PATTERNS } from "./surface/drawing-form.ts";
import { fitBar } from "./surface/fit-bar.ts";
import { refusedCover } from "./surface/refused-drawing.ts";
import { Sketch } from "./curves/sketch.ts";
import { SurfaceEditor } from "./surface/surface-editor.ts";
import { keepSurfaceDrawn } from "./surface/keep-drawn.ts";
import { targetSection } from "./surface/target-section.ts";
import { Toolbar } from "./page/toolbar.ts";
import { tourHint } from "./page/tour-hint.ts";

export function buildStudio(root: HTMLElement, store: Store): void {
  store.home.watch(() => {
    stage.beginAnew();
    results.forgetView();
    editors.forEach((editor) => editor.refit());
    surface.refit();
  });
  const files = new Files(store, { endings: PATTERNS, read: (file) => void drawing.read(file) });
  const examples = new ExampleCards(examplesOf(store.info), ({ text, name }) => void files.take(text, name));
  const banner = new Banner(store, {
    goTo: (key) => parameters.focus(key),
    example: (family) => {
      // Examples of a family say so in their text.
      const found = store.info.examples.find(({ text }) => text.includes(`"${family}"`));
      if (found) void files.take(found.text, found.name);
    },
  });
  const stage = new Stage(store, banner.element);
  const results: Results = new Results(store, () => live.proveAgain());
  const live: Live = new Live(store, async () => {
    // The shell first; pattern and figures follow when its frame has been handed over.
    stage.draw();
    await painted();
    results.draw();
  });
  const [f, g] = (["f", "g"] as const).map((name) => new CurveEditor(store, name, () => sketch.begin([name]))) as [CurveEditor, CurveEditor];
  const editors = [f, g];
  const sketch = new Sketch(store, { f, g });
  store.design.watch((now, before) => {
    if (aimOf(now) === aimOf(before)) return;
    stage.forgetCamera();
    editors.forEach((editor) => editor.refit());
  });
  const surface = new SurfaceEditor(store, () => stage.forgetCamera());
  keepSurfaceDrawn(store);
  const drawing = new DrawingForm(store, (work) => store.open(work));
  const parameters = new Parameters(store, live);
  const help = new Help(store.info.version);
  const exportMenu = new ExportMenu(store, (frames) => stage.fold.frameOf(frames), (width, height) => stage.shell.picture(width, height));
  const toolbar = new Toolbar(store, exportMenu.element, {
    blank: () => {
      const before = store.named;
      store.open(blankDesign(store));
      sketch.begin(["f", "g"], before);
    },
    open: () => void files.open(),
    save: () => void files.save(),
    link: () => void files.link(),
    share: () => void files.share(),
    help: () => help.tour(),
    examples: () => examples.open(),
  });
  const drop = new Drop({
    design: (file) => void files.read(file),
    curve: (name, file) => void (name === "f" ? f : g).read(file),
    surface: (file) => void surface.read(file),
    pattern: (file) => void drawing.read(file),
    looksLikePattern: (file) => drawing.looksRight(file),
    refused: (words) => store.said.set(words),
  });
  forgetWhatIsStale(store);
  stage.frame.append(blankCover(store, (names) => sketch.begin(names)), fitBar(store, live), refusedCover(store));
  stage.element.append(sketch.element, saidElement(store));
  linkHover(stage, results);
  addInspection(store, stage, results);
  listenForShortcuts({
    undo: () => store.undo(),
    redo: () => store.redo(),
    open: () => void files.open(),
    save: () => void files.save(),
    help: () => help.list(),
    play: () => stage.fold.toggle(),
    fit: () => stage.shell.fit(),
  });
  root.replaceChildren(
    skipLinks(),
    toolbar.element,
    h(
      "main",
      { class: "rooms" },
      h(
        "div",
        { class: "inputs", role: "region", "aria-label": "Design" },
        tourHint(store, () => help.tour()),
        h("section", { "aria-labelledby": "family-title" }, h("h2", { id: "family-title" }, "Family"), new Families(store).element, familyTrials(store)),
        targetSection(store, editors, surface, drawing, new BuiltSizes(store).element),
        parameters.element,
        new PanelControls(store).element,
        new DeploymentControls(store).element,
        new StiffenerControls(store).element,
        new EndWallControls(store).element,
        new StructureControls(store, { stop: () => live.stopProof(), again: () => live.proveAgain(), loaded: (load) => stage.showLoad(load) }).element,
        new SearchCard(store).element,
      ),
      stage.element,
      results.element,
    ),
    help.element,
    examples.element,
    drop.element,
  );
  // Only now are the drawings in the page, whose colours they take.
  announceTheme();
  publishProbe(store, live, stage);
  live.changed();
  window.addEventListener("hashchange", () => void files.follow());
  void files.follow();
}

function linkHover(stage: Stage, results: Results): void {
  const highlight = (panel: number | null): void => {
    stage.shell.highlight(panel);
    results.pattern.highlight(panel);
  };
  stage.shell.onHover = highlight;
  results.pattern.onHover = highlight;
}

/** Resolves when the next frame has been handed to the screen. */
function painted(): Promise<void> {
  return new Promise((resolve) => {
    let done = false;
    const once = (): void => {
      if (!done) {
        done = true;
        resolve();
      }
    };
    requestAnimationFrame(() => {
      const channel = new MessageChannel();
      channel.port1.onmessage = once;
      channel.port2.postMessage(null);
    });
    // A page in the background draws nothing; it must not stand still for that.
    setTimeout(once, 500);
  });
}
