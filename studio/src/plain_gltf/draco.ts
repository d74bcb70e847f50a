// SPDX-License-Identifier: MIT
// Primitives of KHR_draco_mesh_compression.
import create, { type DracoModule } from 'draco3d/draco_decoder_nodejs.js';
import address from 'draco3d/draco_decoder.wasm?url';
import { fetchPart } from '../offline/part';
import type { Accessor } from './container';
import { dracoCounts } from './draco_header';
import { PackedError } from './packed';
import { sizeOf } from './unpack';

export interface DracoMesh {
  bufferView: number;
  attributes: Record<string, number>;
}

const kTypes: Record<number, `DT_${string}`> = {
  5120: 'DT_INT8', 5121: 'DT_UINT8', 5122: 'DT_INT16', 5123: 'DT_UINT16', 5125: 'DT_UINT32', 5126: 'DT_FLOAT32',
};
const kUint32 = 5125;

/** A decoder of its own for each mesh: what a damaged one did to its memory goes with it. */
async function decoder(): Promise<DracoModule> {
  wasm ??= fetchPart(() => fetch(address).then((answer) => answer.arrayBuffer()));
  wasm.catch(() => (wasm = undefined));
  return create({ wasmBinary: await wasm });
}
let wasm: Promise<ArrayBuffer> | undefined;

/** The values of the attributes and the corners of the triangles; the accessors are told how many there are. */
export async function unpackDraco(
  bytes: Uint8Array, attributes: readonly { id: number; accessor: Accessor }[], indices: Accessor,
): Promise<{ columns: Uint8Array[]; corners: Uint8Array }> {
  const told = dracoCounts(bytes);
  const most = Math.max(...attributes.map(({ accessor }) => accessor.count));
  if (told.faces > indices.count || told.vertices > most) throw new PackedError(`${told.faces} triangles of ${told.vertices} vertices, not ${indices.count} corners of ${most}`);
  const draco = await decoder();
  const reader = new draco.Decoder();
  const mesh = new draco.Mesh();
  const status = reader.DecodeArrayToMesh(bytes, bytes.length, mesh);
  if (!status.ok()) throw new PackedError(status.error_msg());
  /** Bytes that are written into the decoder's memory. */
  const written = (size: number, write: (at: number) => boolean): Uint8Array => {
    const at = draco._malloc(size);
    if (!write(at)) throw new PackedError('values of Draco are not as the file declares them');
    return draco.HEAPU8.slice(at, at + size);
  };
  const columns = attributes.map(({ id, accessor }) => {
    accessor.count = mesh.num_points();
    const size = sizeOf(accessor);
    const type = kTypes[accessor.componentType];
    const attribute = reader.GetAttributeByUniqueId(mesh, id);
    const each = sizeOf({ ...accessor, count: 1, componentType: 5121 });
    if (type === undefined || attribute.num_components() !== each) throw new PackedError(`attribute ${id} is no ${accessor.type}`);
    return written(size, (at) => reader.GetAttributeDataArrayForAllPoints(mesh, attribute, draco[type]!, size, at));
  });
  indices.count = 3 * mesh.num_faces();
  indices.componentType = kUint32;
  const size = 4 * indices.count;
  return { columns, corners: written(size, (at) => reader.GetTrianglesUInt32Array(mesh, size, at)) };
}
