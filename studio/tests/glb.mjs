// SPDX-License-Identifier: MIT
// An independent reading of a GLB's animation: where a node is at its end, by forward kinematics of its own.

const kSizes = { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 };

export function parseGlb(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== 0x46546c67) throw new Error('no GLB');
  const jsonLength = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + jsonLength)));
  return { json, binary: 20 + jsonLength + 8, view };
}

function lastOf({ json, binary, view }, accessor) {
  const { bufferView, byteOffset = 0, count, type } = json.accessors[accessor];
  const { byteOffset: start = 0, byteStride } = json.bufferViews[bufferView];
  const size = kSizes[type];
  const at = binary + start + byteOffset + (count - 1) * (byteStride ?? 4 * size);
  return Array.from({ length: size }, (_, k) => view.getFloat32(at + 4 * k, true));
}

const turned = ([x, y, z, w], [a, b, c]) => {
  const [tx, ty, tz] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
};

/** A node's place at the end of the file's animation, in the file's world. Knows no matrices of nodes but those of scales and shifts. */
export function endOfNode(glb, name, animation = 0) {
  const { json } = glb;
  const ends = new Map();
  for (const { sampler, target } of json.animations[animation].channels) {
    ends.set(`${target.node} ${target.path}`, lastOf(glb, json.animations[animation].samplers[sampler].output));
  }
  const parent = new Map();
  json.nodes.forEach((node, index) => (node.children ?? []).forEach((child) => parent.set(child, index)));
  let index = json.nodes.findIndex((node) => node.name === name);
  if (index < 0) throw new Error(`no node ${name}`);
  let place = [0, 0, 0];
  for (; index !== undefined; index = parent.get(index)) {
    const { matrix, scale = [1, 1, 1], rotation = [0, 0, 0, 1], translation = [0, 0, 0] } = json.nodes[index];
    if (matrix) {
      place = [0, 1, 2].map((k) => matrix[k] * place[0] + matrix[4 + k] * place[1] + matrix[8 + k] * place[2] + matrix[12 + k]);
      continue;
    }
    const [t, r, s] = ['translation', 'rotation', 'scale'].map((path, k) => ends.get(`${index} ${path}`) ?? [translation, rotation, scale][k]);
    place = turned(r, place.map((value, k) => value * s[k])).map((value, k) => value + t[k]);
  }
  return place;
}

const kComponents = { 5121: ['getUint8', 1, 255], 5123: ['getUint16', 2, 65535], 5125: ['getUint32', 4, 1], 5126: ['getFloat32', 4, 1] };

/** All values of an accessor, each a list. */
export function valuesOf({ json, binary, view }, accessor) {
  const { bufferView, byteOffset = 0, count, type, componentType, normalized } = json.accessors[accessor];
  const { byteOffset: start = 0, byteStride } = json.bufferViews[bufferView];
  const [read, bytes, most] = kComponents[componentType];
  const stride = byteStride ?? bytes * kSizes[type];
  return Array.from({ length: count }, (_, n) => Array.from({ length: kSizes[type] }, (__, k) =>
    view[read](binary + start + byteOffset + n * stride + bytes * k, true) / (normalized ? most : 1)));
}

/** The translations of a node in its parent, key by key. */
export function translationsOf({ json, binary, view }, name, animation = 0) {
  const { channels, samplers } = json.animations[animation];
  const channel = channels.find(({ target }) => target.path === 'translation' && json.nodes[target.node].name === name);
  const { bufferView, byteOffset = 0, count } = json.accessors[samplers[channel.sampler].output];
  const { byteOffset: start = 0, byteStride = 12 } = json.bufferViews[bufferView];
  return Array.from({ length: count }, (_, key) => [0, 1, 2].map((k) => view.getFloat32(binary + start + byteOffset + key * byteStride + 4 * k, true)));
}
