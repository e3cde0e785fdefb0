// Does it carry its loads: material, supports and loads, and the verdict.

import type { KeyWords } from "../../shared/api-types.ts";
import { threeDigits } from "../../shared/quantities.ts";
import { judged, signOf } from "../../shared/verdict.ts";
import { capital } from "../../shared/words.ts";
import { button, type Segmented, segmented, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import { WorkBar } from "../parts/work-bar.ts";
import { isFound, type Store } from "../state/store.ts";
import { CarryCard } from "./carry.ts";
import { RailControls } from "./rail.ts";
import { box, choice, named, row } from "./rows.ts";
import { wordsOfWorst, worstCase } from "./worst.ts";
import { caseWith, casesOf, type Changes, kilonewtons, type Load, millimetres, LOADS, PERSON, rubs, structureOf, supportOf, underSnowAndWind, withCombinations, withLoad, withMaterial, withSupport } from "./table.ts";

const NONE = "", OWN = "own";
const FREE = "free", RIGID = "rigid", BOTH = "both";

export class StructureControls {
  readonly element: HTMLElement;
  private readonly material: HTMLSelectElement;
  private readonly facts = h("p", { class: "note", "data-testid": "structure-facts" });
  private readonly boxes: Record<"thickness" | "friction" | "ballast" | "snow" | "wind" | "direction" | "person", HTMLInputElement>;
  private readonly kind: Segmented<string>;
  private readonly at: Segmented<string>;
  private readonly grain: Segmented<string>;
  private readonly creases: HTMLSelectElement;
  private readonly combinations: Segmented<string>;
  private readonly weight: HTMLInputElement;
  private readonly roof: HTMLSelectElement;
  private readonly terrain: HTMLSelectElement;
  private readonly rows: Record<"thickness" | "friction" | "ballast" | "grain" | "roof" | "terrain" | "direction", HTMLElement>;
  /** The first step, from a shell without loads. */
  private readonly begin: HTMLButtonElement;
  private readonly rest: HTMLElement;
  private readonly listed = h("p", { class: "note" });
  /** How much of what it bears the shell uses under each load. */
  private readonly shares = Object.fromEntries(LOADS.map((load) => [load, h("output", { class: "measured share", "data-testid": `share-${load}` }) as HTMLElement])) as Record<Load, HTMLElement>;
  private readonly work: WorkBar;
  private readonly verdict = h("p", { class: "structure-verdict", role: "status", "data-testid": "structure-verdict" });
  private readonly asks = h("ul");
  /** What is left to whoever signs. */
  private readonly left = h("details", { "data-testid": "code-asks" }, h("summary", {}, "What codes ask, and is not done here"), this.asks);
  private readonly again: HTMLButtonElement;

  /** `loaded` is told which load was given another value. */
  constructor(private readonly store: Store, private readonly act: { stop(): void; again(): void; loaded(load: Load): void }) {
    const { info } = store;
    const words = (table: string): Record<string, KeyWords> => info.tables[table]!.keys;
    const structure = words("structure"), supports = words("structure.supports"), loads = words("load_case");
    const snow = words("load_case.snow"), wind = words("load_case.wind");
    const { material, thickness, grain, combinations, crease_stiffness: creases } = structure;

    this.material = choice("material", material!, [
      [NONE, "Not analysed"],
      [OWN, "Its own values"],
      ...info.materials.map(({ name }): [string, string] => [name, capital(name)]),
    ], (name) => this.change(withMaterial(store.design.value, name === NONE ? null : name, info.materials), "material"));
    this.material.options[1]!.disabled = true;
    this.boxes = {
      thickness: box("thickness", (mm) => this.change({ "structure.thickness": mm > 0 ? Number(short(mm / millimetres(store.design.value))) : undefined }, "thickness")),
      friction: box("friction", (value) => this.change(withSupport(store.design.value, "friction", value), "friction")),
      ballast: box("ballast", (mass) => this.change(withSupport(store.design.value, "ballast", mass), "ballast", "type-ballast"), "none"),
      snow: box("snow", (load) => this.load("snow", "ground", load > 0 ? Number(short(load * kilonewtons(store.design.value))) : undefined), "none"),
      wind: box("wind", (speed) => this.load("wind", "speed", speed > 0 ? speed : undefined), "none"),
      direction: box("direction", (angle) => this.load("wind", "direction_deg", angle), "", -360),
      person: box("person", (weight) => this.load("person", "force", weight > 0 ? Number(short(1000 * weight)) : undefined), "none"),
    };
    this.grain = this.segments("grain", { ...grain!, choices: { [NONE]: "Not known", ...grain!.choices } }, (way) => this.change({ "structure.grain": way || undefined }, "grain"));
    this.kind = this.segments("kind", supports["kind"]!, (kind) => this.change(withSupport(store.design.value, "kind", kind), "supports"));
    this.at = this.segments("at", supports["at"]!, (at) => this.change(withSupport(store.design.value, "at", at), "supports"));
    this.creases = choice("creases", creases!, [
      [FREE, "Free hinges"], [RIGID, "Rigid"], [BOTH, "Free to rigid"], [OWN, "As in the file"],
    ], (value) => this.change({ "structure.crease_stiffness": value === BOTH ? undefined : value }, "creases"));
    this.creases.options[3]!.disabled = true;
    this.combinations = this.segments("combinations", combinations!, (value) => this.change(withCombinations(store.design.value, value), "combinations"));
    this.weight = h("input", {
      type: "checkbox", id: "structure-weight", "data-testid": "structure-weight",
      onchange: () => this.load("self_weight", "", this.weight.checked || undefined),
    });
    this.roof = choice("roof", snow["shape"]!, Object.entries(snow["shape"]!.choices), (shape) => this.load("snow", "shape", shape));
    this.terrain = choice("terrain", wind["terrain"]!, Object.entries(wind["terrain"]!.choices), (each) => this.load("wind", "terrain", each));
    this.rows = {
      thickness: row("thickness", thickness!, this.boxes.thickness, "mm"),
      grain: named(grain!, this.grain),
      friction: row("friction", supports["friction"]!, this.boxes.friction, ""),
      ballast: row("ballast", supports["ballast"]!, this.boxes.ballast, "kg"),
      roof: row("roof", snow["shape"]!, this.roof),
      terrain: row("terrain", wind["terrain"]!, this.terrain),
      direction: row("direction", wind["direction_deg"]!, this.boxes.direction, "\u00b0"),
    };
    const text = "Does it carry snow and wind?";
    this.begin = button({ label: text, text, class: "button primary", testid: "structure-begin", act: () => this.beginLoads() });
    this.work = new WorkBar("Analysis", act.stop, "structure-work");
    this.again = button({ label: "Analyse", text: "Analyse", testid: "structure-again", act: act.again });
    this.rest = h(
      "div",
      { class: "parameter-list" },
      this.rows.thickness,
      this.facts,
      this.rows.grain,
      named(supports["kind"]!, this.kind),
      this.rows.ballast,
      this.rows.friction,
      named(supports["at"]!, this.at),
      new RailControls(store).element,
      row("creases", creases!, this.creases),
      row("weight", loads["self_weight"]!, this.weight),
      row("snow", loads["snow"]!, this.boxes.snow, "kN/m\u00b2"),
      this.rows.roof,
      row("wind", loads["wind"]!, this.boxes.wind, "m/s"),
      this.rows.terrain,
      this.rows.direction,
      row("person", loads["person"]!, this.boxes.person, "kN"),
      named(combinations!, this.combinations),
      this.listed,
      this.work.element,
      this.verdict,
      this.left,
      this.again,
      new CarryCard(store).element,
    );
    this.element = h(
      "section",
      { class: "structure", "aria-labelledby": "structure-title" },
      h("h2", { id: "structure-title" }, info.tables["structure"]!.label),
      this.begin,
      row("material", material!, this.material),
      this.rest,
    );
    for (const load of LOADS) (load === "self_weight" ? this.weight : this.boxes[load]).before(this.shares[load]);
    store.design.bind(() => this.show());
    store.proof.bind(() => this.say());
  }

  private change(changes: Changes, what: string, gesture = ""): void {
    this.store.set(changes, what, gesture);
  }

  /** With loads that are changed where they stand. */
  private beginLoads(): void {
    const { design, info } = this.store;
    this.change(underSnowAndWind(design.value, info.materials), "snow and wind");
    this.act.loaded("snow");
    this.boxes.snow.focus();
  }

  private load(load: Load, key: string, value: unknown): void {
    this.change(withLoad(this.store.design.value, load, key, value), load === "self_weight" ? "own weight" : load, key && `type-${load}-${key}`);
    if (value !== undefined) this.act.loaded(load);
  }

  private segments(key: string, { label, choices }: KeyWords, chosen: (value: string) => void): Segmented<string> {
    const values = Object.entries(choices).map(([value, text]) => ({ value, text, testid: `structure-${key}-${value.replace(" ", "-")}` }));
    return segmented<string>(label, values, chosen);
  }

  private show(): void {
    const design = this.store.design.value;
    const table = structureOf(design), support = supportOf(design), cases = casesOf(design);
    this.begin.hidden = Boolean(table);
    this.rest.hidden = !table;
    const { material, thickness, combinations = "none", crease_stiffness: creases } = table ?? {};
    this.material.value = !table ? NONE : String(material ?? OWN);
    const known = this.store.info.materials.find(({ name }) => name === material);
    this.facts.hidden = !known;
    if (known) {
      const { modulus, strength, density } = known;
      this.facts.textContent = `Modulus ${threeDigits(modulus / 1e9)} GPa, strength ${threeDigits(strength / 1e6)} MPa, ${density} kg/m\u00b3, for a first design.`;
      this.facts.title = known.conservative;
    }
    this.rows.thickness.hidden = Boolean(design.panel?.["thickness"]);
    setNumber(this.boxes.thickness, thickness === undefined ? "" : short(Number(thickness) * millimetres(design)));
    this.kind.set(String(support?.["kind"] ?? NONE));
    this.at.set(String(support?.["at"] ?? NONE));
    this.rows.grain.hidden = !known?.grain || table?.["strength"] !== undefined;
    this.grain.set(String(table?.["grain"] ?? NONE));
    const onGround = support?.["kind"] === "friction";
    this.rows.friction.hidden = !support || !rubs(support);
    this.boxes.friction.placeholder = onGround ? "" : "not asked";
    setNumber(this.boxes.friction, onGround || support?.["friction"] ? short(Number(support?.["friction"] ?? 0)) : "");
    this.rows.ballast.hidden = onGround;
    setNumber(this.boxes.ballast, support?.["ballast"] ? short(Number(support["ballast"])) : "");
    this.creases.value = stiffnessOf(creases);
    this.combinations.set(String(combinations));
    this.weight.checked = caseWith(design, "self_weight") >= 0;
    const loaded = (load: Load): Record<string, unknown> | undefined => cases[caseWith(design, load)]?.[load] as Record<string, unknown> | undefined;
    const snow = loaded("snow"), wind = loaded("wind"), person = loaded("person");
    setNumber(this.boxes.snow, snow ? short(Number(snow["ground"]) / kilonewtons(design)) : "");
    setNumber(this.boxes.wind, wind ? short(Number(wind["speed"])) : "");
    setNumber(this.boxes.direction, short(Number(wind?.["direction_deg"] ?? 0)));
    setNumber(this.boxes.person, person ? short(Number(person["force"] ?? PERSON) / 1000) : "");
    this.rows.roof.hidden = !snow;
    this.rows.terrain.hidden = this.rows.direction.hidden = !wind;
    this.roof.value = String(snow?.["shape"] ?? "both");
    this.terrain.value = String(wind?.["terrain"] ?? "II");
    // What these controls do not show.
    const shown = LOADS.map((load) => caseWith(design, load));
    const others = cases.filter((_, k) => !shown.includes(k)).map(({ name }) => String(name));
    const words = [
      table?.["sandwich"] ? "Boards are two faces on a core, with values from the file." : "",
      table && !support ? "Supports: several are listed in the file; a choice here takes their place." : "",
      person?.["at"] ? `Person: on panel ${String(person["at"]).replace(",", ", ")}, as in the file.` : "",
      others.length ? `Also in the file: ${others.join(", ")}.` : "",
    ].filter(Boolean);
    this.listed.textContent = words.join(" ");
    this.listed.hidden = !words.length;
  }

  /** Beside a load, the worst of the cases that have it. */
  private share(load: Load, found: boolean): void {
    const view = this.store.view.value, output = this.shares[load];
    const worst = found && view ? worstCase(view, load) : null;
    output.replaceChildren(...(worst ? [signOf(worst.sign), ` ${wordsOfWorst(worst)}`] : []));
    output.dataset["tone"] = worst?.sign ?? "";
    output.title = worst ? `${worst.governs ? `of ${worst.governs.replaceAll("_", " ")}, ` : ""}under ${worst.name}` : "";
  }

  /** How far the analysis is, and what it found. */
  private say(): void {
    const { proof, report, design } = this.store;
    const now = proof.value;
    const asked = design.value["structure"] !== undefined;
    const found = isFound(now) ? judged(report.value).find(({ subject, known }) => subject === "stands" && known) : null;
    if (now.state === "running") this.work.show(now.share, now.what);
    else if (now.state === "waiting") this.work.begin("waiting");
    else this.work.hide();
    for (const load of LOADS) this.share(load, found !== null && found !== undefined);
    const fault = asked && (now.state === "failed" || now.state === "late") ? now.fault : null;
    const failed = fault && { sign: now.state === "late" ? ("warns" as const) : ("fails" as const), subject: "not analysed", finding: fault.message };
    const shown = found ?? failed;
    this.verdict.hidden = !shown;
    this.verdict.replaceChildren(...(shown ? [signOf(shown.sign), " ", h("b", {}, capital(shown.subject)), ` ${this.store.labels.said(shown.finding)}`] : []));
    this.verdict.dataset["tone"] = shown?.sign ?? "";
    const asks = (found && report.value?.structure?.code_asks) || [];
    this.left.hidden = !asks.length;
    this.asks.replaceChildren(...asks.map((each) => h("li", {}, this.store.labels.said(each))));
    this.again.hidden = now.state !== "stopped" && now.state !== "late";
  }
}

function stiffnessOf(value: unknown): string {
  if (value === undefined) return BOTH;
  if (Array.isArray(value)) return value[0] === FREE && value[1] === RIGID ? BOTH : OWN;
  return value === FREE || value === RIGID ? value : OWN;
}
