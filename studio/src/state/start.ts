// SPDX-License-Identifier: MIT
// The initial task of a body.
import type { Character, CharacterDescription, Facts, Goal, Vec3 } from '../../../bindings/wasm/src/types';
import { mixtureOf } from './criteria';
import type { Document } from './model';

/** A low reach across the body, of an average person: one that people do in several ways. */
const kFirstReach: Vec3 = [0.25, 0.55, 0.5];
export const kAverageStature = 1.741; // m

/** Effectors with a handle, where a body has them. */
export const handleEffectors = ['right_hand', 'left_hand', 'head', 'right_foot', 'left_foot'] as const;

/** A robot's joints are its file's. */
export const isRobot = ({ joints }: CharacterDescription): boolean => joints.some((joint) => joint.file_joint !== undefined);

export function effectorsOf(character: Character): string[] {
  const { effectors, places } = character.description;
  const named = new Set([...effectors, ...places.map((place) => place.effector)]);
  // the foot that the body stands on has no place of its own, and can be asked to lift all the same
  if (named.has('left_foot')) named.add('right_foot');
  const known = handleEffectors.filter((name) => named.has(name));
  return [...known, ...effectors.filter((name) => !(known as string[]).includes(name))];
}

/** Joints that goals are asked for now and then, where a body has them. */
const kJoints = ['hips', 'chest', 'right_elbow', 'left_elbow', 'right_knee', 'left_knee'];

export function jointsOf({ description }: Character): string[] {
  const named = new Set(description.places.map(({ effector }) => effector));
  return isRobot(description) ? [] : kJoints.filter((name) => named.has(name));
}

/** Where an effector is before the motion, m. */
export function startOf(character: Character, effector: string): Vec3 {
  const of = (name: string): Vec3 | undefined => character.description.places.find((p) => p.effector === name)?.start_m;
  const place = of(effector);
  if (place) return [...place];
  const other = effector === 'right_foot' ? of('left_foot') : undefined;
  return other ? [-other[0], other[1], other[2]] : [0, character.description.stature_m / 2, 0.2];
}

function firstGoal(character: Character): Goal {
  const effector = effectorsOf(character)[0] ?? 'right_hand';
  const scale = character.description.stature_m / kAverageStature;
  const side = effector.startsWith('left') ? -1 : 1;
  if (!effector.endsWith('hand')) {
    const [x, y, z] = startOf(character, effector);
    return { effector, position_m: [x, y, z + 0.1 * scale] };
  }
  return { effector, position_m: [side * kFirstReach[0] * scale, kFirstReach[1] * scale, kFirstReach[2] * scale] };
}

export function newDocument(facts: Facts, character: Character, goals?: readonly Goal[]): Document {
  return {
    character,
    goals: goals ?? [firstGoal(character)],
    weights: { ...mixtureOf(facts, {}) },
    fixed: [],
    settings: { preset: facts.default_preset, seed: 0, evaluations: null, duration_s: null, more: {} },
    result: null,
    chosen: 0,
    compared: null,
    edits: {},
  };
}
