// SPDX-License-Identifier: MIT
// Handles that a person drags: a ball at each goal, and a smaller one at each hand, foot and the head that has none yet.
// The selected goal has arrows along the axes too, and rings where its rotation is asked for.
import {
  CanvasTexture, Group, Object3D, Plane, Raycaster, Sprite, SpriteMaterial, SRGBColorSpace, Vector2, Vector3,
} from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Goal, Quat, Vec3 } from '../../../bindings/wasm/src/types';
import type { Palette } from './palette';
import type { Stage } from './stage';

const kGrab = 20; // px about a handle's middle
export const kFarthest = 3; // m from the middle

export interface HandleEvents {
  select(effector: string): void;
  drag(effector: string, position: Vec3, rotation?: Quat): void;
  drop(effector: string, position: Vec3, rotation?: Quat): void;
  hover(effector: string | null, x: number, y: number): void;
  /** How high a goal must be, m. */
  least(effector: string, rotation?: Quat): number;
}

interface Handle {
  effector: string;
  sprite: Sprite;
  goal: boolean;
}

export class Handles {
  readonly object = new Group();
  private handles: Handle[] = [];
  private dragged: { handle: Handle; plane: Plane; grip: Vector3; moved: boolean } | null = null;
  private readonly anchor = new Object3D();
  private readonly gizmo: TransformControls;
  private readonly materials = { goal: disc(), selected: disc(), idle: disc() };
  private readonly ray = new Raycaster();
  private readonly held = new Vector3(); // where the goal is while the arrows move it
  private rotates = false;

  constructor(private readonly stage: Stage, private readonly canvas: HTMLCanvasElement, private readonly events: HandleEvents) {
    this.gizmo = new TransformControls(stage.camera, canvas);
    this.gizmo.setSize(0.7);
    this.gizmo.setColors('#d94f4f', '#4fa84f', '#4f7fd9', '#ffb347');
    this.gizmo.addEventListener('change', () => stage.invalidate());
    this.gizmo.addEventListener('dragging-changed', (event) => {
      stage.orbit.enabled = !event.value;
      if (!event.value) this.gizmoMoved(true);
    });
    this.gizmo.addEventListener('objectChange', () => this.gizmoMoved(false));
    this.object.add(this.anchor, this.gizmo.getHelper());
    canvas.addEventListener('pointerdown', this.down, { capture: true });
    canvas.addEventListener('pointermove', this.move);
    canvas.addEventListener('pointerup', this.up);
    canvas.addEventListener('pointercancel', this.up);
    canvas.addEventListener('pointerleave', () => events.hover(null, 0, 0));
  }

  get busy(): boolean {
    return this.dragged !== null || this.gizmo.dragging;
  }

  paint(palette: Palette): void {
    draw(this.materials.goal, `#${palette.goal.getHexString()}`, false);
    draw(this.materials.selected, `#${palette.goal.getHexString()}`, true);
    draw(this.materials.idle, `#${palette.idle.getHexString()}`, false);
    this.materials.idle.opacity = 0.75;
  }

  setEffectors(effectors: readonly string[]): void {
    for (const { sprite } of this.handles) sprite.removeFromParent();
    this.handles = effectors.map((effector) => {
      const sprite = new Sprite(this.materials.idle);
      sprite.renderOrder = 10;
      this.object.add(sprite);
      return { effector, sprite, goal: false };
    });
  }

  /** `places`: where effectors without a goal are now, m. */
  update(goals: readonly Goal[], selected: string, rotate: boolean, places: (effector: string) => Vector3 | null): void {
    let chosen: Handle | null = null;
    for (const handle of this.handles) {
      const goal = goals.find((g) => g.effector === handle.effector);
      handle.goal = goal !== undefined;
      const isSelected = handle.effector === selected && handle.goal;
      handle.sprite.material = isSelected ? this.materials.selected : handle.goal ? this.materials.goal : this.materials.idle;
      const size = isSelected ? 0.042 : handle.goal ? 0.022 : 0.016;
      handle.sprite.scale.setScalar(size * this.stage.lens.constantSize);
      if (isSelected) chosen = handle;
      if (this.dragged?.handle === handle || (isSelected && this.gizmo.dragging)) continue;
      const place = goal ? new Vector3(...goal.position_m) : places(handle.effector);
      handle.sprite.visible = place !== null;
      if (place) handle.sprite.position.copy(place);
      if (isSelected) this.anchorAt(goal!);
    }
    this.rotates = rotate && goals.find((g) => g.effector === selected)?.rotation_xyzw !== undefined;
    this.gizmo.camera = this.stage.lens.shown;
    this.gizmo.setMode(this.rotates ? 'rotate' : 'translate');
    this.gizmo.setSpace(this.rotates ? 'local' : 'world');
    if (chosen && !this.dragged) this.gizmo.attach(this.anchor);
    else this.gizmo.detach();
  }

