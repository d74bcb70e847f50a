// SPDX-License-Identifier: MIT
// All that has a place in a document and can be moved there, by names: goals by those of their effectors, things in the way by their numbers,
// and what the eyes are on.
import type { Goal, Obstacle, Quat, Vec3 } from '../../../bindings/wasm/src/types';
import { aboveFloor, leastHeight } from './floor';
import { type Document, goalOf } from './model';
import { isUnturned } from './turning';

const kThing = '@thing '; // no effector's name begins so
const kOnFloor = 1e-6; // m
const kNone: readonly Obstacle[] = [];

export const lookName = '@look';

export const thingName = (index: number): string => `${kThing}${index}`;

/** The number of the thing that a name is of; null where it is of a goal. */
export function thingOf(name: string): number | null {
  return name.startsWith(kThing) ? Number(name.slice(kThing.length)) : null;
}

export function thingsOf({ settings }: Document): readonly Obstacle[] {
  return settings.more.obstacles ?? kNone;
}

/** Where the eyes are on; undefined where the engine chooses. */
export function lookOf({ settings }: Document): Vec3 | undefined {
  return settings.more.look_at_m;
}

export function withLook(document: Document, place: Vec3 | undefined): Document {
  const { look_at_m: _, ...more } = document.settings.more;
  return { ...document, settings: { ...document.settings, more: place ? { ...more, look_at_m: place } : more } };
}

/** The names of all places, goals first. */
export function placeNames(document: Document): string[] {
  return [...document.goals.map(({ effector }) => effector), ...(lookOf(document) ? [lookName] : []), ...thingsOf(document).map((_, index) => thingName(index))];
}

export function placeOf(document: Document, name: string): Vec3 | undefined {
  if (name === lookName) return lookOf(document);
  const index = thingOf(name);
  return index === null ? goalOf(document, name)?.position_m : thingsOf(document)[index]?.position_m;
}

export function withGoal(document: Document, asked: Goal): Document {
  const goal = aboveFloor(document.character, asked);
  const goals = document.goals.map((old) => (old.effector === goal.effector ? goal : old));
  return { ...document, goals: goals.includes(goal) ? goals : [...goals, goal] };
}

export function withThings(document: Document, things: readonly Obstacle[]): Document {
  const { obstacles: _, ...more } = document.settings.more;
  return { ...document, settings: { ...document.settings, more: things.length === 0 ? more : { ...more, obstacles: [...things] } } };
}

export function withThing(document: Document, index: number, change: Partial<Obstacle>): Document {
  const things = [...thingsOf(document)];
  const thing = things[index];
  if (!thing) return document;
  things[index] = { ...thing, ...change };
  return withThings(document, things);
}

/** The thing turned; what stands on the floor stands there still, and nothing goes into it. */
export function withThingTurned(document: Document, index: number, rotation: Quat): Document {
  const thing = thingsOf(document)[index];
  if (!thing) return document;
  const { rotation_xyzw: _, ...rest } = thing;
  const turned: Obstacle = isUnturned(rotation) ? rest : { ...rest, rotation_xyzw: rotation };
  const [x, y, z] = thing.position_m;
  const least = standing(turned);
  const stands = Math.abs(y - standing(thing)) < kOnFloor;
  const things = [...thingsOf(document)];
  things[index] = { ...turned, position_m: [x, stands ? least : Math.max(y, least), z] };
  return withThings(document, things);
}

/** The document with a goal or a thing elsewhere, or turned. */
export function moved(document: Document, name: string, position: Vec3, rotation?: Quat): Document {
  if (name === lookName) return withLook(document, position);
  const index = thingOf(name);
  if (index !== null) return rotation ? withThingTurned(document, index, rotation) : withThing(document, index, { position_m: position });
  const goal: Goal = { ...(goalOf(document, name) ?? { effector: name }), position_m: position };
  if (rotation !== undefined) goal.rotation_xyzw = rotation;
  return withGoal(document, goal);
}

/** How high a thing's middle is where it stands on the floor, m. */
function standing({ size_m = [0, 0, 0], radius_m = 0, rotation_xyzw: [x, y, z, w] = [0, 0, 0, 1] }: Obstacle): number {
  const upward = [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)]; // of its axes
  return radius_m + size_m.reduce((sum, side, k) => sum + Math.abs(upward[k]!) * side, 0) / 2;
}

/** How high a place must be, m. */
export function leastOf(document: Document, name: string): number {
  if (name === lookName) return 0;
  const index = thingOf(name);
  if (index === null) return leastHeight(document.character, name, goalOf(document, name)?.rotation_xyzw);
  const thing = thingsOf(document)[index];
  return thing ? standing(thing) : 0;
}
