// SPDX-License-Identifier: MIT
// What others make of a glTF file: three.js and its VRM plugins, without a browser.
import { readFile } from 'node:fs/promises';
import { AnimationMixer, LoopOnce, Quaternion, Texture, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { VRMLoaderPlugin, VRMUtils } from '@pixiv/three-vrm';
import { VRMAnimationLoaderPlugin, createVRMAnimationClip } from '@pixiv/three-vrm-animation';

globalThis.self ??= globalThis;  // GLTFLoader looks for its window there
const said = console.warn;
console.warn = (...words) => {
  if (!String(words[0]).includes('texture')) said(...words);
};

async function load(path, plugins = []) {
  const loader = new GLTFLoader();
  // pictures need a browser, and nothing here looks at them
  loader.register(() => ({ name: 'no pictures', loadTexture: async () => new Texture() }));
  for (const plugin of plugins) loader.register(plugin);
  const bytes = await readFile(path);
  return loader.parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
}

// A scene in motion: `at(frame)` poses it, `node(i)` is the file's node of that index.
export class Playback {
  constructor(root, parser, clip, after = () => {}) {
    this.root = root;
    this.parser = parser;
    this.after = after;
    const times = clip.tracks.reduce((a, t) => (t.times.length > a.length ? t.times : a), []);
    this.times = times;
    this.mixer = new AnimationMixer(root);
    this.action = this.mixer.clipAction(clip);
    this.action.setLoop(LoopOnce);
    this.action.clampWhenFinished = true;
    this.action.play();
  }
  get frames() {
    return this.times.length;
  }
  at(frame) {
    this.atTime(this.times[frame]);
  }
  atTime(seconds) {
    this.action.paused = false;
    this.action.enabled = true;
    this.action.time = seconds;
    this.mixer.update(0);
    this.after();
    this.root.updateMatrixWorld(true);
  }
  node(i) {
    return this.parser.getDependency('node', i);
  }
  vertices() {
    return verticesOf(this.root);
  }
}

export const place = (node) => node.getWorldPosition(new Vector3());
export const turn = (node) => node.getWorldQuaternion(new Quaternion());

// A GLB with the animation of that name.
export async function openGlb(path, animation) {
  const gltf = await load(path);
  const clip = gltf.animations.findLast((a) => a.name === animation);
  if (!clip) throw new Error(`${path} has no animation '${animation}'`);
  return new Playback(gltf.scene, gltf.parser, clip);
}

// A VRM character moved by a VRM animation.
export async function openVrma(character, path) {
  const gltf = await load(character, [(parser) => new VRMLoaderPlugin(parser)]);
  const vrm = gltf.userData.vrm;
  VRMUtils.rotateVRM0(vrm);
  const file = await load(path, [(parser) => new VRMAnimationLoaderPlugin(parser)]);
  const animation = file.userData.vrmAnimations[0];
  if (!animation) throw new Error(`${path} holds no VRM animation`);
  const clip = createVRMAnimationClip(animation, vrm);
  return new Playback(vrm.scene, gltf.parser, clip, () => vrm.humanoid.update());
}

// World positions of all vertices, skinned ones as their bones stand.
function verticesOf(scene) {
  const found = [];
  scene.traverse((mesh) => {
    if (!mesh.isMesh) return;
    mesh.skeleton?.update();
    const at = new Vector3();
    for (let i = 0; i < mesh.geometry.attributes.position.count; ++i) {
      mesh.getVertexPosition(i, at);
      found.push(...at.applyMatrix4(mesh.matrixWorld).toArray());
    }
  });
  return found;
}

// The same of a file at rest.
export async function vertices(path) {
  const { scene } = await load(path);
  scene.updateMatrixWorld(true);
  return verticesOf(scene);
}
