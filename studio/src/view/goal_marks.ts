// SPDX-License-Identifier: MIT
// Marks of what goals ask for beside a place: the box in which any place will do, the way that a palm or another axis is to face, and
// the loads that hands carry. And the line of sight to what is looked at, and the seat that a body sits on.
import {
  ArrowHelper, BoxGeometry, BufferGeometry, EdgesGeometry, Group, Line, LineBasicMaterial, LineDashedMaterial, LineSegments, Mesh, MeshStandardMaterial,
  type Object3D, type Vector3Tuple, Vector3,
} from 'three';
import type { Goal, GoalAxis } from '../../../bindings/wasm/src/types';
import type { Document } from '../state/model';
import { lookOf } from '../state/places';
import type { Palette } from './palette';

const kArrow = 0.16; // m
const kArrowHead: readonly [length: number, width: number] = [0.05, 0.035]; // m
const kDensity = 500; // kg/m³, of a load: a packed box's
const kSeatWidth = 0.42; // m
const kThinnest = 0.004; // m: a box without extent along an axis is seen as a plate

const kDirections: Readonly<Record<string, Vector3Tuple>> = {
  up: [0, 1, 0], down: [0, -1, 0], left: [1, 0, 0], right: [-1, 0, 0], ahead: [0, 0, 1], back: [0, 0, -1],
};

function directionOf({ direction }: GoalAxis): Vector3 {
  return new Vector3(...(typeof direction === 'string' ? kDirections[direction]! : direction)).normalize();
}

type Kind = 'axis' | 'box' | 'load' | 'seat' | 'sight';

export class GoalMarks {
  readonly object = new Group();
  /** Loads and the seat, which cast shadows. */
  readonly solids = new Group();
  private readonly edges = new LineBasicMaterial({ transparent: true, opacity: 0.8 });
  private readonly seat = new MeshStandardMaterial({ roughness: 0.9 });
  private readonly load = new MeshStandardMaterial({ roughness: 0.9 });
  private readonly sight = new LineDashedMaterial({ dashSize: 0.025, gapSize: 0.025, transparent: true, opacity: 0.7 });
  private line: Line<BufferGeometry, LineDashedMaterial> | null = null;
  private look: Vector3 | null = null;
  private loads: { effector: string; box: Mesh; side: number }[] = [];
  private shown: Document | null = null;
  private palette: Palette | null = null;

  paint(palette: Palette): void {
    this.palette = palette;
    this.edges.color = palette.goal;
    this.sight.color = palette.idle;
    this.seat.color = palette.idle;
    this.load.color = palette.goal.clone().lerp(palette.joints, 0.5);
    this.shown = null;
  }

  show(document: Document | null): void {
    if (!document || document === this.shown) return;
    this.shown = document;
    this.clear();
    for (const goal of document.goals) this.mark(goal);
    const look = lookOf(document);
    if (look) {
      this.look = new Vector3(...look);
      this.line = new Line(new BufferGeometry().setFromPoints([this.look, this.look]), this.sight);
      this.line.frustumCulled = false;
      this.add('sight', this.line, this.object);
    }
    const seat = document.character.spec.seat_m;
    if (seat !== undefined) this.addSeat(document.character, seat);
  }

  private clear(): void {
    for (const mark of [...this.object.children, ...this.solids.children]) {
      if (mark instanceof ArrowHelper) mark.dispose();
      else (mark as Mesh).geometry.dispose();
      mark.removeFromParent();
    }
    this.loads = [];
    this.line = this.look = null;
  }

  private add(kind: Kind, mark: Object3D, to: Group): void {
    mark.name = kind;
    to.add(mark);
  }

  private mark({ effector, position_m, tolerance_m, axis, load_kg }: Goal): void {
    const place = new Vector3(...position_m);
    if (tolerance_m) {
      const [x, y, z] = tolerance_m.map((half) => Math.max(2 * half, kThinnest)) as Vector3Tuple;
      const box = new BoxGeometry(x, y, z);
      const lines = new LineSegments(new EdgesGeometry(box), this.edges);
      box.dispose();
      lines.position.copy(place);
      this.add('box', lines, this.object);
    }
    if (axis) this.add('axis', new ArrowHelper(directionOf(axis), place, kArrow, this.palette?.goal, ...kArrowHead), this.object);
    if (load_kg) {
      const side = Math.cbrt(load_kg / kDensity);
      const box = new Mesh(new BoxGeometry(side, side, side), this.load);
      box.castShadow = true;
      this.loads.push({ effector, box, side });
      this.add('load', box, this.solids);
    }
  }

  /** Below the hips, where the body sits before the motion. */
  private addSeat({ description }: Document['character'], height: number): void {
    const hips = description.places.find(({ effector }) => effector === 'hips')?.start_m ?? [0, height, 0];
    const box = new Mesh(new BoxGeometry(kSeatWidth, height, kSeatWidth), this.seat);
    box.position.set(hips[0], height / 2, hips[2]);
    box.castShadow = box.receiveShadow = true;
    this.add('seat', box, this.solids);
  }

  /** Loads hang below the hands that carry them, and the line of sight begins at the head. */
  pose(placeOf: (effector: string) => Vector3 | null): void {
    for (const { effector, box, side } of this.loads) {
      const place = placeOf(effector);
      box.visible = place !== null;
      if (place) box.position.set(place.x, Math.max(place.y - side / 2, side / 2), place.z);
    }
    const head = placeOf('head');
    if (this.line && this.look && head) {
      this.line.geometry.setFromPoints([head, this.look]);
      this.line.computeLineDistances();
    }
  }

  /** What is marked; for tests. */
  get kinds(): string[] {
    return [...this.object.children, ...this.solids.children].map(({ name }) => name);
  }
}
