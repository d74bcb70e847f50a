// SPDX-License-Identifier: MIT
// check_result.mjs FOLDER CHARACTER: judges the BVH, GLB and VRMA files of a result by other people's
// readers, and prints a line for each; fails where one breaks a promise.
// A built-in body has no file, and the CHARACTER is its name: its mannequin has the joints of the BVH in each frame.
//
// - hips, knees, ankles, shoulders, elbows and wrists are within 1 mm or 0.1 % of the stature of the start posture, in the first frame
// - the goal is within 1 mm of the node that the summary names, in the last frame
// - the feet slide by 1 mm and turn by 0.1° at most, in any frame
// - each vertex stands where it stands in the character's file while nothing is played
// - Khronos' validator finds no error, and no warning that the character's file has not
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import validator from 'gltf-validator';
import { Vector3 } from 'three';
import { byBlender, byThree } from './bvh_readers.mjs';
import { describe } from './mesh_depth.mjs';
import { openGlb, openVrma, place, turn, vertices } from './second_reader.mjs';

const [folder, character] = process.argv.slice(2);
const summary = JSON.parse(await readFile(join(folder, 'summary.json'), 'utf8'));
const failures = [];
const expect = (holds, text) => {
  if (!holds) failures.push(text);
};

const body = describe(character);
const kBones = {
  hip: 'upper_leg', knee: 'lower_leg', ankle: 'foot', shoulder: 'upper_arm', elbow: 'lower_arm', wrist: 'hand',
};

// A place of a file in the world that goals are given in; a mirrored file keeps its own axes.
function inWorld(at, unit_m) {
  if (!body.placement) return at.clone().multiplyScalar(unit_m); // a built-in body
  const { left, up, ahead, origin } = body.placement;
  const axes = [left, up, ahead].map((axis) => new Vector3(...axis));
  const mirrored = axes[0].clone().cross(axes[1]).dot(axes[2]) < 0;
  if (!mirrored) return at.clone().multiplyScalar(unit_m);
  const off = at.clone().multiplyScalar(unit_m / body.placement.unit_m).sub(new Vector3(...origin));
  return new Vector3(...axes.map((axis) => axis.dot(off))).multiplyScalar(body.placement.unit_m);
}

// `placeOf`: of a bone of the body, in the file's unit; undefined where the file has none.
async function checkStart(kind, name, placeOf, unit_m) {
  const landmarks = summary.task.character.landmarks_m;
  if (!landmarks) return;
  const allowed = Math.max(1e-3, 1e-3 * body.stature_m);
  let worst = 0;
  let joints = 0;
  for (const side of ['left', 'right']) {
    for (const [joint, bone] of Object.entries(kBones)) {
      const at = await placeOf(`${side}_${bone}`);
      if (!at) continue;
      ++joints;
      const off = inWorld(at, unit_m).distanceTo(new Vector3(...landmarks[`${side}_${joint}`]));
      worst = Math.max(worst, off);
      expect(off <= allowed, `${name}: the ${side} ${joint} begins ${1e3 * off} mm off by ${kind}`);
    }
  }
  expect(joints > 0, `${name}: no joint of the start is there by ${kind}`);
  console.log(`${kind} ${name}: begins ${(1e3 * worst).toFixed(4)} mm off`);
}

function checkGoals(kind, name, candidate, placeOf, unit_m) {
  expect(candidate.reached.length > 0, `${name}: no goal to look at`);
  for (const goal of candidate.reached) {
    const at = placeOf(goal.joint);
    const off = at ? inWorld(at, unit_m).distanceTo(new Vector3(...goal.reached_m)) : Infinity;
    console.log(`${kind} ${name}: ends ${(1e3 * off).toFixed(4)} mm off`);
    expect(off <= 1e-3, `${name}: ${goal.joint} ends ${1e3 * off} mm off by ${kind}`);
  }
}

