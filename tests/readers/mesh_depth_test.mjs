// SPDX-License-Identifier: MIT
// Depths of boxes that are known.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { AnimationClip, BoxGeometry, Group, Mesh, VectorKeyframeTrack } from 'three';
import { depthsOf } from './mesh_depth.mjs';
import { Playback } from './second_reader.mjs';

const kPlaces = {
  hips: [0, 1, 0], head: [0, 1.6, 0], left_shoulder: [0.1, 1.4, 0],
  left_upper_arm: [0.5, 1.4, 0], left_lower_arm: [0.5, 1.1, 0], left_hand: [0.5, 0.8, 0],
  right_upper_arm: [-0.5, 1.4, 0], right_lower_arm: [-0.5, 1.1, 0], right_hand: [-0.5, 0.8, 0],
};
const kLandmarks = { left_wrist: [0.5, 0.8, 0], left_fingertip: [0.5, 0.6, 0], right_wrist: [-0.5, 0.8, 0], right_fingertip: [-0.5, 0.6, 0] };

/** A trunk of 0.4 x 1.7 x 0.2 m and a hand of 0.1 x 0.16 x 0.1 m that moves by `by` from `from`; `change` alters the trunk's node. */
async function depths(by, { from = [0.5, 0.8, 0], change = () => {}, at = 1 } = {}) {
  const root = new Group();
  const nodes = Object.entries(kPlaces).map(([bone, place]) => {
    const node = new Group();
    node.name = bone;
    node.position.fromArray(place).multiplyScalar(at);
    root.add(node);
    return node;
  });
  const node = (bone) => nodes[Object.keys(kPlaces).indexOf(bone)];
  const box = (...size) => new Mesh(new BoxGeometry(...size.map((length) => at * length), 4, 12, 4));
  node('hips').add(box(0.4, 1.7, 0.2));
  node('left_hand').add(box(0.1, 0.16, 0.1));
  change(node, box);
  const way = [...from, ...from.map((value, k) => value + by[k])].map((value) => at * value);
  const times = [0, 1];
  const clip = new AnimationClip('', -1, [new VectorKeyframeTrack('left_hand.position', times, way)]);
  const humanoid = Object.fromEntries(Object.keys(kPlaces).map((bone) => [bone, bone]));
  const body = { stature_m: 1.7, humanoid, nodes: Object.keys(kPlaces).map((name, file_node) => ({ name, file_node })) };
  return depthsOf(new Playback(root, { getDependency: async (_, i) => nodes[i] }, clip), body, kLandmarks, 1 / at);
}
const millimetres = ({ depth }) => Math.round(1e3 * depth);

test('a hand that stays outside has no depth', async () => {
  const found = await depths([-0.2, 0, 0]);
  assert.equal(millimetres(found.deepest), 0);
});

test('a hand in the trunk is as deep as its deepest corner', async () => {
  // its inner side goes to 0.13 m, the trunk's to 0.2
  const found = await depths([-0.32, 0, 0]);
  assert.equal(millimetres(found.deeper), 70);
  assert.equal(found.deeper.part, 'left_hand');
  assert.equal(found.deeper.within, 'hips');
  assert.equal(found.deeper.frame, 1);
});

test('a hand that begins inside is deeper by what it goes on', async () => {
  const found = await depths([-0.02, 0, 0], { from: [0.2, 0.8, 0] });
  assert.deepEqual([found.start, found.deepest, found.deeper].map(millimetres), [50, 70, 20]);
});

test('a trunk with a hole has an inside', async () => {
  // its top follows its two sides, six corners a cell
  const change = (node) => node('hips').children[0].geometry.index.array.fill(0, 6 * 2 * 4 * 12, 6 * (2 * 4 * 12 + 4 * 4));
  assert.equal(millimetres((await depths([-0.32, 0, 0], { change })).deeper), 70);
});

test('a hand under clothes is as deep as these', async () => {
  const found = await depths([-0.32, 0, 0], { change: (node, box) => node('hips').add(box(0.36, 1.6, 0.16)) });
  assert.equal(millimetres(found.deeper), 70);
});

test('what grows from the clavicle is skin without an inside', async () => {
  const wide = (size) => ({ change: (node, box) => node('left_shoulder').add(box(size, 1.7, 0.2)) });
  // to 0.22 m, so that the hand is in it alone; to 0.18 m, nearer than the trunk's side
  assert.equal(millimetres((await depths([-0.24, 0, 0], wide(0.24))).deeper), 0);
  assert.equal(millimetres((await depths([-0.32, 0, 0], wide(0.16))).deeper), 50);
});

test('what a hand holds is not of the arm', async () => {
  const sword = (node, box) => {
    node('left_hand').add(box(0.02, 0.9, 0.02));
    node('left_hand').children[1].position.set(-0.35, 0, 0);
  };
  assert.equal(millimetres((await depths([0, 0, 0], { change: sword })).deepest), 0);
});

test('a file in centimetres is measured in metres', async () => {
  assert.equal(millimetres((await depths([-0.32, 0, 0], { at: 100 })).deeper), 70);
});

test('a figure of another size than its summary tells is not measured', async () => {
  const shrunk = (node) => node('hips').scale.setScalar(0.01);
  assert.equal(await depths([-0.32, 0, 0], { change: shrunk }), null);
});
