// SPDX-License-Identifier: MIT
// mesh_depth.mjs [--all] FOLDER…: how deep a character's arms are in its body, by the mesh of a result's first motion, or of all,
// as three.js plays its GLB; a line for each. `shigusa body` tells the bones: SHIGUSA_BINARY, else build/gcc's.
//
// A vertex is an arm's where the joint that it follows most is of upper arm, forearm, hand or fingers, but for the part of the
// upper arm that grows out of the trunk, and for what a hand holds. The body is all triangles but those of that arm and its
// clavicle, so the other arm too. A vertex inside is as deep as the nearest triangle is far, of the clavicle too, that is no
// inner layer.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Vector3 } from 'three';
import { openGlb, place } from './second_reader.mjs';
import { TriangleTree } from './triangle_tree.mjs';

const kFrames = 14; // that are looked at: the first, the last and some on the way
const kOfTrunk = 0.45; // share of an upper arm, from the shoulder
const kStep = 1e-3; // m, from a triangle to its sides
const kOfHand = 1.3; // hands' lengths from the wrist: what reaches further is held

export const program = process.env.SHIGUSA_BINARY ?? fileURLToPath(new URL('../../build/gcc/bin/shigusa', import.meta.url));

/** What `shigusa body FILE --json` tells. */
export function describe(file) {
  return JSON.parse(execFileSync(program, ['body', file, '--json'], { maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'ignore'] }));
}

/** The depths of a motion of a result; null where no mesh leaves, or not at the character's size. */
export async function meshDepth(folder, body, rank = 1) {
  const summary = JSON.parse(readFileSync(join(folder, 'summary.json')));
  const candidate = summary.candidates[rank - 1];
  if (!candidate?.files.glb) return null;
  const motion = await openGlb(join(folder, candidate.files.glb), candidate.glb_animation);
  return depthsOf(motion, body, summary.task.character.landmarks_m, candidate.glb_unit_m);
}

/**
 * The deepest vertices in the first frame (`start`), in any (`deepest`), and in any beyond where the same vertex began (`deeper`):
 * each { depth (m), part, within, frame, at (m) }.
 */
export async function depthsOf(motion, body, landmarks, unit_m) {
  motion.at(0);
  const mesh = await readMesh(motion, body, unit_m);
  mesh.pose();
  if (!isAsTall(mesh.points, body.stature_m)) return null;
  const arms = ['left', 'right'].map((side) => armOf(mesh, side, landmarks));
  const none = { depth: 0, part: '', within: '', frame: 0, at: [] };
  const found = { start: none, deepest: none, deeper: none, frames: motion.frames };
  const share = (motion.frames - 1) / (kFrames - 1);
  for (const frame of new Set(Array.from({ length: kFrames }, (_, k) => Math.round(k * share)))) {
    motion.at(frame);
    mesh.pose();
    for (const arm of arms) look(mesh, arm, frame, found);
  }
  return found;
}

/** Vertices (m, as posed) and triangles, each vertex with the bone and the node that it follows most. */
async function readMesh(motion, body, unit_m) {
  const nodeOf = (bone) => body.nodes.find(({ name }) => name === body.humanoid[bone]);
  const bones = Object.keys(body.humanoid).filter((bone) => nodeOf(bone)?.file_node >= 0); // a hand may be none of the file's
  const nodes = await Promise.all(bones.map((bone) => motion.node(nodeOf(bone).file_node)));
  const boneOf = (node) => node && (bones[nodes.indexOf(node)] ?? boneOf(node.parent));
  const placeOf = (bone) => bones.includes(bone) && place(nodes[bones.indexOf(bone)]).multiplyScalar(unit_m);
  const mesh = { meshes: [], bones: [], joints: [], corners: [], placeOf };
  motion.root.traverse((part) => {
    // what is not skinned and hangs on no bone is a thing beside the character
    if (part.isMesh && (part.isSkinnedMesh || boneOf(part))) addPart(mesh, part, boneOf);
  });
  mesh.points = new Float64Array(3 * mesh.bones.length);
  const at = new Vector3();
  mesh.pose = () => {
    let end = 0;
    for (const part of mesh.meshes) {
      part.skeleton?.update();
      for (let i = 0; i < part.geometry.attributes.position.count; ++i, end += 3) {
        part.getVertexPosition(i, at).applyMatrix4(part.matrixWorld).multiplyScalar(unit_m).toArray(mesh.points, end);
      }
    }
  };
  return mesh;
}

function addPart(mesh, part, boneOf) {
  const joints = part.isSkinnedMesh ? part.skeleton.bones : [part];
  const bones = joints.map((joint) => boneOf(joint) ?? 'hips');
  const { position, skinIndex, skinWeight } = part.geometry.attributes;
  const first = mesh.bones.length;
  const index = part.geometry.index;
  for (let i = 0; i < (index ?? position).count; ++i) mesh.corners.push(first + (index ? index.getX(i) : i));
  for (let i = 0; i < position.count; ++i) {
    const weights = part.isSkinnedMesh ? [0, 1, 2, 3].map((k) => skinWeight.getComponent(i, k)) : [];
    const joint = part.isSkinnedMesh ? skinIndex.getComponent(i, weights.indexOf(Math.max(...weights))) : 0;
    mesh.bones.push(bones[joint]);
    mesh.joints.push(joints[joint]);
  }
  mesh.meshes.push(part);
}

