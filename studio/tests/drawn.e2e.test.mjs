// SPDX-License-Identifier: MIT
// Characters are drawn where they are computed, packed ones too, and where one cannot be the page says so.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { endOfNode, parseGlb } from './glb.mjs';
import { glbOf, packedByDraco, packedByMeshopt } from './packed.mjs';
import { drawn as pictured, drop, openStudio, openTab, settled, state, take, visit } from './support.mjs';

const folder = fileURLToPath(new URL('../../../shared/characters/', import.meta.url));
const options = { skip: !existsSync(folder) && 'no characters here', timeout: 600_000 };
/** Files that no person can be read from. */
const kOdd = /IndexOutOfRange|invalid-buffer|fuzz|simple_skin|Acrobot|\.tsv$/;
/** Whose right arm ends before the hand, or who have a rod for it: no node can be drawn there. */
const kHandless = /godot_platformer|BrainStem/;
const kSix = ['RobotExpressive.glb', 'Geno.fbx', 'VRM-Addon-for-Blender__basic_armature.vrm', 'makehuman_tpose.bvh', 'Quaternius_Character_HumanoidRig.glb'];

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url, { seen: true });
await settled(page);

const read = (name) => readFileSync(`${folder}${name}`);
const distance = (a, b) => Math.hypot(...a.map((value, k) => value - b[k]));

async function open(name, bytes) {
  await drop(page, name, bytes);
  await page.waitForFunction((file) => window.shigusa.document.character.spec.source === file || window.shigusa.state.notice?.kind === 'failure', name, { timeout: 60_000 });
  await settled(page);
  assert.equal((await state(page)).notice?.failure?.message, undefined, name);
}

/** How far the hand is drawn from where the engine has it, m, at a share of the first motion; null where it has no node. */
async function apart(share) {
  await page.locator('.scrub').evaluate((range, value) => {
    range.value = String(1000 * value);
    range.dispatchEvent(new Event('input', { bubbles: true }));
  }, share);
  await pictured(page);
  const { drawn, computed } = await page.evaluate((end) => {
    const { document: d, chosen } = window.shigusa;
    const { effectors: { values, columns, frames } } = d.result.candidates[chosen].series;
    const first = end ? (frames - 1) * columns : 0;
    return { drawn: window.shigusa.drawn('right_hand'), computed: [...values.slice(first, first + 3)] };
  }, share === 1);
  return drawn && distance(drawn, computed);
}

async function isDrawnAsComputed(name) {
  for (const share of [1, 0]) {
    const off = await apart(share);
    assert.equal(off === null, kHandless.test(name), name);
    assert.ok(off < 2e-3, `${name}: ${off} m off at ${share}`);
  }
  const { figure: { low, high }, stature } = await page.evaluate(() => ({ figure: window.shigusa.figure(), stature: window.shigusa.document.character.description.stature_m }));
  assert.ok(low > -0.1 * stature && high > 0.5 * stature && high < 1.6 * stature, `${name}: ${low} to ${high} m of ${stature}`);
  assert.equal(await page.evaluate(() => window.shigusa.state.undrawn), null, name);
  const { status, goals } = await state(page);
  assert.notEqual(status, 'unreachable', name);
  assert.ok(distance(await page.evaluate(() => window.shigusa.hand()), goals[0].position_m) < 2e-3, name);
}

test('characters are drawn where they are computed, and reach', options, async () => {
  const all = process.env.SHIGUSA_LONG ? readdirSync(folder).filter((name) => !kOdd.test(name)).sort() : kSix;
  for (const name of all) {
    await open(name, read(name));
    await isDrawnAsComputed(name);
    if (name !== 'makehuman_tpose.bvh') continue;
    // in decimetres, which the GLB that the page draws must have
    const saved = parseGlb(await take(page, 'glb'));
    const { joint, hand } = await page.evaluate(() => ({ joint: window.shigusa.document.result.candidates[window.shigusa.chosen].summary.reached[0].joint, hand: window.shigusa.hand() }));
    assert.ok(distance(endOfNode(saved, joint), hand) < 2e-3);
  }
  assert.deepEqual(errors, []);
});

const corpora = fileURLToPath(new URL('../../tests/fuzz/', import.meta.url));

