// SPDX-License-Identifier: MIT
// Tasks to begin with, each a thing that people do. They are those of an average person and are scaled to the one at hand.
import type { CharacterSpec, Goal, Task, Vec3 } from '../../../bindings/wasm/src/types';
import { documentOf } from './of_task';
import { isRobot, kAverageStature } from './start';
import type { Studio } from './studio';

interface StartTask extends Pick<Task, 'obstacles'> {
  readonly goals: Goal[];
  readonly seat_m?: number;
}

const kTasks = {
  /** A small thing on the floor. */
  pick: { goals: [{ effector: 'right_hand', position_m: [-0.15, 0.12, 0.4] }] },
  /** Onto a shelf at the height of the eyes. */
  shelf: {
    goals: [{ effector: 'right_hand', position_m: [-0.25, 1.62, 0.52] }],
    obstacles: [{ name: 'shelf', position_m: [-0.25, 1.47, 0.62], size_m: [0.9, 0.03, 0.3] }],
  },
  /** A box of 6 kg below the knees, its sides between the palms. */
  box: {
    goals: [
      { effector: 'right_hand', position_m: [-0.2, 0.45, 0.38], axis: { axis: 'palm', direction: 'left' }, load_kg: 3 },
      { effector: 'left_hand', position_m: [0.2, 0.45, 0.38], axis: { axis: 'palm', direction: 'right' }, load_kg: 3 },
    ],
  },
  /** Across a table, on a chair. */
  seated: {
    seat_m: 0.45,
    goals: [{ effector: 'right_hand', position_m: [-0.1, 0.85, 0.75] }],
    obstacles: [{ name: 'table', position_m: [0, 0.7, 0.8], size_m: [1.2, 0.03, 0.6] }],
  },
  /** A lamp above the head. */
  overhead: { goals: [{ effector: 'right_hand', position_m: [-0.15, 2, 0.15] }] },
} satisfies Record<string, StartTask>;

export type StartTaskName = keyof typeof kTasks;

/** Opens a task for the person at hand, or where that is none for the built-in one. */
export async function openStartTask(studio: Studio, name: StartTaskName): Promise<void> {
  const task: StartTask = kTasks[name];
  const now = studio.document?.character;
  const isPerson = now !== undefined && !isRobot(now.description) && now.description.effectors.includes('left_hand');
  const scale = (isPerson ? now.description.stature_m : kAverageStature) / kAverageStature;
  const { seat_m: _, ...spec }: CharacterSpec = isPerson ? now.spec : { source: 'human' };
  const asked: CharacterSpec = task.seat_m === undefined ? spec : { ...spec, seat_m: scale * task.seat_m };
  const stays = isPerson && now.spec.seat_m === asked.seat_m;
  const character = stays ? now : await studio.open(asked, isPerson ? now.bytes : undefined);
  const scaled = (place: Vec3): Vec3 => [scale * place[0], scale * place[1], scale * place[2]];
  const { goals, obstacles }: StartTask = structuredClone(task);
  for (const goal of goals) goal.position_m = scaled(goal.position_m);
  for (const thing of obstacles ?? []) {
    thing.position_m = scaled(thing.position_m);
    thing.size_m = scaled(thing.size_m!);
  }
  await studio.begin(documentOf(studio.facts, character, obstacles ? { goals, obstacles } : { goals }));
}
