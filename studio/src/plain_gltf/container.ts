// SPDX-License-Identifier: MIT
// A glTF file's JSON part and its bytes, from GLB or text, and back as GLB.

export interface BufferView {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  byteStride?: number;
  target?: number;
  extensions?: Record<string, unknown>;
}

export interface Accessor {
  bufferView?: number;
  byteOffset?: number;
  componentType: number;
  count: number;
  type: string;
  sparse?: object;
}

export interface Primitive {
  attributes: Record<string, number>;
  indices?: number;
  mode?: number;
  extensions?: Record<string, unknown>;
}

/** What is looked at here; all else stays as it is. */
export interface Gltf {
  buffers?: { uri?: string; byteLength: number; extensions?: Record<string, unknown> }[];
  bufferViews?: BufferView[];
  accessors?: Accessor[];
  meshes?: { primitives: Primitive[] }[];
  extensionsUsed?: string[];
  extensionsRequired?: string[];
}

const kGlb = 0x46546c67;
const kJson = 0x4e4f534a;
const kBinary = 0x004e4942;
const kHeader = 12;
const kChunkHeader = 8;

/** Throws where the file is damaged. */
export function readContainer(bytes: Uint8Array): { json: Gltf; binary?: Uint8Array } {
  const parse = (text: Uint8Array): Gltf => JSON.parse(new TextDecoder().decode(text).replace(/\0+$/, '')) as Gltf; // some pad with zeros
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < kHeader || view.getUint32(0, true) !== kGlb) return { json: parse(bytes) };
  const chunks = new Map<number, Uint8Array>();
  for (let at = kHeader; at + kChunkHeader <= bytes.length;) {
    const [length, type] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    at += kChunkHeader;
    if (!chunks.has(type)) chunks.set(type, bytes.subarray(at, at + length));
    at += length;
  }
  const text = chunks.get(kJson);
  if (!text) throw new SyntaxError('no JSON');
  return { json: parse(text), binary: chunks.get(kBinary) };
}

const padded = (length: number): number => (length + 3) & ~3;

/** One GLB of a JSON part and the parts of its only buffer, each of which begins at a multiple of four. */
export function writeGlb(json: object, parts: readonly Uint8Array[]): Uint8Array {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const binary = parts.reduce((sum, part) => sum + padded(part.length), 0);
  const size = kHeader + 2 * kChunkHeader + padded(text.length) + binary;
  const bytes = new Uint8Array(size);
  const view = new DataView(bytes.buffer);
  [kGlb, 2, size, padded(text.length), kJson].forEach((word, k) => view.setUint32(4 * k, word, true));
  let at = kHeader + kChunkHeader;
  bytes.fill(0x20, at, at + padded(text.length)); // spaces
  bytes.set(text, at);
  at += padded(text.length);
  [binary, kBinary].forEach((word, k) => view.setUint32(at + 4 * k, word, true));
  at += kChunkHeader;
  for (const part of parts) {
    bytes.set(part, at);
    at += padded(part.length);
  }
  return bytes;
}
