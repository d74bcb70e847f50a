// SPDX-License-Identifier: MIT
// How long a film lasts, told in the head of its WebM file: browsers that record leave it out, as they do not know it when they begin, and
// players then have no time line.

const kInfo = [0x15, 0x49, 0xa9, 0x66];
const kDuration = [0x44, 0x89];
const kMostHead = 4096; // bytes in which the head must begin

function find(bytes: Uint8Array, id: readonly number[], from: number, to: number): number {
  for (let at = from; at + id.length <= to; ++at) {
    if (id.every((byte, k) => bytes[at + k] === byte)) return at;
  }
  return -1;
}

/** An element's size and the number of bytes that encode it; null if it is unknown. */
function sizeAt(bytes: Uint8Array, at: number): { size: number; length: number } | null {
  const first = bytes[at] ?? 0;
  const length = Math.clz32(first) - 23;
  if (length > 4) return null; // larger than any head
  let size = first & (0xff >> length);
  for (let k = 1; k < length; ++k) size = size * 256 + (bytes[at + k] ?? 0);
  return size === 2 ** (7 * length) - 1 ? null : { size, length };
}

/** The file with its duration, s; as it is where it tells that already, or its head is another one. */
export function withDuration(bytes: Uint8Array, duration_s: number): Uint8Array {
  const info = find(bytes, kInfo, 0, Math.min(bytes.length, kMostHead));
  const told = info < 0 ? null : sizeAt(bytes, info + kInfo.length);
  if (!told) return bytes;
  const begin = info + kInfo.length + told.length;
  const end = begin + told.size;
  if (end > bytes.length || find(bytes, kDuration, begin, end) >= 0) return bytes;
  const element = new Uint8Array(11);
  element.set([...kDuration, 0x88]); // of 8 bytes
  new DataView(element.buffer).setFloat64(3, 1000 * duration_s); // in the usual unit, ms
  const size = new Uint8Array(4);
  new DataView(size.buffer).setUint32(0, 0x1000_0000 + told.size + element.length);
  const parts = [bytes.subarray(0, info + kInfo.length), size, bytes.subarray(begin, end), element, bytes.subarray(end)];
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
