// SPDX-License-Identifier: MIT
// A WebM file of encoded pictures: a cluster for each picture that stands for itself and those that build on it, and a table of where they are.

export interface Picture {
  readonly time_s: number;
  readonly isKey: boolean; // it stands for itself
  readonly bytes: Uint8Array;
  readonly alpha: Uint8Array | null; // its opacity, encoded as a picture
}

export interface Track {
  readonly codec: string;
  readonly width: number; // px
  readonly height: number;
  readonly fps: number;
}

const kMillisecond = 1e6; // ns
const kLongest_ms = 30_000; // of a cluster, as a block's time in it has 16 bits

function joined(parts: readonly Uint8Array[]): Uint8Array {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** Most significant byte first. */
function bytesOf(number: number, least = 1): Uint8Array {
  const bytes: number[] = [];
  for (let rest = number; rest > 0 || bytes.length < least; rest = Math.floor(rest / 256)) bytes.unshift(rest % 256);
  return Uint8Array.from(bytes);
}

/** How long an element is, in as few bytes as will do. */
function sizeBytes(size: number): Uint8Array {
  let length = 1;
  while (size >= 2 ** (7 * length) - 1) ++length;
  const bytes = bytesOf(size, length);
  bytes[0]! |= 0x80 >> (length - 1);
  return bytes;
}

function element(id: number, ...content: readonly Uint8Array[]): Uint8Array {
  const inside = joined(content);
  return joined([bytesOf(id), sizeBytes(inside.length), inside]);
}

const whole = (id: number, number: number, least = 1): Uint8Array => element(id, bytesOf(number, least));
const text = (id: number, words: string): Uint8Array => element(id, new TextEncoder().encode(words));

function float(id: number, number: number): Uint8Array {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, number);
  return element(id, bytes);
}

const head = (): Uint8Array =>
  element(0x1a45dfa3, whole(0x4286, 1), whole(0x42f7, 1), whole(0x42f2, 4), whole(0x42f3, 8), text(0x4282, 'webm'), whole(0x4287, 4), whole(0x4285, 2));

function info(seconds: number): Uint8Array {
  return element(0x1549a966, whole(0x2ad7b1, kMillisecond), float(0x4489, 1000 * seconds), text(0x4d80, 'shigusa'), text(0x5741, 'shigusa'));
}

function tracks({ codec, width, height, fps }: Track, hasAlpha: boolean): Uint8Array {
  const alpha = hasAlpha ? [whole(0x53c0, 1)] : [];
  const video = element(0xe0, whole(0xb0, width), whole(0xba, height), ...alpha);
  const additions = hasAlpha ? [whole(0x55ee, 1)] : [];
  const frame_ns = Math.round(1e9 / fps);
  return element(0x1654ae6b, element(0xae,
    whole(0xd7, 1), whole(0x73c5, 1), whole(0x9c, 0), whole(0x83, 1), whole(0x23e383, frame_ns), ...additions, text(0x86, codec), video));
}

/** A picture in the cluster that begins at `from`, ms; `since`: the picture before it. */
function block({ bytes, alpha, isKey }: Picture, at: number, from: number, since: number): Uint8Array {
  const header = Uint8Array.of(0x81, ...bytesOf(at - from, 2), alpha || !isKey ? 0 : 0x80);
  if (!alpha) return element(0xa3, header, bytes);
  const builds = isKey ? [] : [element(0xfb, bytesOf(0x10000 - (at - since), 2))]; // a time before, below 0
  return element(0xa0, element(0xa1, header, bytes), element(0x75a1, element(0xa6, whole(0xee, 1), element(0xa5, alpha))), ...builds);
}

/** Pictures that are found together, each with its time, ms. */
function groupsOf(pictures: readonly Picture[]): [Picture, number][][] {
  const groups: [Picture, number][][] = [];
  for (const picture of pictures) {
    const at = Math.round(1000 * picture.time_s);
    const last = groups.at(-1);
    if (last && !picture.isKey && at - last[0]![1] < kLongest_ms) last.push([picture, at]);
    else groups.push([[picture, at]]);
  }
  return groups;
}

function clusterOf(group: readonly [Picture, number][]): Uint8Array {
  const from = group[0]![1];
  return element(0x1f43b675, whole(0xe7, from), ...group.map(([picture, at], k) => block(picture, at, from, group[k - 1]?.[1] ?? from)));
}

/** Where each cluster is in the segment; numbers of a fixed length, so that the table's own is known before. */
function cues(starts: readonly number[], places: readonly number[]): Uint8Array {
  return element(0x1c53bb6b, ...starts.map((start, k) =>
    element(0xbb, whole(0xb3, start, 4), element(0xb7, whole(0xf7, 1), whole(0xf1, places[k]!, 4)))));
}

/** Each picture is shown for as long as the others. */
export function webmFile(track: Track, pictures: readonly Picture[]): Uint8Array {
  const groups = groupsOf(pictures);
  const clusters = groups.map(clusterOf);
  const starts = groups.map((group) => group[0]![1]);
  const before = [info(pictures.length / track.fps), tracks(track, pictures.some(({ alpha }) => alpha !== null))];
  let at = [...before, cues(starts, starts)].reduce((sum, { length }) => sum + length, 0);
  const places = clusters.map(({ length }) => (at += length) - length);
  return joined([head(), element(0x18538067, ...before, cues(starts, places), ...clusters)]);
}
