// The shell in space: orbit, fold, colours, overlays, hover. Drawn only when something changed.

import { Group, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { extentOf, goodDirection, placeCamera, type Extent } from "./camera.ts";
import { Clipped3D } from "./clipped3d.ts";
import { largest, themeOf, type Colouring } from "./colours.ts";
import { length } from "./quantities.ts";
import { Following } from "./following.ts";
import { armAfter } from "./keys.ts";
import { renderLegend, type Mark } from "./legend.ts";
import { Loaded3D, type Shown } from "./loaded3d.ts";
import { Look } from "./look.ts";
import type { Guest } from "./marks3d.ts";
import { Overlays, type Overlay } from "./overlays.ts";
import { Pace, type Quality } from "./pace.ts";
import { Pointing } from "./pointing.ts";
import { Sheet3D } from "./sheet3d.ts";
import { contactOf, stopsOf, targetShare } from "./stops.ts";
import { groundOf, type Ground } from "./ground.ts";
import type { Uniforms } from "./parts.ts";
import type { Motion } from "./rigid.ts";
import { shareTouch } from "./touch.ts";
import { Sun } from "./sun.ts";
import { assignmentCounts, targetPoints, type Lattice, type View } from "./view.ts";

export type { Colouring, Overlay };

/** Drives nearer than this are the same (degrees), and so are shares. */
const SAME = 1e-4;
const SAME_SHARE = 1e-6;
/** Of more panels every k-th is asked how far the shell reaches. */
const ASKED = 5000;

/** From where one looks: the way from what is looked at to the camera, and how far that was moved
 * from the middle of what was last fitted. */
export interface Sight {
  arm: Vector3;
  moved: Vector3;
}

export class Shell3D {
  onHover: ((panel: number | null) => void) | null = null;
  /** Told when the camera has moved. */
  onSight: (() => void) | null = null;

  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(28, 1, 0.1, 100);
  private readonly controls: OrbitControls;
  private readonly legend: HTMLElement;
  private readonly scale: HTMLElement;
  private readonly observer: ResizeObserver;
  private readonly look = new Look();
  private readonly sun = new Sun();
  private readonly u = {
    ...this.sun.uniforms,
    ...this.look.uniforms,
    screen: { value: new Vector2(1, 1) },
    density: { value: 1 },
    near: { value: 0.1 },
  };
  private readonly sheet = new Sheet3D(this.u);
  private readonly clipped = new Clipped3D(this.u);
  /** The shell without loads; hidden while it is shown with them. */
  private readonly unloaded = new Group();
  private readonly loaded = new Loaded3D(this.u);
  private readonly overlays: Overlays;
  private readonly pace: Pace;
  private readonly guests: Guest[] = [];
  /** Guests that are to be posed anew, though the shell is not. */
  private readonly moved = new Set<Guest>();
  private readonly beside = new Group();
  private ground: Ground | null = null;

  private view: View | null = null;
  private extent: Extent | null = null;
  private origin = new Vector3();
  /** The middle of what was last fitted. */
  private readonly middle = new Vector3();
  private share = 0;
  /** Share of the state that is the shell as it stands. */
  private target = 1;
  private readonly marks = new Set<Mark>();
  private contact: { panels: [number, number]; drive: number } | null = null;
  private distances: Float32Array | null = null;
  private readonly pointing: Pointing;
  private readonly ray = new Raycaster();
  private request = 0;
  private quality: Quality = { density: 1, taps: 12 };
  /** The poses are those of `share`; the card has them; so has the shadow. */
  private posed = false;
  private sent = false;
  private shaded = false;
  private fitted = false;
  private readonly following: Following;

  constructor(private readonly container: HTMLElement, options: { label?: string } = {}) {
    container.classList.add("orishell-scene");
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: "high-performance" });
    this.renderer.autoClear = false;
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-label", `${options.label ?? "Shell in space"}. Arrow keys turn it, plus and minus zoom, 0 fits it into view.`);
    container.append(canvas);
    this.legend = overlay(container, "orishell-legend");
    this.scale = overlay(container, "orishell-scale");

    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.09;
    this.controls.rotateSpeed = 0.75;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => {
      this.invalidate();
      this.onSight?.();
    });
    this.following = new Following(this.camera, this.controls.target);
    shareTouch(canvas, (x, y) => this.under(x, y) !== null);

    this.unloaded.add(...this.sheet.drawn, this.clipped.solids, this.beside);
    this.scene.add(this.unloaded, this.loaded.drawn);
    for (const depth of [this.sheet.depth, this.clipped.depths]) this.sun.add(depth);
    this.overlays = new Overlays(this.scene, this.u);
    this.pace = new Pace((quality) => this.setQuality(quality), () => this.draw());

    this.pointing = new Pointing(canvas, this.invalidate, () => this.hover(null));
    canvas.addEventListener("dblclick", () => this.fit());
    canvas.addEventListener("keydown", this.onKey);
    canvas.addEventListener("webglcontextrestored", this.onRestored);
    document.addEventListener("themechange", this.onTheme);
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(container);
    this.onTheme();
    this.resize();
  }

  get fold(): number {
    return this.share;
  }

  /** Drive of the state drawn, in degrees where states have drives. */
  get drive(): number {
    return this.sheet.motion?.driveAt(this.share) ?? 0;
  }

  /** The state drawn is the shell as it stands. */
  get atTarget(): boolean {
    return Math.abs(this.share - this.target) < SAME_SHARE;
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  get sight(): Sight {
    return { arm: this.arm(), moved: this.controls.target.clone().sub(this.middle) };
  }

  /** Two shells seen with the same sight are seen at the same scale. */
  set sight({ arm, moved }: Sight) {
    this.controls.target.copy(this.middle).add(moved);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.invalidate();
  }

  /** What drawings in the same space share. */
  get uniforms(): Uniforms {
    return this.u;
  }

  /** The motion, posed as it is drawn. */
  get motion(): Motion | null {
    this.pose();
    return this.sheet.motion;
  }

  /** Draw something else as well; it may ask for another frame. */
  add(guest: Guest): () => void {
    this.guests.push(guest);
    this.beside.add(...guest.drawn);
    guest.paint(themeOf(this.container));
    const again = (): void => {
      this.moved.add(guest);
      this.invalidate();
    };
    again();
    return again;
  }

  /** What lies under a place of the window: the panel and the point on it, about the origin. */
  under(x: number, y: number): { panel: number; point: Vector3 } | null {
    const box = this.canvas.getBoundingClientRect();
    this.ray.setFromCamera(new Vector2((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height), this.camera);
    const { origin: o, direction: d } = this.ray.ray;
    const hit = this.loaded.shown ? null : this.motion?.hit(o.x, o.y, o.z, d.x, d.y, d.z);
    return hit ? { panel: hit.panel, point: o.clone().addScaledVector(d, hit.along) } : null;
  }

  /** Where a point about the origin is in the window. */
  onScreen(point: Vector3): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    const { x, y } = point.clone().project(this.camera);
    return [box.left + (0.5 + 0.5 * x) * box.width, box.top + (0.5 - 0.5 * y) * box.height];
  }

  /** A small picture of the shell alone. */
  picture(width: number, height: number): HTMLCanvasElement {
    const small = Object.assign(document.createElement("canvas"), { width, height });
    this.beside.visible = false;
    this.draw();
    this.beside.visible = true;
    const { width: w, height: h } = this.canvas;
    const scale = Math.max(width / w, height / h);
    small.getContext("2d")?.drawImage(this.canvas, (width - w * scale) / 2, (height - h * scale) / 2, w * scale, h * scale);
    this.draw();
    return small;
  }

  /** Times between the latest frames of a motion (ms), for measuring. */
  get frameTimes(): readonly number[] {
    return this.pace.times;
  }

  show(view: View, keepCamera = false): void {
    this.view = view;
    this.target = targetShare(stopsOf(view));
    this.sheet.show(view);
    this.clipped.show(view.clipped);
    this.extent = extentOf(this.allPoints());
    this.overlays.show(view);
    this.loaded.show(view.loaded ?? null);
    this.setLoaded(null);
    this.setDistance(view.distance ?? null);
    const contact = contactOf(view);
    this.setContact(contact && contact.panels, contact?.drive_deg);
    const origin = new Vector3(...view.header.origin);
    const kept = keepCamera && this.fitted;
    if (kept) {
      this.following.shift(this.origin.clone().sub(origin));
    }
    this.origin = origin;
    this.sun.place(this.extent);
    this.scale.textContent = `grid ${length(this.overlays.placeGround(this.extent, origin), view.header.unit)}`;
    this.ground = groundOf(view);
    for (const guest of this.guests) guest.show?.(view, this.sheet.motion!);
    this.posed = false;
    this.highlight(null);
    if (!kept) this.fit(true);
    else if (this.following.follow(this.extent, this.seenPoints())) this.lookFrom(this.arm());
    else this.limitDistance();
    this.invalidate();
  }

  setFold(share: number): void {
    if (!Number.isFinite(share)) return;
    this.share = Math.min(1, Math.max(0, share));
    this.posed = false;
    this.markContact();
    this.invalidate();
  }

  setColouring(mode: Colouring): void {
    this.look.setColouring(mode, themeOf(this.container));
    this.explain();
    this.invalidate();
  }

  /** Signed distance of each vertex from the target; null if not known. */
  setDistance(values: Float32Array | null): void {
    this.distances = values;
    this.sheet.setValues(values);
    this.u.range.value = (values && largest(values)) || 1;
    this.explain();
    this.invalidate();
  }

  /** Panels that touch; marked from the drive on at which they do, at the target if none is given. */
  setContact(panels: [number, number] | null, driveDeg?: number): void {
    const drive = driveDeg ?? this.sheet.motion?.driveAt(this.target) ?? 0;
    this.contact = panels && { panels, drive };
    this.markContact();
    this.invalidate();
  }

  setOverlay(name: Overlay, visible: boolean): void {
    this.overlays.setVisible(name, visible);
    this.explainMark(name, visible);
    this.invalidate();
  }

  /** Draw another target, given in the world, until the next shell brings its own; its lowest point is
   * put where that of the present one is. */
  setSurface(surface: Lattice): void {
    const shift = this.origin.clone().negate();
    const level = this.view?.surface ? lowest(this.view.surface) : -this.origin.z;
    shift.z = level - lowest(surface);
    this.overlays.setSurface(surface, shift);
    this.invalidate();
  }

  /** Say in the legend what a mark's colour means, while it is seen. */
  explainMark(mark: Mark, seen: boolean): void {
    if (this.marks.has(mark) === seen) return;
    if (seen) this.marks.add(mark);
    else this.marks.delete(mark);
    this.explain();
  }

  /** Panels as the boards they are built of, where they have a thickness. */
  setThickness(visible: boolean): void {
    this.sheet.boards.setVisible(visible);
    this.clipped.setThickness(visible);
    this.invalidate();
  }

  /** Under a load case, which belongs to the target; null: without loads. */
  setLoaded(shown: Shown | null): void {
    this.loaded.set(shown);
    this.unloaded.visible = !this.loaded.shown;
    this.hover(null);
    this.explain();
    this.invalidate();
  }

  highlight(panel: number | null): void {
    if ((panel ?? -1) === this.u.hovered.value) return;
    this.u.hovered.value = panel ?? -1;
    this.sheet.mark(this.look.marked);
    this.invalidate();
  }

  /** Show the state drawn, from where one looks, or from a good direction; and those to which it is
   * folded, until one comes nearer or goes elsewhere. */
  fit(turn = false): void {
    if (!this.view) return;
    const towards = turn ? goodDirection(targetPoints(this.view) ?? this.drawnPoints()) : this.arm();
    this.stopGliding();
    this.lookFrom(towards);
  }

  /** Bring all into view again, unless one has come nearer or gone elsewhere. */
  refit(): void {
    if (this.fitted && this.following.turnedOnly) this.lookFrom(this.arm());
  }

  maxPanelStrain(): number {
    this.pose();
    return this.sheet.motion?.maxStrain() ?? 0;
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.pace.stop();
    this.observer.disconnect();
    document.removeEventListener("themechange", this.onTheme);
    this.controls.dispose();
    this.sheet.dispose();
    this.clipped.dispose();
    this.loaded.dispose();
    this.overlays.dispose();
    for (const guest of this.guests) guest.dispose();
    this.sun.dispose();
    this.look.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.container.replaceChildren();
  }

  private allPoints(): Float32Array[] {
    if (this.view?.positions.length) return [this.view.positions, ...this.clipped.points];
    this.sheet.motion!.setFold(this.share);
    return [this.corners(), ...this.clipped.points];
  }

  /** What is to be in view: the state drawn, and what stands beside it. */
  private seenPoints(): Float32Array[] {
    const drawn = this.drawnPoints();
    return [drawn, ...(this.atTarget ? this.clipped.standing : []), ...this.guests.flatMap(({ reach }) => reach ?? [])];
  }

  private drawnPoints(): Float32Array {
    this.pose();
    return this.corners();
  }

  /** Corners of the panels in the state that was set last; of many panels, of every k-th. */
  private corners(): Float32Array {
    const motion = this.sheet.motion!;
    const every = Math.ceil(motion.panels / ASKED) || 1, count = Math.ceil(motion.panels / every);
    const points = new Float32Array(12 * count);
    for (let k = 0; k < count; k++) motion.place(k * every, points.subarray(12 * k, 12 * k + 12));
    return points;
  }

  /** All that is to be in view, seen from a direction. */
  private lookFrom(towards: Vector3): void {
    this.middle.copy(placeCamera(this.camera, this.seenPoints(), towards));
    this.controls.target.copy(this.middle);
    this.fitted = this.container.clientWidth > 0;
    this.limitDistance();
    this.following.fitted(this.extent!);
    this.invalidate();
  }

  private arm(): Vector3 {
    return this.camera.position.clone().sub(this.controls.target);
  }

  /** What is left of a turn or a shift by hand does not go on from another place. */
  private stopGliding(): void {
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = true;
  }

  /** Never nearer or farther than the camera is put: a narrow picture wants it far away. */
  private limitDistance(): void {
    const away = this.arm().length();
    this.controls.minDistance = Math.min(0.02 * this.extent!.radius, away);
    this.controls.maxDistance = Math.max(14 * this.extent!.radius, away);
    this.controls.update();
  }

  private markContact(): void {
    const marked = this.contact !== null && this.drive >= this.contact.drive - SAME;
    this.explainMark("contact", marked);
    const [first, second] = marked ? this.contact!.panels : ([-1, -1] as const);
    if (this.u.touching.value.x === first && this.u.touching.value.y === second) return;
    this.u.touching.value.set(first, second);
    this.sheet.mark(this.look.marked);
  }

  private readonly onTheme = (): void => {
    const theme = themeOf(this.container);
    this.look.paint(theme);
    this.overlays.paint(theme);
    this.loaded.paint(theme);
    for (const guest of this.guests) guest.paint(theme);
    this.invalidate();
  };

  private explain(): void {
    if (!this.view) return;
    renderLegend(this.legend, {
      colouring: this.look.colouring,
      unit: this.view.header.unit,
      range: this.distances ? largest(this.distances) : 0,
      counts: assignmentCounts(this.view),
      loaded: this.loaded.shown,
      marks: this.marks,
    });
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.container;
    if (!width || !height) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.setQuality(this.quality);
    if (this.view && !this.fitted) this.fit(true);
    else this.refit();
    this.draw();
  }

  private setQuality(quality: Quality): void {
    this.quality = quality;
    const ratio = Math.min(2, window.devicePixelRatio || 1) * quality.density;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.container.clientWidth, this.container.clientHeight, false);
    this.renderer.getDrawingBufferSize(this.u.screen.value);
    this.u.density.value = ratio;
    this.u.shadowTaps.value = quality.taps;
  }

  private pose(): void {
    const { motion } = this.sheet;
    if (!motion || (this.posed && !this.moved.size)) return;
    if (!this.posed) motion.setFold(this.share);
    const { drive, atTarget } = this;
    const ground = this.ground?.levelAt(drive) ?? 0;
    for (const guest of this.posed ? this.moved : this.guests) guest.move?.(motion, { drive, atTarget, ground });
    this.moved.clear();
    if (this.posed) return;
    this.clipped.pose(this.share, drive, atTarget);
    this.overlays.setLevel(ground - 0.004 * this.extent!.radius);
    this.posed = true;
    this.sent = this.shaded = false;
  }

  private readonly invalidate = (): void => {
    this.request ||= requestAnimationFrame(this.frame);
  };

  private readonly frame = (now: number): void => {
    this.request = 0;
    this.pace.step(now);
    this.controls.update();
    this.pick();
    this.draw();
  };

  private draw(): void {
    if (!this.view) return;
    const { renderer, camera } = this;
    this.pose();
    if (!this.sent) {
      this.sheet.upload();
      this.refit();
    }
    this.sent = true;
    if (!this.shaded && this.quality.taps) {
      this.sun.draw(renderer);
      this.shaded = true;
    }
    const { centre, radius } = this.extent!;
    const away = camera.position.distanceTo(centre);
    camera.near = Math.max(0.01 * radius, away - 4.7 * radius);
    camera.far = away + 4.7 * radius;
    camera.updateProjectionMatrix();
    this.u.near.value = camera.near;
    const slope = Math.tan((camera.fov * Math.PI) / 360);
    const pixels = this.container.clientHeight / 2 / (slope * camera.position.distanceTo(this.controls.target));
    this.sheet.setScale(pixels);
    this.clipped.setScale(pixels);
    renderer.clear();
    renderer.render(this.scene, camera);
  }

  private pick(): void {
    const at = this.pointing.take();
    if (!at || this.loaded.shown) return;
    this.ray.setFromCamera(at, this.camera);
    this.pose();
    const { origin: o, direction: d } = this.ray.ray;
    const found = this.sheet.motion?.pick(o.x, o.y, o.z, d.x, d.y, d.z) ?? -1;
    this.hover(found < 0 ? null : found);
  }

  private hover(panel: number | null): void {
    if ((panel ?? -1) === this.u.hovered.value) return;
    this.highlight(panel);
    this.onHover?.(panel);
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "0" || event.key === "Home") this.fit();
    else {
      const arm = armAfter(event.key, this.arm());
      if (!arm) return;
      this.camera.position.copy(this.controls.target).add(arm);
    }
    event.preventDefault();
    this.invalidate();
  };

  private readonly onRestored = (): void => {
    this.sent = this.shaded = false;
    this.invalidate();
  };
}

function lowest({ points }: Lattice): number {
  let found = Infinity;
  for (let k = 2; k < points.length; k += 3) found = Math.min(found, points[k]!);
  return found;
}

function overlay(container: HTMLElement, name: string): HTMLElement {
  const element = document.createElement("div");
  element.className = name;
  container.append(element);
  return element;
}
