// How the shell stands: a person for its size, its feet and flaps, its headroom, its ties.

import { feetOf, groundOf } from "../../shared/ground.ts";
import { type Headroom, headroomOf } from "../../shared/headroom.ts";
import { Feet3D, flapSides, Ties3D } from "../../shared/moving3d.ts";
import { roomOfPerson } from "../../shared/person.ts";
import { Person3D } from "../../shared/person3d.ts";
import { tiesOf } from "../../shared/ties.ts";
import type { View } from "../../shared/view.ts";
import { h } from "../parts/dom.ts";
import { Signal } from "../state/signal.ts";
import type { Stage } from "./stage.ts";
import type { Store } from "../state/store.ts";

/** Rest after a change before headroom is measured, in milliseconds. */
const REST = 150;

/** Room below a shell; null where nothing is clear. */
export interface Measured {
  view: View;
  room: Headroom | null;
}

export class Standing {
  readonly headroom = new Signal<Measured | null>(null);
  /** What marks mean, below the shell. */
  readonly legend = h("div", { class: "standing-legend", "data-testid": "standing-legend" });
  private timer = 0;

  constructor(
    store: Store,
    stage: Stage,
  ) {
    const { shell } = stage;
    const person = new Person3D(shell.uniforms), ties = new Ties3D(shell.uniforms);
    const redraw = shell.add(person), redrawTies = shell.add(ties);
    shell.add(new Feet3D(shell.uniforms));
    const standing = h("input", { type: "checkbox", "data-testid": "person", onchange: () => store.figure.set(standing.checked) });
    const personSwitch = h("label", { class: "check", title: "a person of 1.75 m beside shell and profile, for the size" }, standing, "Person");
    const { untied } = stage.fold;
    const showTies = (): void => {
      ties.setVisible(tied.checked && !untied.value);
      redrawTies();
    };
    const tied = h("input", { type: "checkbox", checked: true, "data-testid": "ties", onchange: showTies });
    untied.watch(showTies);
    const tiesSwitch = h("label", { class: "check", title: "taut: a line; slack: dashes" }, tied, "Ties");
    stage.overlays.append(personSwitch, tiesSwitch);
    store.figure.bind((on) => {
      standing.checked = on;
      person.setVisible(on);
      redraw();
      shell.refit();
    });
    const place = (view: View, room: Headroom | null): void => {
      const elsewhere = person.place(room);
      personSwitch.hidden = !Person3D.suits(view);
      tiesSwitch.hidden = !tiesOf(view).length;
      redraw();
      if (elsewhere) shell.refit();
    };
    const follow = (): void => {
      const view = store.view.value;
      if (!view) return;
      this.explain(view);
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => {
        const room = headroomOf(view, groundOf(view).atTarget, Person3D.suits(view) ? roomOfPerson(view.header.unit) : 0);
        this.headroom.set({ view, room });
        place(view, room);
      }, REST);
    };
    for (const each of [personSwitch, tiesSwitch]) each.hidden = true;
    store.view.bind(follow);
    store.proof.watch((proof) => {
      if (proof.state === "done") follow();
    });
  }

  private explain(view: View): void {
    const marks: [string, boolean, string][] = [
      ["feet", feetOf(view, groundOf(view)).length > 0, "dot"],
      ["flaps", flapSides(view).length > 0, "line flap"],
      ["ties", tiesOf(view).length > 0, "line tie"],
    ];
    this.legend.replaceChildren(
      ...marks.filter(([, shown]) => shown).map(([name, , kind]) => h("span", { class: "standing-key" }, h("span", { class: `standing-${kind}` }), name)),
    );
  }
}