  private anchorAt(goal: Goal): void {
    this.anchor.position.set(...goal.position_m);
    if (goal.rotation_xyzw) this.anchor.quaternion.set(...goal.rotation_xyzw);
    else this.anchor.quaternion.identity();
  }

  private gizmoMoved(end: boolean): void {
    const handle = this.handles.find((h) => h.sprite.material === this.materials.selected);
    if (!handle) return;
    const rotation = this.rotates ? this.anchor.quaternion.toArray() : undefined;
    clampPlace(this.anchor.position, this.events.least(handle.effector, rotation));
    this.held.copy(this.anchor.position);
    handle.sprite.position.copy(this.held);
    if (end) this.events.drop(handle.effector, this.held.toArray(), rotation);
    else this.events.drag(handle.effector, this.held.toArray(), rotation);
  }

  /** The handle under the pointer: the nearest on the screen, goals before others. */
  private under(event: PointerEvent): Handle | null {
    const box = this.canvas.getBoundingClientRect();
    let best: Handle | null = null;
    let least = kGrab;
    for (const handle of this.handles) {
      if (!handle.sprite.visible) continue;
      const p = handle.sprite.position.clone().project(this.stage.lens.shown);
      const x = ((p.x + 1) / 2) * box.width + box.left;
      const y = ((1 - p.y) / 2) * box.height + box.top;
      const far = Math.hypot(event.clientX - x, event.clientY - y) * (handle.goal ? 0.8 : 1.4);
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
    if (!handle || (handle.sprite.material === this.materials.selected && this.gizmo.axis?.length === 1)) return;
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    this.stage.orbit.enabled = false;
    this.canvas.focus({ preventScroll: true, focusVisible: false });
    const normal = this.stage.lens.shown.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, handle.sprite.position);
    this.aim(event);
    const hit = this.ray.ray.intersectPlane(plane, new Vector3()) ?? handle.sprite.position.clone();
    this.dragged = { handle, plane, grip: handle.sprite.position.clone().sub(hit), moved: false };
    this.gizmo.detach();
    this.events.hover(null, 0, 0);
    this.events.select(handle.effector);
  };

  private readonly move = (event: PointerEvent): void => {
    const drag = this.dragged;
    if (!drag) {
      if (event.buttons !== 0) return;
      const over = this.under(event);
      this.canvas.classList.toggle('grab', over !== null);
      this.events.hover(over?.effector ?? null, event.offsetX, event.offsetY);
      return;
    }
    this.aim(event);
    const hit = this.ray.ray.intersectPlane(drag.plane, new Vector3());
    if (!hit) return;
    const place = clampPlace(hit.add(drag.grip), this.events.least(drag.handle.effector));
    if (!drag.moved && place.distanceTo(drag.handle.sprite.position) < 0.002) return;
    drag.moved = true;
    drag.handle.sprite.position.copy(place);
    this.stage.invalidate();
    this.events.drag(drag.handle.effector, place.toArray());
  };

  private readonly up = (event: PointerEvent): void => {
    const drag = this.dragged;
    if (!drag) return;
    this.dragged = null;
    this.stage.orbit.enabled = true;
    if (this.canvas.hasPointerCapture(event.pointerId)) this.canvas.releasePointerCapture(event.pointerId);
    if (drag.moved) this.events.drop(drag.handle.effector, drag.handle.sprite.position.toArray());
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

function draw(material: SpriteMaterial, colour: string, selected: boolean): void {
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
  pen.arc(64, 64, selected ? 27 : 50, 0, 7);
  pen.fill();
  pen.stroke();
  material.map!.needsUpdate = true;
}
