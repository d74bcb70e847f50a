// SPDX-License-Identifier: MIT
// compare_fbx.mjs GLB FBX: how far the motion that shigusa added is another in the two, as three.js reads them: the number
// of joints, how far they are apart and the corners of boxes around the skins (m), and the difference of the durations (s).
import { readFileSync } from 'node:fs';

// what the readers ask a browser for
globalThis.self = globalThis;
globalThis.window = globalThis;
globalThis.document = { createElementNS: () => ({ addEventListener() {}, removeEventListener() {} }) };
console.warn = () => {};
const { AnimationMixer, Box3, Texture, Vector3 } = await import('three');
const { FBXLoader } = await import('three/examples/jsm/loaders/FBXLoader.js');
const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');

const kCentimetre = 0.01; // m
const bytes = (path) => Uint8Array.from(readFileSync(path)).buffer;
const [glbPath, fbxPath] = process.argv.slice(2);
const glb = await new Promise((done, failed) => {
  new GLTFLoader().register(() => ({ name: 'no pictures', loadTexture: async () => new Texture() })).parse(bytes(glbPath), '', done, failed);
});
const fbx = new FBXLoader().parse(bytes(fbxPath), '');
const added = (clips) => clips.find(({ name }) => name.includes('shigusa candidate'));

/** Where joints and skins are at a time of the motion that was added. */
function posed(root, clips, time) {
  const mixer = new AnimationMixer(root);
  mixer.clipAction(added(clips)).play();
  mixer.setTime(time);
  root.updateMatrixWorld(true);
  const places = new Map();
  root.traverse((node) => {
    if (node.isBone && !places.has(node.name)) places.set(node.name, node.getWorldPosition(new Vector3()));
  });
  const skin = new Box3();
  root.traverse((node) => {
    if (node.isSkinnedMesh) skin.expandByObject(node, true);
  });
  return { places, corners: [skin.min, skin.max] };
}

const { duration } = added(glb.animations);
let [joints, off, offSkin] = [0, 0, 0];
for (const share of [0, 0.3, 0.6, 0.9]) {
  const other = posed(fbx, fbx.animations, share * duration);
  const own = posed(glb.scene, glb.animations, share * duration);
  joints = 0;
  for (const [name, place] of own.places) {
    if (!other.places.has(name)) continue;
    ++joints;
    off = Math.max(off, place.distanceTo(other.places.get(name).multiplyScalar(kCentimetre)));
  }
  own.corners.forEach((corner, k) => (offSkin = Math.max(offSkin, corner.distanceTo(other.corners[k].multiplyScalar(kCentimetre)))));
}
console.log(joints, off, offSkin, Math.abs(added(fbx.animations).duration - duration));
