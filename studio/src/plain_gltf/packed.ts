// SPDX-License-Identifier: MIT
// A look at whether meshes are packed. The code that unpacks them is fetched only for such a file.
import { fetchPart } from '../offline/part';

export const kMeshopt = ['EXT_meshopt_compression', 'KHR_meshopt_compression'] as const;
export const kDraco = 'KHR_draco_mesh_compression';

/** A packed file that is damaged or not as it declares itself. */
export class PackedError extends Error {}

/** Whether these are the bytes of a glTF file, binary or text. */
export function isGltf(bytes: Uint8Array): boolean {
  const start = new TextDecoder().decode(bytes.subarray(0, 64)).trimStart();
  return start.startsWith('glTF') || start.startsWith('{');
}

function isPacked(bytes: Uint8Array): boolean {
  if (!isGltf(bytes)) return false;
  // of a GLB the JSON part, which comes first
  const isText = bytes[0] !== 0x67;
  const size = isText ? bytes.length : 20 + new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength).getUint32(12, true);
  const text = new TextDecoder().decode(bytes.subarray(0, size));
  return [...kMeshopt, kDraco].some((name) => text.includes(`"${name}"`));
}

/** The bytes of a character's file as the engine and three read them: meshes are unpacked, into `most` bytes at most. */
export async function plainBytes(file: File, most: number): Promise<Uint8Array> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes.length < 20 || !isPacked(bytes)) return bytes;
  const { unpacked } = await fetchPart(() => import('./unpack'));
  return unpacked(bytes, most);
}
