// SPDX-License-Identifier: MIT
// Handles that a person drags: a ball at each goal, a smaller one at each hand, foot and the head that has none yet, and a square at each
// thing in the way. The selected one has arrows along the axes too, or rings where its rotation is asked for.
import {
  CanvasTexture, Group, Object3D, Plane, type Ray, Raycaster, Sprite, SpriteMaterial, SRGBColorSpace, Vector2, Vector3,
} from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Quat, Vec3 } from '../../../bindings/wasm/src/types';
import type { Palette } from './palette';
import type { Stage } from './stage';

const kGrab = 20; // px about a handle's middle
const kStill = 0.002; // m: less is no drag
export const kFarthest = 3; // m from the middle

export interface HandleEvents {
  select(name: string): void;
  drag(name: string, position: Vec3, rotation?: Quat): void;
  drop(name: string, position: Vec3, rotation?: Quat): void;
  hover(name: string | null, x: number, y: number): void;
  /** Where it goes instead, as it snaps; `inverted`: the modifier key is held. */
  snap(name: string, place: Vector3, inverted: boolean, ray?: Ray): Vector3;
  /** How high it must be, m. */
  least(name: string): number;
}

/** goal: asked for; free, joint: a hand, foot or head, or another joint, that no goal is for; look: what the eyes are on; thing: one in the way. */
type Kind = 'goal' | 'free' | 'joint' | 'look' | 'thing';

/** What can be dragged, and where it is, m. */
export interface Grip {
  readonly name: string;
  readonly kind: Kind;
  readonly place: Vector3;
  readonly rotation?: Quat;
}

interface Handle extends Grip {
  readonly sprite: Sprite;
}

const kSizes: Readonly<Record<Kind, number>> = { goal: 0.022, free: 0.016, joint: 0.011, look: 0.026, thing: 0.018 };
const kSelected: Readonly<Partial<Record<Kind, 'selectedThing' | 'selectedLook'>>> = { thing: 'selectedThing', look: 'selectedLook' };
const kSelectedSize = 0.042;
/** Of a handle's distance from the pointer: goals go before others. */
const kFar: Readonly<Record<Kind, number>> = { goal: 0.8, free: 1.4, joint: 1.9, look: 1, thing: 1.4 };

export class Handles {
  readonly object = new Group();
  private handles: Handle[] = [];
  private chosen: Handle | null = null;
  private dragged: { name: string; plane: Plane; grip: Vector3; from: Vector3; to: Vector3 | null } | null = null;
  private readonly anchor = new Object3D();
  private readonly gizmo: TransformControls;
  private readonly materials = { goal: disc(), free: disc(), joint: disc(), look: disc(), thing: disc(), selected: disc(), selectedThing: disc(), selectedLook: disc() };
  private readonly ray = new Raycaster();
  private rotates = false;
  private readonly turnedAt = new Vector3(); // where what is turned was before
  private inverted = false; // Ctrl, or Command, is held

  constructor(private readonly stage: Stage, private readonly canvas: HTMLCanvasElement, private readonly events: HandleEvents) {
    this.gizmo = new TransformControls(stage.camera, canvas);
    this.gizmo.setSize(0.7);
    this.gizmo.setColors('#d94f4f', '#4fa84f', '#4f7fd9', '#ffb347');
    this.gizmo.addEventListener('change', () => stage.invalidate());
    this.gizmo.addEventListener('dragging-changed', (event) => {
      stage.orbit.enabled = !event.value;
      if (event.value) this.turnedAt.copy(this.anchor.position);
      else this.gizmoMoved(true);
    });
    this.gizmo.addEventListener('objectChange', () => this.gizmoMoved(false));
    this.object.add(this.anchor, this.gizmo.getHelper());
    canvas.addEventListener('pointerdown', this.down, { capture: true });
    canvas.addEventListener('pointermove', this.modified, { capture: true });
    canvas.addEventListener('pointermove', this.move);
    canvas.addEventListener('pointerup', this.up);
    canvas.addEventListener('pointercancel', this.up);
    canvas.addEventListener('pointerleave', () => events.hover(null, 0, 0));
  }

