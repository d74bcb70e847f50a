// SPDX-License-Identifier: MIT
// What others make of a BVH file: where its joints are in a frame, by name, in the file's unit.
import { BVHLoader } from 'three/examples/jsm/loaders/BVHLoader.js';
import { Euler, Matrix4, Quaternion, Vector3 } from 'three';

/** By three.js' loader, which adds position channels to the OFFSET. Tracks are put on the joints by hand, as its mixer knows no names with a colon. */
export function byThree(text) {
  const { skeleton, clip } = new BVHLoader().parse(text);
  const bones = new Map(skeleton.bones.map((bone) => [bone.name, bone]));
  const tracks = clip.tracks.map((track) => {
    const [, name, property] = /^(.*)\.(position|quaternion)$/.exec(track.name);
    return { bone: bones.get(name), property, track };
  });
  return (frame) => {
    for (const { bone, property, track } of tracks) bone[property].fromArray(track.values, frame * track.getValueSize());
    skeleton.bones[0].updateMatrixWorld(true);
    return new Map(skeleton.bones.map((bone) => [bone.name, bone.getWorldPosition(new Vector3())]));
  };
}

/** By Blender's rules: position channels are the whole place in the parent, and words of a name are joined. */
export function byBlender(text) {
  const [hierarchy, motion] = text.split(/^MOTION\s*$/m);
  const joints = [];
  const open = [];
  for (const line of hierarchy.split('\n').map((each) => each.trim())) {
    const words = line.split(/\s+/);
    if (['ROOT', 'JOINT', 'End'].includes(words[0])) joints.push({ name: words[0] === 'End' ? '' : words.slice(1).join('_'), parent: open.at(-1), channels: [] });
    else if (words[0] === '{') open.push(joints.at(-1));
    else if (words[0] === '}') open.pop();
    else if (words[0] === 'OFFSET') joints.at(-1).offset = words.slice(1).map(Number);
    else if (words[0] === 'CHANNELS') joints.at(-1).channels = words.slice(2);
  }
  const rows = motion.split('\n').slice(3).filter(Boolean).map((line) => line.trim().split(/\s+/).map(Number));
  return (frame) => {
    let column = 0;
    const places = new Map();
    for (const joint of joints) {
      const at = [...joint.offset];
      const turn = new Quaternion();
      for (const channel of joint.channels) {
        const value = rows[frame][column++];
        const axis = 'XYZ'.indexOf(channel[0]);
        if (channel.endsWith('position')) at[axis] = value;
        else turn.multiply(new Quaternion().setFromEuler(new Euler(...[0, 1, 2].map((k) => (k === axis ? (value * Math.PI) / 180 : 0)))));
      }
      joint.matrix = new Matrix4().compose(new Vector3(...at), turn, new Vector3(1, 1, 1));
      if (joint.parent) joint.matrix.premultiply(joint.parent.matrix);
      if (joint.name) places.set(joint.name, new Vector3().setFromMatrixPosition(joint.matrix));
    }
    return places;
  };
}
