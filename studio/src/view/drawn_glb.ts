// SPDX-License-Identifier: MIT
// A built-in body's motion as GLB: the mannequin as it is drawn, on the body's own nodes.
import {
  AnimationClip, BufferAttribute, type BufferGeometry, InterpolateLinear, type KeyframeTrack, Mesh, QuaternionKeyframeTrack, Scene, Vector3, VectorKeyframeTrack,
} from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import type { Candidate, Character, Series } from '../../../bindings/wasm/src/types';
import { disposeFigure, type Figure, makeFigure, poseFigure } from './figures';
import { paintByPicture } from './mannequin_material';
import { palettes } from './palette';

/** glTF wants normals of length 1 even where no triangle uses them. */
function normalize(geometry: BufferGeometry): void {
  const normals = geometry.getAttribute('normal');
  const normal = new Vector3();
  for (let i = 0; i < normals.count; ++i) {
    normal.fromBufferAttribute(normals, i);
    if (normal.lengthSq() < 1e-12) normal.set(0, 1, 0);
    normals.setXYZ(i, ...normal.normalize().toArray());
  }
}

type NodeSeries = Record<'time' | 'node_translations' | 'node_rotations', Series>;

/** How what moves beside the nodes moves. */
function otherTracks(figure: Figure, candidate: Candidate, series: NodeSeries, times: readonly number[]): KeyframeTrack[] {
  const others = figure.others ?? [];
  const turns = others.map((): number[] => []);
  const moving: Candidate = { ...candidate, series: { ...candidate.series, ...series } };
  for (const time of times) {
    poseFigure(figure, moving, time);
    others.forEach((bone, k) => turns[k]!.push(...bone.quaternion.toArray()));
  }
  return others.map((bone, k) => new QuaternionKeyframeTrack(`${bone.uuid}.quaternion`, [...times], turns[k]!));
}

/** A motion and the name of its animation. */
export interface DrawnClip {
  name: string;
  candidate: Candidate;
  series: NodeSeries;
}

interface DrawnSettings {
  names: Readonly<Record<string, string>>; // of joints, by their own
  inPlace: boolean; // the hips keep their place along the floor
}

/** Tracks of the nodes, by the figure's own objects. */
function animation({ name, candidate, series }: DrawnClip, figure: Figure, inPlace: boolean): AnimationClip {
  const { time, node_translations: places, node_rotations: turns } = series;
  const times = Array.from(time.values.subarray(0, time.frames));
  const column = (values: Float64Array, columns: number, first: number, width: number): number[] => {
    const out: number[] = [];
    for (let f = 0; f < time.frames; ++f) {
      for (let k = 0; k < width; ++k) out.push(values[f * columns + first + k] ?? 0);
    }
    return out;
  };
  const tracks: KeyframeTrack[] = [];
  figure.nodes.forEach((node, n) => {
    if (!node || 3 * n >= places.columns) return;
    const place = column(places.values, places.columns, 3 * n, 3);
    if (inPlace && n === 0) {
      for (let k = 3; k < place.length; k += 3) [place[k], place[k + 2]] = [place[0]!, place[2]!];
    }
    tracks.push(
      new VectorKeyframeTrack(`${node.uuid}.position`, times, place, InterpolateLinear),
      new QuaternionKeyframeTrack(`${node.uuid}.quaternion`, times, column(turns.values, turns.columns, 4 * n, 4)),
    );
  });
  tracks.push(...otherTracks(figure, candidate, series, times));
  return new AnimationClip(name, times[times.length - 1] ?? 0, tracks);
}

export async function drawnGlb(character: Character, clips: readonly DrawnClip[], { names, inPlace }: DrawnSettings): Promise<Uint8Array> {
  const figure = await makeFigure(character);
  try {
    figure.skin.color = palettes.light.skin;
    figure.joints.color = palettes.light.joints;
    figure.object.traverse((item) => {
      if (!(item instanceof Mesh)) return;
      const geometry = item.geometry as BufferGeometry;
      normalize(geometry);
      geometry.deleteAttribute('uv'); // nothing is painted on
      if (!geometry.hasAttribute('paint')) return;
      paintByPicture(geometry, figure.skin, palettes.light);
      geometry.setIndex(new BufferAttribute(geometry.getIndex()!.array.slice(0, geometry.drawRange.count), 1)); // without the coarse corners
    });
    const animations = clips.map((clip) => animation(clip, figure, inPlace));
    // nodes are found by their own names while a figure moves
    for (const node of figure.nodes) {
      if (node) node.name = node.name === '' ? `${node.parent?.name ?? 'node'}_end` : (names[node.name] ?? node.name);
    }
    // a skin's mesh stands beside the bones in the scene, under nothing that could move it
    const scene = new Scene();
    scene.name = character.description.name;
    scene.add(...figure.object.children);
    const file = await new GLTFExporter().parseAsync(scene, { binary: true, animations, onlyVisible: false });
    figure.object.add(...scene.children); // to be disposed of
    return new Uint8Array(file as ArrayBuffer);
  } finally {
    disposeFigure(figure);
  }
}
