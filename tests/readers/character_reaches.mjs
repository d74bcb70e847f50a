// SPDX-License-Identifier: MIT
// character_reaches.mjs FILE FOLDER: reaches of five kinds by a character, scaled by its stature, into FOLDER/GOAL; prints what became
// of each as a line of JSON. Nothing of a file that is read as no person's.
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { describe, meshDepth, program } from './mesh_depth.mjs';

const kStature = 1.741; // m, the built-in person's, that the goals are for
const kGoals = {
  'low left': { right_hand: [0.25, 0.4, 0.35] },
  table: { right_hand: [-0.2, 1.05, 0.45] },
  high: { right_hand: [-0.2, 1.8, 0.3] },
  'pick-up': { right_hand: [-0.15, 0.12, 0.4] },
  'both low': { right_hand: [-0.2, 0.4, 0.4], left_hand: [0.2, 0.4, 0.4] },
};

/** The summary of a character's reach; null where the program refuses it. */
function reach(character, goals, scale, folder, formats) {
  const words = Object.entries(goals).flatMap(([hand, place]) => ['--goal', `${hand}=${place.map((value) => (value * scale).toFixed(5))}`]);
  const options = ['--formats', formats, '--threads', '1', '--out', folder];
  const { status } = spawnSync(program, ['reach', ...character, ...words, ...options]);
  // 3: out of reach, or no motion that the body could make
  return [0, 3].includes(status) ? JSON.parse(readFileSync(join(folder, 'summary.json'))) : null;
}

const millimetres = (found) => Math.round(1e3 * found.depth);

async function row(file, folder) {
  let body;
  try {
    body = describe(file);
  } catch {
    return null;
  }
  const scale = body.stature_m / kStature;
  const goals = {};
  for (const [name, hands] of Object.entries(kGoals)) {
    const at = join(folder, name.replaceAll(' ', '-'));
    const summary = reach(['--character', file], hands, scale, at, 'glb');
    const found = summary?.candidates ?? [];
    // a tall person takes longer than a small one: the shorter of the built-in one's and of one as tall
    const built = [[], ['--stature', String(body.stature_m)]].map((options, k) =>
      reach(['--character', 'human', ...options], hands, k ? scale : 1, `${at}-human`, 'csv').candidates[0].duration_s);
    const depth = found.length && await meshDepth(at, body);
    goals[name] = {
      verdicts: found.map(({ verdict }) => verdict[0]).join(''),
      met: summary?.remaining_mm < 1,
      longer: found.length ? found[0].duration_s / Math.min(...built) : 0,
      ...(depth && { deepest_mm: millimetres(depth.deepest), deeper_mm: millimetres(depth.deeper) }),
    };
  }
  return { file: basename(file), goals };
}

const [file, folder] = process.argv.slice(2);
const made = await row(file, folder);
if (made) console.log(JSON.stringify(made));
