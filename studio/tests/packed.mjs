// SPDX-License-Identifier: MIT
// Packs the meshes of a GLB as tools do: by meshopt or by Draco, with the encoders of their own makers.
import draco3d from 'draco3d';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { parseGlb, valuesOf } from './glb.mjs';

/** A GLB of a JSON part and the parts of its buffer. */
export function glbOf(json, parts) {
  let byteOffset = 0;
  const padded = parts.map((part) => Buffer.concat([part, Buffer.alloc(-part.length & 3)]));
  const text = Buffer.from(JSON.stringify({ ...json, buffers: [{ byteLength: padded.reduce((sum, { length }) => sum + length, 0) }, ...json.buffers.slice(1)] }));
  const chunks = [[0x4e4f534a, Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')])], [0x004e4942, Buffer.concat(padded)]];
  const whole = chunks.flatMap(([type, bytes]) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(bytes.length, 0);
    head.writeUInt32LE(type, 4);
    byteOffset += 8 + bytes.length;
    return [head, bytes];
  });
  const head = Buffer.alloc(12);
  [0x46546c67, 2, 12 + byteOffset].forEach((word, k) => head.writeUInt32LE(word, 4 * k));
  return Buffer.concat([head, ...whole]);
}

/** Where each part begins, as all begin at a multiple of four. */
function placed(parts) {
  let at = 0;
  return parts.map((part) => {
    const byteOffset = at;
    at += (part.length + 3) & ~3;
    return byteOffset;
  });
}

function partsOf({ json, binary, view }) {
  return json.bufferViews.map(({ byteOffset = 0, byteLength }) => Buffer.from(view.buffer, view.byteOffset + binary + byteOffset, byteLength));
}

/** Each view that accessors name is packed, indices as such and all else as attributes. `name`: the extension's. */
export async function packedByMeshopt(bytes, name) {
  await MeshoptEncoder.ready;
  const glb = parseGlb(bytes);
  const { json } = glb;
  const parts = partsOf(glb);
  const indices = new Map(json.meshes.flatMap(({ primitives }) => primitives)
    .map((primitive) => json.accessors[primitive.indices]).map(({ bufferView, componentType }) => [bufferView, componentType]));
  const named = new Set(json.accessors.map(({ bufferView }) => bufferView));
  const fallback = json.buffers.push({ byteLength: parts.reduce((sum, { length }) => sum + length, 0), extensions: { [name]: { fallback: true } } }) - 1;
  const told = json.bufferViews.map((view, index) => {
    const isIndex = indices.has(index);
    const byteStride = isIndex ? { 5123: 2, 5125: 4 }[indices.get(index)] : view.byteStride ?? 4;
    if (!named.has(index) || !byteStride || parts[index].length % byteStride !== 0) return null;
    const [count, mode] = [parts[index].length / byteStride, isIndex ? 'INDICES' : 'ATTRIBUTES'];
    parts[index] = Buffer.from(MeshoptEncoder.encodeGltfBuffer(parts[index], count, byteStride, mode, name.startsWith('EXT') ? 0 : 1));
    return { buffer: 0, byteStride, count, mode };
  });
  const starts = placed(parts);
  json.bufferViews.forEach((view, index) => {
    if (told[index] === null) return Object.assign(view, { byteOffset: starts[index] });
    view.buffer = fallback;
    view.extensions = { [name]: { ...told[index], byteOffset: starts[index], byteLength: parts[index].length } };
  });
  json.extensionsUsed = json.extensionsRequired = [name];
  return glbOf(json, parts);
}

const kGeneric = { JOINTS_0: 'UInt16', WEIGHTS_0: 'Float' };

/** Numbers things anew in the order in which they are asked for. */
function renumbered() {
  const order = new Map();
  return { order, of: (index) => order.get(index) ?? order.set(index, order.size).get(index) };
}

/** Accessors and views that nothing names any more go, with their parts. */
function keepNamed(json, parts) {
  const [accessors, views] = [renumbered(), renumbered()];
  for (const primitive of json.meshes.flatMap(({ primitives }) => primitives)) {
    const told = primitive.extensions.KHR_draco_mesh_compression;
    told.bufferView = views.of(told.bufferView);
    primitive.indices = accessors.of(primitive.indices);
    for (const name of Object.keys(primitive.attributes)) primitive.attributes[name] = accessors.of(primitive.attributes[name]);
  }
  for (const skin of json.skins ?? []) skin.inverseBindMatrices = accessors.of(skin.inverseBindMatrices);
  for (const sampler of (json.animations ?? []).flatMap(({ samplers }) => samplers)) {
    sampler.input = accessors.of(sampler.input);
    sampler.output = accessors.of(sampler.output);
  }
  json.accessors = [...accessors.order.keys()].map((index) => json.accessors[index]);
  for (const named of [...json.accessors, ...(json.images ?? [])]) if (named.bufferView !== undefined) named.bufferView = views.of(named.bufferView);
  const kept = [...views.order.keys()];
  const old = parts.splice(0);
  parts.push(...kept.map((index) => old[index]));
  const starts = placed(parts);
  json.bufferViews = kept.map((index, k) => {
    const { target, byteStride } = json.bufferViews[index] ?? {};
    return { buffer: 0, byteOffset: starts[k], byteLength: parts[k].length, target, byteStride };
  });
}

/** Each primitive is packed; of its attributes those that a person is drawn by. */
export async function packedByDraco(bytes) {
  const draco = await draco3d.createEncoderModule();
  const glb = parseGlb(bytes);
  const { json } = glb;
  const parts = partsOf(glb);
  for (const primitive of json.meshes.flatMap(({ primitives }) => primitives)) {
    const values = (accessor) => valuesOf(glb, accessor);
    const [builder, mesh, encoder] = [new draco.MeshBuilder(), new draco.Mesh(), new draco.Encoder()];
    const corners = values(primitive.indices).flat();
    builder.AddFacesToMesh(mesh, corners.length / 3, Uint32Array.from(corners));
    const attributes = {};
    const accessors = {};
    for (const name of ['POSITION', 'NORMAL', 'JOINTS_0', 'WEIGHTS_0']) {
      if (primitive.attributes[name] === undefined) continue;
      const list = values(primitive.attributes[name]);
      const [kind, type] = [kGeneric[name] ?? 'Float', draco[kGeneric[name] ? 'GENERIC' : name]];
      const typed = kind === 'Float' ? Float32Array.from(list.flat()) : Uint16Array.from(list.flat());
      attributes[name] = builder[`Add${kind}Attribute`](mesh, type, list.length, list[0].length, typed);
      const { type: shape, min, max } = json.accessors[primitive.attributes[name]];
      accessors[name] = { type: shape, componentType: kind === 'Float' ? 5126 : 5123, min, max };
    }
    encoder.SetAttributeQuantization(draco.POSITION, 16);
    encoder.SetTrackEncodedProperties(true);
    const out = new draco.DracoInt8Array();
    const size = encoder.EncodeMeshToDracoBuffer(mesh, out);
    const part = Buffer.alloc(size);
    for (let k = 0; k < size; ++k) part[k] = out.GetValue(k);
    const add = (accessor, count) => json.accessors.push({ ...accessor, count }) - 1;
    primitive.attributes = Object.fromEntries(Object.entries(accessors).map(([name, accessor]) => [name, add(accessor, encoder.GetNumberOfEncodedPoints())]));
    primitive.indices = add({ type: 'SCALAR', componentType: json.accessors[primitive.indices].componentType }, 3 * encoder.GetNumberOfEncodedFaces());
    primitive.extensions = { KHR_draco_mesh_compression: { bufferView: parts.push(part) - 1, attributes } };
  }
  keepNamed(json, parts);
  json.extensionsUsed = json.extensionsRequired = ['KHR_draco_mesh_compression'];
  return glbOf(json, parts);
}