test('files that fuzzing starts from are drawn or told of', { skip: !process.env.SHIGUSA_LONG && 'in the night', timeout: 1_800_000 }, async () => {
  const files = ['bvh', 'fbx', 'gltf', 'urdf', 'mjcf'].flatMap((kind) => readdirSync(`${corpora}${kind}_corpus`).map((name) => [kind, name]));
  for (const [kind, name] of files) {
    const unlike = `${kind}_${name}`; // each its own
    await drop(page, unlike, readFileSync(`${corpora}${kind}_corpus/${name}`));
    const ended = (file) => window.shigusa.state.opening === null && (window.shigusa.document.character.spec.source === file || window.shigusa.state.notice !== null);
    await page.waitForFunction(ended, unlike, { timeout: 60_000 }).catch((error) => assert.fail(`${unlike}: ${error.message}`));
    await settled(page);
    // what three says of a file that leaves out what the standard asks for is true
    assert.deepEqual(errors.filter((text) => !text.startsWith('THREE.GLTFLoader: Missing')), [], unlike);
  }
});

/** The same with another JSON part, with other bytes or with more behind them. */
function changed(bytes, change, ...more) {
  const { json, binary, view } = parseGlb(bytes);
  const whole = Buffer.from(Buffer.from(view.buffer, view.byteOffset + binary, json.buffers[0].byteLength));
  change(json, whole);
  return glbOf(json, [whole, ...more]);
}

/** Legs so short that nobody can tell which way a thigh lies. */
const shortLegs = () => `${read('pybvh__standard_skeleton.bvh')}`.replaceAll('-15.160000', '-0.95').replaceAll('-14.980000', '-4.6').replace(/3\.500000/, '20');

/** In its first animation the armature is half as large as at rest. */
function halved() {
  const key = Buffer.from(Float32Array.of(50, 50, 50, 0).buffer); // a scale and its time
  return changed(read('RobotExpressive.glb'), ({ accessors, animations, bufferViews, nodes, buffers }) => {
    bufferViews.push({ buffer: 0, byteOffset: buffers[0].byteLength, byteLength: key.length });
    accessors.push({ bufferView: bufferViews.length - 1, componentType: 5126, type: 'VEC3', count: 1 });
    accessors.push({ bufferView: bufferViews.length - 1, byteOffset: 12, componentType: 5126, type: 'SCALAR', count: 1, min: [0], max: [0] });
    const { channels, samplers } = animations[0];
    const sampler = samplers.push({ input: accessors.length - 1, output: accessors.length - 2 }) - 1;
    channels.push({ sampler, target: { node: nodes.findIndex(({ name }) => name === 'RobotArmature'), path: 'scale' } });
  }, key);
}

test('limbs of next to no length, and scales that a frame changes, are drawn too', options, async () => {
  await open('short.bvh', shortLegs());
  await isDrawnAsComputed('short.bvh');
  await open('halved.glb', halved());
  await openTab(page, 'body');
  await page.locator('[data-key="start posture"]').selectOption({ index: 2 });
  await page.waitForFunction(() => window.shigusa.document.character.spec.animation !== undefined, undefined, { timeout: 30_000 });
  await settled(page);
  assert.equal(await page.evaluate(() => window.shigusa.document.character.description.nodes.find(({ name }) => name === 'RobotArmature').scale[0]), 50);
  await isDrawnAsComputed('halved.glb');
  assert.deepEqual(errors, []);
});

test('packed meshes are drawn, and measured as plain ones', options, async () => {
  const plain = read('Quaternius_Character_HumanoidRig.glb');
  const packed = [
    ['EXT', await packedByMeshopt(plain, 'EXT_meshopt_compression')], ['KHR', await packedByMeshopt(plain, 'KHR_meshopt_compression')], ['Draco', await packedByDraco(plain)],
  ];
  const seen = async (name, bytes) => {
    await open(`${name}.glb`, bytes);
    await isDrawnAsComputed(name);
    const { description } = await page.evaluate(() => window.shigusa.document.character);
    const { stature_m, feet, capsules, doubts } = description;
    return { figure: await page.evaluate(() => window.shigusa.figure()), measured: { stature_m, feet, capsules, doubts } };
  };
  const right = await seen('plain', plain);
  for (const [name, bytes] of packed) {
    const { figure, measured } = await seen(name, bytes);
    assert.ok(Math.abs(figure.high - right.figure.high) < 0.01 && Math.abs(figure.low - right.figure.low) < 0.01, `${name}: as high`);
    if (name !== 'Draco') assert.deepEqual(measured, right.measured, name); // which rounds
    else assert.ok(Math.abs(measured.stature_m - right.measured.stature_m) < 1e-3 && Math.abs(measured.feet[0].floor_m - right.measured.feet[0].floor_m) < 2e-3 && measured.doubts.length === right.measured.doubts.length);
  }
  assert.deepEqual(errors, []);
});