  get busy(): boolean {
    return this.dragged !== null || this.gizmo.dragging;
  }

  paint(palette: Palette): void {
    const [goal, idle] = [palette.goal, palette.idle].map((colour) => `#${colour.getHexString()}`) as [string, string];
    draw(this.materials.goal, { colour: goal });
    draw(this.materials.selected, { colour: goal, selected: true });
    draw(this.materials.free, { colour: idle });
    draw(this.materials.joint, { colour: idle });
    draw(this.materials.look, { colour: idle, shape: 'eye' });
    draw(this.materials.selectedLook, { colour: goal, shape: 'eye', selected: true });
    draw(this.materials.thing, { colour: idle, shape: 'square' });
    draw(this.materials.selectedThing, { colour: idle, shape: 'square', selected: true });
    this.materials.free.opacity = this.materials.joint.opacity = 0.75;
  }

  update(grips: readonly Grip[], selected: string, rotate: boolean): void {
    const sprites = this.handles.map(({ sprite }) => sprite);
    while (sprites.length > grips.length) sprites.pop()!.removeFromParent();
    while (sprites.length < grips.length) {
      const sprite = new Sprite(this.materials.free);
      sprite.renderOrder = 10;
      this.object.add(sprite);
      sprites.push(sprite);
    }
    this.handles = grips.map((grip, index) => ({ ...grip, sprite: sprites[index]! }));
    this.chosen = this.handles.find(({ name, kind }) => name === selected && kind !== 'free' && kind !== 'joint') ?? null;
    for (const handle of this.handles) {
      const { kind, place, sprite } = handle;
      const isChosen = handle === this.chosen;
      sprite.material = this.materials[isChosen ? (kSelected[kind] ?? 'selected') : kind];
      sprite.scale.setScalar((isChosen ? kSelectedSize : kSizes[kind]) * this.stage.lens.constantSize);
      sprite.position.copy(place);
    }
    if (this.chosen && !this.gizmo.dragging) this.anchorAt(this.chosen);
    else if (this.chosen && this.rotates) this.anchor.position.copy(this.chosen.place);
    this.rotates = rotate && this.chosen?.rotation !== undefined;
    this.gizmo.camera = this.stage.lens.shown;
    this.gizmo.setMode(this.rotates ? 'rotate' : 'translate');
    this.gizmo.setSpace(this.rotates ? 'local' : 'world');
    if (this.chosen && !this.dragged) this.gizmo.attach(this.anchor);
    else this.gizmo.detach();
  }

  private anchorAt({ place, rotation }: Grip): void {
    this.anchor.position.copy(place);
    if (rotation) this.anchor.quaternion.set(...rotation);
    else this.anchor.quaternion.identity();
  }

  private gizmoMoved(end: boolean): void {
    if (!this.chosen) return;
    const { name } = this.chosen;
    const rotation = this.rotates ? this.anchor.quaternion.toArray() : undefined;
    if (!rotation) clampPlace(this.anchor.position, this.events.least(name));
    const place = (rotation ? this.turnedAt : this.events.snap(name, this.anchor.position, this.inverted)).toArray();
    if (end) this.events.drop(name, place, rotation);
    else this.events.drag(name, place, rotation);
  }

  /** The handle under the pointer: the nearest on the screen, goals before others. */
  private under(event: PointerEvent): Handle | null {
    const box = this.canvas.getBoundingClientRect();
    let best: Handle | null = null;
    let least = kGrab;
    for (const handle of this.handles) {
      const p = handle.place.clone().add(this.object.position).project(this.stage.lens.shown);
      const x = ((p.x + 1) / 2) * box.width + box.left;
      const y = ((1 - p.y) / 2) * box.height + box.top;
      const far = Math.hypot(event.clientX - x, event.clientY - y) * kFar[handle.kind];
      if (far < least) {
        least = far;
        best = handle;
      }
    }
    return best;
  }

