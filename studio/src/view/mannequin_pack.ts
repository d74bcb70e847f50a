// SPDX-License-Identifier: MIT
// This unpacks what research/mannequin/pack.mjs packed: triangles in the order of a walk over their edges, and numbers as what is left
// of them after a guess by the triangle that was there before.

/** Reads the arrays of a file one after another. */
export class Unpacker {
  private at = 0;
  private corners = new Uint16Array();
  private from: Int32Array = new Int32Array(); // three of each vertex

  constructor(private readonly bytes: Uint8Array, private readonly vertices: number) {}

  /** So many numbers from two planes of bytes, with their signs. */
  private planes(count: number): Int32Array {
    const start = this.at;
    this.at += 2 * count;
    return Int32Array.from({ length: count }, (_, k) => {
      const code = this.bytes[start + k]! | (this.bytes[start + count + k]! << 8);
      return code & 1 ? -(code + 1) / 2 : code / 2;
    });
  }

  raw(count: number): Uint8Array {
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }

  /** The triangles; before the numbers, which are guessed by them. */
  triangles(count: number): Uint16Array {
    let newest = 0;
    this.corners = Uint16Array.from(this.planes(3 * count), (behind) => (behind === 0 ? newest++ : newest - behind));
    this.from = this.known();
    return this.corners;
  }

  /** For each vertex those that it is guessed from: the two on its edge and the one behind that, or the one before it. */
  private known(): Int32Array {
    const { corners, vertices: n } = this;
    const from = new Int32Array(3 * n);
    const met = new Uint8Array(n);
    const behind = new Map<number, number>();
    for (let t = 0; t < corners.length; t += 3) {
      for (let k = 0; k < 3; ++k) {
        const [v, a, b] = [corners[t + k]!, corners[t + ((k + 1) % 3)]!, corners[t + ((k + 2) % 3)]!];
        if (met[v]) continue;
        met[v] = 1;
        const opposite = met[a] && met[b] ? behind.get(b * n + a) : undefined;
        from.set(opposite === undefined ? [v - 1, v, v] : [a, b, opposite], 3 * v);
      }
      for (let k = 0; k < 3; ++k) behind.set(corners[t + k]! * n + corners[t + ((k + 1) % 3)]!, corners[t + ((k + 2) % 3)]!);
    }
    return from;
  }

  /** So many whole numbers of each vertex, one vertex after another. */
  numbers(each: number): Int32Array {
    const { vertices: n, from } = this;
    const left = this.planes(each * n);
    const out = new Int32Array(each * n);
    for (let k = 0; k < each; ++k) {
      const at = (v: number): number => (v < 0 ? 0 : out[each * v + k]!);
      for (let v = 0; v < n; ++v) {
        const [a, b, opposite] = [from[3 * v]!, from[3 * v + 1]!, from[3 * v + 2]!];
        out[each * v + k] = left[k * n + v]! + (opposite === v ? at(a) : at(a) + at(b) - at(opposite));
      }
    }
    return out;
  }
}
