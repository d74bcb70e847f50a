// SPDX-License-Identifier: MIT
// The mannequin's mesh as research/mannequin/make.mjs made it: one half in the file, both here.
import { BufferAttribute, BufferGeometry } from 'three';
import type { Vec3 } from '../../../bindings/wasm/src/types';
import address from '../../../data/mannequin.bin?url';
import { coarseCorners } from './coarse_skin';
import { Unpacker } from './mannequin_pack';

/** What moves the skin: a node of the body, a follower of a joint (`of`), which turns by a part of it, or a finger's bone. */
export interface SkinBone {
  name: string;
  kind: 'node' | 'half' | 'swing' | 'roll' | 'finger';
  of?: string;
  place: Vec3; // m, where the mesh is made
  angle: number; // rad, how far it is turned about the axis ahead from a hanging limb there
  axis?: Vec3; // of a finger's bend, in the axes of a hanging arm
  bends?: [open: number, relaxed: number, grip: number]; // rad
}

interface Head {
  stature: number;
  vertices: number;
  triangles: number;
  step: number; // m
  morphs: string[];
  shiftStep: number; // m
  weightSum: number;
  volumes: Record<string, number>;
  paint: number;
  measures: Record<string, number>;
  bones: SkinBone[];
  otherSide: number[];
}

export interface MannequinMesh extends Head {
  positions: Float32Array;
  shifts: Record<string, Float32Array>; // by morph, of each position
  skin: Uint8Array; // four bones of each vertex
  weights: Uint8Array; // theirs, of 255
  paints: Float32Array; // m inside of joints and of visor, and past the seam at a limb's root
  corners: Uint16Array;
  coarse: Uint16Array; // corners of fewer triangles
}

/** The half that is in the file, and its mirror image, which share the vertices in the plane of symmetry. */
function decode(buffer: ArrayBuffer): MannequinMesh {
  const size = new DataView(buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, size))) as Head;
  const pack = new Unpacker(new Uint8Array(buffer, 4 + size), head.vertices);
  const half = {
    corners: pack.triangles(head.triangles), positions: pack.numbers(3), shifts: pack.numbers(3 * head.morphs.length), weights: pack.numbers(4), paints: pack.numbers(3),
    skin: pack.raw(4 * head.vertices),
  };
  const source: number[] = []; // of each vertex, the one in the file
  const other: number[] = []; // of each in the file, its image
  for (let v = 0; v < head.vertices; ++v) source.push(v);
  for (let v = 0; v < head.vertices; ++v) {
    other.push(half.positions[3 * v] === 0 ? v : source.length);
    if (half.positions[3 * v] !== 0) source.push(v);
  }
  const all = source.length;
  const sign = (v: number, axis: number): number => (axis === 0 && v >= head.vertices ? -1 : 1);
  const vectors = (value: (from: number, axis: number) => number): Float32Array => {
    const out = new Float32Array(3 * all);
    for (let k = 0; k < 3 * all; ++k) out[k] = sign(Math.floor(k / 3), k % 3) * value(source[Math.floor(k / 3)]!, k % 3);
    return out;
  };
  const shifts: Record<string, Float32Array> = {};
  head.morphs.forEach((name, m) => {
    shifts[name] = vectors((v, axis) => head.shiftStep * half.shifts[3 * (head.morphs.length * v + m) + axis]!);
  });
  const corners = new Uint16Array(2 * half.corners.length);
  corners.set(half.corners);
  for (let t = 0; t < half.corners.length; t += 3) {
    const [a, b, c] = [half.corners[t]!, half.corners[t + 1]!, half.corners[t + 2]!];
    corners.set([other[a]!, other[c]!, other[b]!], half.corners.length + t);
  }
  const mesh = {
    ...head, shifts, corners,
    positions: vectors((v, axis) => head.step * half.positions[3 * v + axis]!),
    skin: Uint8Array.from({ length: 4 * all }, (_, k) => {
      const bone = half.skin[head.vertices * (k & 3) + source[k >> 2]!]!;
      return k >> 2 < head.vertices ? bone : head.otherSide[bone]!;
    }),
    weights: Uint8Array.from({ length: 4 * all }, (_, k) => (255 / head.weightSum) * half.weights[4 * source[k >> 2]! + (k & 3)]!),
    paints: Float32Array.from({ length: 3 * all }, (_, k) => half.paints[3 * source[Math.floor(k / 3)]! + (k % 3)]! * head.paint),
  };
  return { ...mesh, coarse: coarseCorners(mesh) };
}

let loading: Promise<MannequinMesh> | null = null;

/** Fetched once; anew where that has failed. */
export function loadMannequin(): Promise<MannequinMesh> {
  loading ??= (async () => {
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
    return decode(await new Response(answer.body!.pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer());
  })();
  loading.catch(() => (loading = null));
  return loading;
}

export interface Shape {
  female: number; // 0 to 1
  mass: number; // of that of an average person of the stature
}

/** The skin of a person; the coarse corners follow the fine ones. */
export function makeSkin(mesh: MannequinMesh, { female, mass }: Shape): BufferGeometry {
  const share = (name: string): number => (mass - 1) / (mesh.volumes[name]! / mesh.volumes['male']! - 1);
  const by: Record<string, number> = { female, heavy: mass > 1 ? Math.min(share('heavy'), 1.5) : 0, light: mass < 1 ? Math.min(share('light'), 1.2) : 0 };
  const positions = mesh.positions.slice();
  for (const name of mesh.morphs) {
    const amount = by[name] ?? 0;
    if (amount !== 0) mesh.shifts[name]!.forEach((shift, k) => (positions[k]! += amount * shift));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('skinIndex', new BufferAttribute(mesh.skin, 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(mesh.weights, 4, true));
  geometry.setAttribute('paint', new BufferAttribute(mesh.paints, 3));
  geometry.setIndex(new BufferAttribute(mesh.corners, 1));
  geometry.computeVertexNormals();
  const both = new Uint16Array(mesh.corners.length + mesh.coarse.length);
  both.set(mesh.corners);
  both.set(mesh.coarse, mesh.corners.length);
  geometry.setIndex(new BufferAttribute(both, 1));
  return geometry;
}