  private aim(event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    const point = new Vector2(
      ((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2,
    );
    this.ray.setFromCamera(point, this.stage.lens.shown);
  }

  private readonly down = (event: PointerEvent): void => {
    if (event.button !== 0 || this.busy) return;
    const handle = this.under(event);
    if (!handle || (handle === this.chosen && this.gizmo.axis?.length === 1)) return;
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    this.stage.orbit.enabled = false;
    this.canvas.focus({ preventScroll: true, focusVisible: false });
    const normal = this.stage.lens.shown.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, handle.place.clone().add(this.object.position));
    this.aim(event);
    const hit = this.ray.ray.intersectPlane(plane, new Vector3()) ?? handle.place.clone().add(this.object.position);
    this.dragged = { name: handle.name, plane, grip: handle.place.clone().sub(hit), from: handle.place.clone(), to: null };
    this.gizmo.detach();
    this.events.hover(null, 0, 0);
    this.events.select(handle.name);
  };

  private readonly modified = (event: PointerEvent): void => {
    this.inverted = event.ctrlKey || event.metaKey;
  };

  private readonly move = (event: PointerEvent): void => {
    const drag = this.dragged;
    if (!drag) {
      if (event.buttons !== 0) return;
      const over = this.under(event);
      this.canvas.classList.toggle('grab', over !== null);
      this.events.hover(over?.name ?? null, event.offsetX, event.offsetY);
      return;
    }
    this.aim(event);
    const hit = this.ray.ray.intersectPlane(drag.plane, new Vector3());
    if (!hit) return;
    const aimed = clampPlace(hit.add(drag.grip), this.events.least(drag.name));
    if (!drag.to && aimed.distanceTo(drag.from) < kStill) return;
    const ray = this.ray.ray.clone();
    ray.origin.sub(this.object.position);
    const place = this.events.snap(drag.name, aimed, this.inverted, ray);
    drag.to = place;
    this.events.drag(drag.name, place.toArray());
  };

  private readonly up = (event: PointerEvent): void => {
    const drag = this.dragged;
    if (!drag) return;
    this.dragged = null;
    this.stage.orbit.enabled = true;
    if (this.canvas.hasPointerCapture(event.pointerId)) this.canvas.releasePointerCapture(event.pointerId);
    if (drag.to) this.events.drop(drag.name, drag.to.toArray());
    else this.stage.invalidate();
  };

  dispose(): void {
    this.canvas.removeEventListener('pointerdown', this.down, { capture: true });
    this.gizmo.dispose();
  }
}

function clampPlace(place: Vector3, least: number): Vector3 {
  place.clampLength(0, kFarthest);
  place.y = Math.max(place.y, least);
  return place;
}

function disc(): SpriteMaterial {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 128;
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  return new SpriteMaterial({ map, depthTest: false, depthWrite: false, transparent: true, sizeAttenuation: false });
}

interface Drawing {
  colour: string;
  shape?: 'disc' | 'square' | 'eye';
  selected?: boolean;
}

function draw(material: SpriteMaterial, { colour, shape = 'disc', selected = false }: Drawing): void {
  const canvas = material.map!.image as HTMLCanvasElement;
  const pen = canvas.getContext('2d')!;
  pen.clearRect(0, 0, 128, 128);
  if (selected) {
    pen.globalAlpha = 0.2;
    pen.fillStyle = colour;
    pen.beginPath();
    pen.arc(64, 64, 62, 0, 7);
    pen.fill();
    pen.globalAlpha = 1;
  }
  pen.fillStyle = colour;
  pen.strokeStyle = 'rgba(255,255,255,0.95)';
  pen.lineWidth = selected ? 6 : 10;
  pen.beginPath();
  const reach = selected ? 27 : 50;
  if (shape === 'square') pen.rect(64 - reach, 64 - reach, 2 * reach, 2 * reach);
  else if (shape === 'eye') pen.ellipse(64, 64, 1.15 * reach, 0.7 * reach, 0, 0, 7);
  else pen.arc(64, 64, reach, 0, 7);
  pen.fill();
  pen.stroke();
  if (shape === 'eye') {
    pen.fillStyle = 'rgba(255,255,255,0.95)';
    pen.beginPath();
    pen.arc(64, 64, 0.32 * reach, 0, 7);
    pen.fill();
  }
  material.map!.needsUpdate = true;
}
