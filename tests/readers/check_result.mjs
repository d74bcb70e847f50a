// SPDX-License-Identifier: MIT
// check_result.mjs FOLDER CHARACTER: judges the GLB and VRMA files of a result by other people's
// readers, and prints a line for each; fails where one breaks a promise.
//
// - the goal is within 1 mm of the node that the summary names, in the last frame
// - the feet slide by 1 mm and turn by 0.1° at most, in any frame
// - each vertex stands where it stands in the character's file while nothing is played
// - Khronos' validator finds no error, and no warning that the character's file has not
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import validator from 'gltf-validator';
import { openGlb, openVrma, place, turn, vertices } from './second_reader.mjs';

const [folder, character] = process.argv.slice(2);
const summary = JSON.parse(await readFile(join(folder, 'summary.json'), 'utf8'));
const failures = [];
const expect = (holds, text) => {
  if (!holds) failures.push(text);
};

async function checkMotion(kind, name, motion, candidate) {
  let miss = 0;
  motion.at(motion.frames - 1);
  for (const goal of candidate.reached) {
    const hand = await motion.node(goal.gltf_node);
    const [x, y, z] = place(hand).toArray();
    const [gx, gy, gz] = goal.goal_m;
    miss = Math.max(miss, Math.hypot(x - gx, y - gy, z - gz));
  }
  const feet = await Promise.all(candidate.contacts.map((c) => motion.node(c.gltf_node)));
  motion.at(0);
  const first = feet.map((foot) => [place(foot), turn(foot)]);
  let slide = 0;
  let tilt = 0;
  for (let f = 0; f < motion.frames; ++f) {
    motion.at(f);
    feet.forEach((foot, i) => {
      slide = Math.max(slide, place(foot).distanceTo(first[i][0]));
      tilt = Math.max(tilt, turn(foot).angleTo(first[i][1]));
    });
  }
  const degrees = (tilt * 180) / Math.PI;
  console.log(`${kind} ${name}: goal ${(1e3 * miss).toFixed(4)} mm, feet ${(1e3 * slide).toFixed(4)} mm ` +
    `${degrees.toFixed(4)} deg, ${motion.frames} frames`);
  expect(motion.frames === candidate.file_frames, `${name}: ${motion.frames} frames of ${candidate.file_frames}`);
  const allowed = summary.status === 'reached' ? 1e-3 : Infinity;
  expect(miss <= allowed, `${name}: the goal is missed by ${1e3 * miss} mm`);
  expect(slide <= 1e-3, `${name}: a foot slides by ${1e3 * slide} mm`);
  expect(degrees <= 0.1, `${name}: a foot turns by ${degrees} degrees`);
}

async function issues(path) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(path)), {
    ignoredIssues: [], maxIssues: 0,
  });
  const counts = new Map();
  for (const { code, severity } of report.issues.messages) {
    if (severity > 1) continue;  // hints
    const key = `${severity === 0 ? 'error' : 'warning'} ${code}`;
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  return counts;
}

async function checkValid(path, known) {
  for (const [issue, count] of await issues(path)) {
    expect(count <= (known.get(issue) ?? 0), `${path}: ${count} times ${issue}`);
  }
}

const known = await issues(character);
const still = await vertices(character);
for (const candidate of summary.candidates) {
  const { glb, vrma } = candidate.files;
  if (glb) {
    const path = join(folder, glb);
    await checkMotion('glb', glb, await openGlb(path, candidate.glb_animation), candidate);
    await checkValid(path, known);
    const now = await vertices(path);
    expect(now.length === still.length, `${glb}: ${now.length / 3} vertices of ${still.length / 3}`);
    const off = now.reduce((most, v, i) => Math.max(most, Math.abs(v - still[i])), 0);
    console.log(`glb ${glb}: ${now.length / 3} vertices at rest, off by ${off}`);
    // matrices that became translation, rotation and scale are composed again by the reader
    expect(off <= 1e-6, `${glb}: a vertex is off by ${off}`);
  }
  if (vrma) {
    const path = join(folder, vrma);
    await checkMotion('vrma', vrma, await openVrma(character, path), candidate);
    await checkValid(path, new Map());
  }
}
for (const text of failures) console.error(`check_result: ${text}`);
process.exit(failures.length ? 1 : 0);
