// A shell as it stands: its feet, its flaps and its ties, and a person for its size.

import { feetOf, groundOf } from "../shared/ground.ts";
import { headroomOf } from "../shared/headroom.ts";
import { Feet3D, flapSides, Ties3D } from "../shared/moving3d.ts";
import { roomOfPerson } from "../shared/person.ts";
import { Person3D } from "../shared/person3d.ts";
import { Shell3D } from "../shared/shell3d.ts";
import { tiesOf } from "../shared/ties.ts";
import type { View } from "../shared/view.ts";

/** What is shown beside the shell as it stands. */
export type Beside = "person" | "ties";

/** Whether a shell has it. */
export const BESIDE: Record<Beside, (view: View) => boolean> = {
  person: (view) => Person3D.suits(view),
  ties: (view) => tiesOf(view).length > 0,
};

export class StandingShell extends Shell3D {
  private readonly person = new Person3D(this.uniforms);
  private readonly ties = new Ties3D(this.uniforms);
  private readonly again = { person: this.add(this.person), ties: this.add(this.ties) };
  private standing: View | null = null;

  constructor(container: HTMLElement, options: { label?: string }) {
    super(container, options);
    this.add(new Feet3D(this.uniforms));
  }

  override show(view: View, keepCamera = false): void {
    super.show(view, keepCamera);
    this.standing = view;
    const ground = groundOf(view);
    const room = BESIDE.person(view) ? headroomOf(view, ground.atTarget, roomOfPerson(view.header.unit)) : null;
    if (this.person.place(room)) this.refit();
    this.again.person();
    this.explainMark("feet", feetOf(view, ground).length > 0);
    this.explainMark("flaps", flapSides(view).length > 0);
    this.explainMark("ties", BESIDE.ties(view));
  }

  setBeside(name: Beside, on: boolean): void {
    this[name].setVisible(on);
    this.again[name]();
    if (name === "ties" && this.standing) this.explainMark("ties", on && BESIDE.ties(this.standing));
  }
}
