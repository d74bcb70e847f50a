// SPDX-License-Identifier: MIT
import { readFile } from 'node:fs/promises';
import { openDoor } from '../dist/door.js';

export const wasmBytes = await readFile(new URL('../dist/module/shigusa.wasm', import.meta.url));
export const starts = await readFile(new URL('../dist/module/starts.tsv', import.meta.url));

export const openedDoor = () => openDoor(wasmBytes, starts);

/** A small search that is over in no time. */
export const smallTask = {
  goals: [{ effector: 'right_hand', position_m: [-0.25, 0.55, 0.5] }],
  seed: 1,
  evaluations: 500,
};

export const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