// BVH has one word for a name.
const ofBvh = (name) => name.trim().replaceAll(' ', '_');

async function checkBvh(name, candidate) {
  const text = await readFile(join(folder, name), 'utf8');
  for (const [kind, reader] of Object.entries({ three: byThree(text), blender: byBlender(text) })) {
    const first = reader(0);
    await checkStart(kind, name, (bone) => first.get(ofBvh(body.humanoid[bone] ?? '')), candidate.bvh_unit_m);
    const last = reader(candidate.file_frames - 1);
    checkGoals(kind, name, candidate, (joint) => last.get(ofBvh(joint)), candidate.bvh_unit_m);
  }
}

// The node of a GLB, whose first ones are the body's where the body has no file.
const nodeOf = ({ gltf_node, joint }) => gltf_node ?? body.nodes.findIndex(({ name }) => name === joint);

async function checkMannequin(name, candidate, motion) {
  const bvh = byThree(await readFile(join(folder, candidate.files.bvh), 'utf8'));
  let worst = 0;
  for (let f = 0; f < motion.frames; ++f) {
    const joints = bvh(f);
    motion.at(f);
    for (const [i, node] of body.nodes.entries()) {
      if (node.name === '') continue;
      const off = place(await motion.node(i)).distanceTo(joints.get(node.name).multiplyScalar(candidate.bvh_unit_m));
      worst = Math.max(worst, off);
    }
  }
  console.log(`glb ${name}: joints ${(1e3 * worst).toFixed(4)} mm off those of the BVH`);
  expect(worst <= 1e-3, `${name}: a joint is ${1e3 * worst} mm off that of the BVH`);
  const heights = motion.vertices().filter((_, i) => i % 3 === 1);
  const lowest = heights.reduce((least, y) => Math.min(least, y), Infinity);
  expect(Math.abs(lowest) <= 0.02, `${name}: the skin ends ${lowest} m above the floor`);
}

async function checkMotion(kind, name, motion, candidate, unit_m = 1) {
  let miss = 0;
  motion.at(0);
  await checkStart(kind, name, async (bone) => {
    const node = body.nodes.find((each) => each.name === body.humanoid[bone]);
    return node?.file_node >= 0 && place(await motion.node(node.file_node));
  }, unit_m);
  motion.at(motion.frames - 1);
  for (const goal of candidate.reached) {
    const hand = inWorld(place(await motion.node(nodeOf(goal))), unit_m);
    miss = Math.max(miss, hand.distanceTo(new Vector3(...goal.goal_m)));
  }
  const feet = await Promise.all(candidate.contacts.map((c) => motion.node(nodeOf(c))));
  motion.at(0);
  expect(candidate.reached.length > 0, `${name}: no goal to look at`);
  expect(feet.length > 0, `${name}: no foot to look at`);
  const first = feet.map((foot) => [place(foot), turn(foot)]);
  let slide = 0;
  let tilt = 0;
  for (let f = 0; f < motion.frames; ++f) {
    motion.at(f);
    feet.forEach((foot, i) => {
      slide = Math.max(slide, unit_m * place(foot).distanceTo(first[i][0]));
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

const isGltf = /\.(glb|vrm|gltf)$/.test(character);
const known = isGltf ? await issues(character) : new Map();
const still = isGltf ? await vertices(character) : [];
expect(summary.candidates.length > 0, 'there is no candidate');
for (const candidate of summary.candidates) {
  const { bvh, glb, vrma } = candidate.files;
  expect(bvh || glb || vrma, 'a candidate has no file that is looked at');
  if (bvh) await checkBvh(bvh, candidate);
  if (glb) {
    const path = join(folder, glb);
    const motion = await openGlb(path, candidate.glb_animation);
    await checkMotion('glb', glb, motion, candidate, candidate.glb_unit_m);
    await checkValid(path, known);
    if (!summary.task.character.landmarks_m) {
      await checkMannequin(glb, candidate, motion);
      continue;
    }
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
