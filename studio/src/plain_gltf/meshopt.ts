// SPDX-License-Identifier: MIT
// Buffer views of EXT_meshopt_compression and KHR_meshopt_compression.
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import type { BufferView } from './container';
import { PackedError } from './packed';

interface Packed extends BufferView {
  byteStride: number;
  count: number;
  mode: string;
  filter?: string;
}

/** Strides that a mode or a filter has; a decoder in WebAssembly would write beside its memory with others. */
const kModes: Record<string, (stride: number) => boolean> = {
  ATTRIBUTES: (stride) => stride % 4 === 0 && stride > 0 && stride <= 256,
  TRIANGLES: (stride) => stride === 2 || stride === 4,
  INDICES: (stride) => stride === 2 || stride === 4,
};
const kFilters: Record<string, (stride: number) => boolean> = {
  NONE: () => true,
  OCTAHEDRAL: (stride) => stride === 4 || stride === 8,
  QUATERNION: (stride) => stride === 8,
  EXPONENTIAL: (stride) => stride % 4 === 0,
  COLOR: (stride) => stride === 4 || stride === 8,
};

/** The bytes of a view that `told` unpacks to. */
export async function unpackMeshopt(view: BufferView, told: unknown, sliceOf: (packed: BufferView) => Uint8Array): Promise<Uint8Array> {
  const packed = told as Packed;
  const { byteStride: stride, count, mode, filter = 'NONE' } = packed;
  if (!Number.isInteger(count) || count < 0 || count * stride !== view.byteLength) throw new PackedError(`${count} × ${stride} bytes are not ${view.byteLength}`);
  const fits = kModes[mode]?.(stride) === true && kFilters[filter]?.(stride) === true && (mode !== 'TRIANGLES' || count % 3 === 0) && (mode === 'ATTRIBUTES' || filter === 'NONE');
  if (!fits) throw new PackedError(`no ${mode} of ${count} × ${stride} bytes with the filter ${filter}`);
  await MeshoptDecoder.ready;
  const plain = new Uint8Array(view.byteLength);
  MeshoptDecoder.decodeGltfBuffer(plain, count, stride, sliceOf(packed), mode, filter);
  return plain;
}
