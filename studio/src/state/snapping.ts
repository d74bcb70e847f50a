// SPDX-License-Identifier: MIT
// Places that are dragged snap to the floor, to the faces of things in the way and to the other hand. Hands stay off faces by their
// thickness and a little more, as they are not flat, so that they lie on a table and not in it.
import { Quaternion, Vector3 } from 'three';
import type { Obstacle } from '../../../bindings/wasm/src/types';
import { type Document, goalOf } from './model';
import { leastOf, thingName, thingOf, thingsOf } from './places';

const kReach = 0.05; // m, largest distance of attraction
const kClear = 0.012; // m, between a hand as it is thick and a face

export interface Snap {
  readonly place: Vector3;
  readonly normal: Vector3; // away from the surface that it snapped to
  readonly to: string; // "floor", or the name of a thing or a hand
}

export interface Ray {
  readonly origin: Vector3;
  readonly direction: Vector3;
}

const turnOf = ({ rotation_xyzw }: Obstacle): Quaternion => (rotation_xyzw ? new Quaternion(...rotation_xyzw) : new Quaternion());
const halfOf = ({ size_m = [0, 0, 0], radius_m = 0 }: Obstacle): Vector3 => new Vector3(...size_m).multiplyScalar(0.5).addScalar(radius_m);

function toThing(thing: Obstacle, point: Vector3): Vector3 {
  return point.clone().sub(new Vector3(...thing.position_m)).applyQuaternion(turnOf(thing).invert());
}

/** A point and a direction of the thing's own axes, in the world. */
function onFace(thing: Obstacle, local: Vector3, normal: Vector3, thickness: number, to: string): Snap {
  const outward = normal.clone().applyQuaternion(turnOf(thing));
  const place = local.clone().applyQuaternion(turnOf(thing)).add(new Vector3(...thing.position_m)).addScaledVector(outward, thickness);
  return { place, normal: outward, to };
}

/** The nearest place of the box about a thing; the box of a ball or a capsule is larger than it. */
function nearestFace(thing: Obstacle, point: Vector3, thickness: number, to: string): Snap {
  const half = halfOf(thing);
  const local = toThing(thing, point);
  let axis = 0;
  let most = -Infinity;
  for (let k = 0; k < 3; ++k) {
    const beyond = Math.abs(local.getComponent(k)) - half.getComponent(k);
    if (beyond > most) [axis, most] = [k, beyond];
  }
  const side = local.getComponent(axis) < 0 ? -1 : 1;
  const on = local.clone().clamp(half.clone().negate(), half).setComponent(axis, side * half.getComponent(axis));
  return onFace(thing, on, new Vector3().setComponent(axis, side), thickness, to);
}

/** Where a ray comes into the box about a thing, and how far from its origin. */
function struckFace(thing: Obstacle, ray: Ray, thickness: number, to: string): { snap: Snap; far: number } | null {
  const half = halfOf(thing);
  const from = toThing(thing, ray.origin);
  const way = ray.direction.clone().applyQuaternion(turnOf(thing).invert());
  let near = -Infinity;
  let far = Infinity;
  let axis = 0;
  for (let k = 0; k < 3; ++k) {
    const [o, d, reach] = [from.getComponent(k), way.getComponent(k), half.getComponent(k)];
    if (Math.abs(d) < 1e-9) {
      if (Math.abs(o) > reach) return null;
      continue;
    }
    const first = (-Math.sign(d) * reach - o) / d;
    if (first > near) [near, axis] = [first, k];
    far = Math.min(far, (Math.sign(d) * reach - o) / d);
  }
  if (near > far || near <= 0) return null;
  const normal = new Vector3().setComponent(axis, -Math.sign(way.getComponent(axis)));
  return { snap: onFace(thing, from.addScaledVector(way, near), normal, thickness, to), far: near };
}

/** Half a hand's thickness, m; of a body without hands of its own as its forearms are. */
function thicknessOf({ character }: Document, name: string): number {
  const { capsules } = character.description;
  if (!name.endsWith('hand')) return 0;
  return [name, name.replace('hand', 'forearm')].map((part) => capsules.find((capsule) => capsule.name === part)?.radius_m).find((radius) => radius !== undefined) ?? 0;
}

/** Positions of a thing on the tops of other things. */
function tops(document: Document, index: number, place: Vector3): Snap[] {
  const things = thingsOf(document);
  const bottom = leastOf(document, thingName(index));
  return things.flatMap((other, k) => {
    const [half, [x, y, z]] = [halfOf(other), other.position_m];
    if (k === index || other.rotation_xyzw || Math.abs(place.x - x) > half.x || Math.abs(place.z - z) > half.z) return [];
    return [{ place: place.clone().setY(y + half.y + bottom), normal: new Vector3(0, 1, 0), to: thingName(k) }];
  });
}

function besideOtherHand(document: Document, name: string): Snap[] {
  const other = name === 'left_hand' ? 'right_hand' : name === 'right_hand' ? 'left_hand' : undefined;
  const goal = other && goalOf(document, other);
  if (!goal) return [];
  const side = new Vector3(name === 'left_hand' ? 1 : -1, 0, 0);
  const apart = thicknessOf(document, name) + thicknessOf(document, other);
  return [{ place: new Vector3(...goal.position_m).addScaledVector(side, apart), normal: side, to: other }];
}

/** What a place snaps to; null where nothing attracts it. A face that `ray`, the pointer's, strikes attracts from afar. */
export function snapOf(document: Document, name: string, place: Vector3, ray?: Ray): Snap | null {
  const index = thingOf(name);
  const thickness = thicknessOf(document, name);
  const off = thickness > 0 ? thickness + kClear : 0;
  const things = thingsOf(document);
  if (index === null && ray) {
    const struck = things.map((thing, k) => struckFace(thing, ray, off, thingName(k))).filter((hit) => hit !== null);
    const first = struck.sort((a, b) => a.far - b.far)[0];
    if (first) return first.snap;
  }
  const floor: Snap = { place: place.clone().setY(Math.max(leastOf(document, name), thickness)), normal: new Vector3(0, 1, 0), to: 'floor' };
  const all = [
    floor, ...besideOtherHand(document, name),
    ...(index === null ? things.map((thing, k) => nearestFace(thing, place, off, thingName(k))) : tops(document, index, place)),
  ];
  const distance = (snap: Snap): number => snap.place.distanceTo(place);
  const nearest = all.reduce((best, snap) => (distance(snap) < distance(best) ? snap : best));
  return distance(nearest) < kReach ? nearest : null;
}
