// SPDX-License-Identifier: MIT
// How much a mesh of Draco declares itself to be, read before a decoder takes memory for it.
import { PackedError } from './packed';

const kMesh = 1;
const kMetadata = 0x8000;

class Reader {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  byte(): number {
    const value = this.bytes[this.at++];
    if (value === undefined) throw new PackedError('a mesh of Draco ends early');
    return value;
  }

  skip(count: number): void {
    this.at += count;
  }

  /** A number in pieces of seven bits. */
  number(): number {
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const piece = this.byte();
      value += (piece & 127) * scale;
      if (piece < 128) return value;
    }
  }

  metadata(): void {
    for (let entries = this.number(); entries > 0; --entries) {
      this.skip(this.byte());
      this.skip(this.number());
    }
    for (let parts = this.number(); parts > 0; --parts) {
      this.skip(this.byte());
      this.metadata();
    }
  }
}

/** Of version 2.2, which is glTF's. */
export function dracoCounts(bytes: Uint8Array): { vertices: number; faces: number } {
  const reader = new Reader(bytes);
  const magic = String.fromCharCode(...Array.from({ length: 5 }, () => reader.byte()));
  const [major, minor, type, method, low, high] = Array.from({ length: 6 }, () => reader.byte()) as [number, number, number, number, number, number];
  if (magic !== 'DRACO' || major !== 2 || minor !== 2 || type !== kMesh) throw new PackedError(`no mesh of Draco 2.2: ${magic} ${major}.${minor}`);
  if (low + 256 * high & kMetadata) {
    for (let attributes = reader.number(); attributes > 0; --attributes) {
      reader.number();
      reader.metadata();
    }
    reader.metadata();
  }
  const isSequential = method === 0;
  if (!isSequential) reader.byte(); // the way that edges are told
  const [first, second] = [reader.number(), reader.number()];
  return isSequential ? { vertices: second, faces: first } : { vertices: first, faces: second };
}