test('damaged packed meshes are told of, and nothing is lost', options, async () => {
  const plain = read('Quaternius_Character_HumanoidRig.glb');
  const [meshopt, draco] = [await packedByMeshopt(plain, 'EXT_meshopt_compression'), await packedByDraco(plain)];
  const packedView = ({ bufferViews }) => bufferViews.find(({ extensions }) => extensions);
  const told = (json) => packedView(json).extensions.EXT_meshopt_compression;
  const dracoView = ({ bufferViews, meshes }) => bufferViews[meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.bufferView];
  const fill = (whole, { byteOffset, byteLength }, after) => whole.fill(0xff, byteOffset + after, byteOffset + byteLength);
  const damaged = {
    'bytes.glb': changed(meshopt, (json, whole) => fill(whole, told(json), 0)),
    'stride.glb': changed(meshopt, (json) => (told(json).byteStride = 3)),
    'huge.glb': changed(meshopt, (json) => {
      told(json).count = 2 ** 28;
      packedView(json).byteLength = 2 ** 28 * told(json).byteStride;
    }),
    'nowhere.glb': changed(meshopt, (json) => (told(json).byteOffset = 1e9)),
    'draco.glb': changed(draco, (json, whole) => fill(whole, dracoView(json), 24)),
    'faces.glb': changed(draco, (json) => (json.accessors[json.meshes[0].primitives[0].indices].count = 3)),
    'ends.glb': changed(draco, (json) => (dracoView(json).byteLength = 60)),
  };
  const { character } = await state(page);
  for (const [name, bytes] of Object.entries(damaged)) {
    await drop(page, name, bytes);
    await page.waitForFunction((file) => window.shigusa.state.notice?.key === 'badPacked' && window.shigusa.state.notice.values.name === file, name, { timeout: 30_000 });
    assert.match(await page.locator('.message').innerText(), /packed meshes are damaged/);
    assert.equal((await state(page)).character, character);
  }
  assert.deepEqual(errors, []);
});

test('what cannot be drawn as it is computed is told in place of a verdict', options, async () => {
  const robot = read('RobotExpressive.glb');
  // three hangs what a scene names, without the armature above it, which is scaled by 100
  await open('elsewhere.glb', changed(robot, (json) => (json.scenes[0].nodes = [2, ...json.nodes[0].children.slice(1)])));
  const off = await apart(1);
  assert.ok(off > 0.1, `${off} m off`);
  const line = page.locator('.verdict-line .verdict');
  assert.match(await line.innerText(), /cannot be drawn as it is computed: a hand is drawn \d+.* cm off/);
  assert.match(await page.locator('.verdict-box').innerText(), /Files in its own format leave right/);
  await page.locator('.topbar select').last().selectOption('ja');
  await page.waitForFunction(() => document.documentElement.lang === 'ja');
  assert.match(await line.innerText(), /計算どおりに表示できません/);
  await page.locator('.topbar select').last().selectOption('en');
  await page.waitForFunction(() => document.documentElement.lang === 'en');

  await open('unknown.glb', changed(robot, (json) => (json.meshes[0].primitives[0].mode = 9)));
  assert.match(await line.innerText(), /mesh cannot be drawn/);
  assert.ok(await apart(1) < 2e-3, 'the mannequin stands where its nodes are, whatever their scales');

  await open('RobotExpressive.glb', robot);
  assert.match(await line.innerText(), /can be done|hard|not possible/);
  assert.deepEqual(errors, []);
});