const pointOf = (points, v) => new Vector3().fromArray(points, 3 * v);

/** Whether the mesh is played in the unit that the summary tells; ears and hats have room. */
function isAsTall(points, stature) {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 1; i < points.length; i += 3) {
    low = Math.min(low, points[i]);
    high = Math.max(high, points[i]);
  }
  return high - low > 0.6 * stature && high - low < 1.8 * stature;
}

/** An arm as it begins: its vertices with their depths, and a tree of the body beside it. */
function armOf(mesh, side, landmarks) {
  const arm = ['upper_arm', 'lower_arm', 'hand'].map((bone) => `${side}_${bone}`);
  const [shoulder, elbow, wrist] = arm.map(mesh.placeOf);
  const upper = elbow.clone().sub(shoulder);
  const hand = new Vector3(...landmarks[`${side}_wrist`]).distanceTo(new Vector3(...landmarks[`${side}_fingertip`]));
  const held = new Set();
  const all = mesh.bones.flatMap((bone, v) => (arm.includes(bone) ? [v] : []));
  for (const v of all) {
    if (mesh.bones[v] === arm[2] && pointOf(mesh.points, v).distanceTo(wrist) > kOfHand * hand) held.add(mesh.joints[v]);
  }
  const seen = new Set(); // a vertex at a seam is there twice
  const isNew = (v) => seen.size < seen.add(mesh.points.subarray(3 * v, 3 * v + 3).join()).size;
  const vertices = all.filter((v) => !held.has(mesh.joints[v]) && isNew(v) &&
    (mesh.bones[v] !== arm[0] || pointOf(mesh.points, v).sub(shoulder).dot(upper) > kOfTrunk * upper.lengthSq()));
  const [body, skin] = [[...arm, `${side}_shoulder`], arm].map((without) => trianglesOf(mesh, new Set(without)));
  return {
    vertices, skin, clavicle: `${side}_shoulder`, tree: new TriangleTree(mesh.points, body), skinTree: new TriangleTree(mesh.points, skin),
    began: new Float64Array(vertices.length),
  };
}

/** Those with no corner on these bones. */
function trianglesOf(mesh, without) {
  const found = [];
  for (let i = 0; i < mesh.corners.length; i += 3) {
    const triangle = mesh.corners.slice(i, i + 3);
    if (triangle.every((v) => !without.has(mesh.bones[v]))) found.push(...triangle);
  }
  return found;
}

/** Finds the deepest vertices of an arm in a frame. */
function look(mesh, arm, frame, found) {
  arm.tree.move(mesh.points);
  arm.skinTree.move(mesh.points);
  const isInside = (at) => Math.abs(arm.tree.winding(...at)) > 0.5;
  const known = new Map();
  const isOuter = (t) => {
    if (!known.has(t)) known.set(t, isOuterTriangle(mesh, arm.skin.slice(3 * t, 3 * t + 3), arm.clavicle, isInside));
    return known.get(t);
  };
  arm.vertices.forEach((v, i) => {
    const at = mesh.points.subarray(3 * v, 3 * v + 3);
    if (!isInside(at)) return;
    const { distance, triangle } = arm.skinTree.nearest(...at, isOuter);
    if (triangle < 0) return;
    if (frame === 0) arm.began[i] = distance;
    const depths = { deepest: distance, ...(frame === 0 ? { start: distance } : { deeper: distance - arm.began[i] }) };
    for (const [kind, depth] of Object.entries(depths)) {
      if (depth > found[kind].depth) found[kind] = { depth, part: mesh.bones[v], within: mesh.bones[arm.skin[3 * triangle]], frame, at: [...at] };
    }
  });
}

/** Whether one side of a triangle is inside and the other is not; clothes lie in layers. */
function isOuterTriangle(mesh, corners, clavicle, isInside) {
  if (corners.some((v) => mesh.bones[v] === clavicle)) return true;
  const [a, b, c] = corners.map((v) => pointOf(mesh.points, v));
  const middle = a.clone().add(b).add(c).divideScalar(3);
  const step = b.sub(a).cross(c.sub(a)).setLength(kStep);
  return isInside(middle.clone().add(step).toArray()) !== isInside(middle.sub(step).toArray());
}

const words = ({ depth, part, within, frame }) =>
  depth > 0 ? `${(1e3 * depth).toFixed(1)} mm, ${part} in ${within}, frame ${frame}` : '0 mm';

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const folders = process.argv.slice(2).filter((word) => word !== '--all');
  for (const folder of folders) {
    const summary = JSON.parse(readFileSync(join(folder, 'summary.json')));
    const body = describe(resolve(folder, summary.character_file));
    const ranks = process.argv.includes('--all') ? summary.candidates.map(({ rank }) => rank) : [1];
    for (const rank of ranks) {
      const depth = await meshDepth(folder, body, rank);
      console.log(`${folder} ${rank}: ` + (depth ? `deeper ${words(depth.deeper)} of ${depth.frames - 1}; ` +
        `in all ${words(depth.deepest)}; at the start ${words(depth.start)}` : 'no mesh of the character\'s size'));
    }
  }
}
