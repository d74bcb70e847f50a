// SPDX-License-Identifier: MIT
// A built-in body's motion as GLB: the mannequin as it is drawn, on the body's own nodes.
import {
  AnimationClip, type BufferGeometry, InterpolateLinear, type KeyframeTrack, Mesh, QuaternionKeyframeTrack, Scene, Vector3, VectorKeyframeTrack,
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

export async function drawnGlb(character: Character, candidate: Candidate, series: NodeSeries): Promise<Uint8Array> {
  const figure = await makeFigure(character);
  try {
    figure.skin.color = palettes.light.skin;
    figure.joints.color = palettes.light.joints;
    const { time, node_translations: places, node_rotations: turns } = series;
    const times = Array.from(time.values.subarray(0, time.frames));
    const column = (values: Float64Array, columns: number, first: number, width: number): number[] => {
      const out: number[] = [];
      for (let f = 0; f < time.frames; ++f) {
        for (let k = 0; k < width; ++k) out.push(values[f * columns + first + k] ?? 0);
      }
      return out;
    };
    figure.object.traverse((item) => {
      if (!(item instanceof Mesh)) return;
      normalize(item.geometry as BufferGeometry);
      (item.geometry as BufferGeometry).deleteAttribute('uv'); // nothing is painted on
      if ((item.geometry as BufferGeometry).hasAttribute('paint')) paintByPicture(item.geometry as BufferGeometry, figure.skin, palettes.light);
    });
    const tracks: KeyframeTrack[] = [];
    figure.nodes.forEach((node, n) => {
      if (!node || 3 * n >= places.columns) return;
      if (node.name === '') node.name = `${node.parent?.name ?? 'node'}_end`;
      tracks.push(
        new VectorKeyframeTrack(`${node.uuid}.position`, times, column(places.values, places.columns, 3 * n, 3), InterpolateLinear),
        new QuaternionKeyframeTrack(`${node.uuid}.quaternion`, times, column(turns.values, turns.columns, 4 * n, 4)),
      );
    });
    tracks.push(...otherTracks(figure, candidate, series, times));
    const clip = new AnimationClip('shigusa', times[times.length - 1] ?? 0, tracks);
    // a skin's mesh stands beside the bones in the scene, under nothing that could move it
    const scene = new Scene();
    scene.name = character.description.name;
    scene.add(...figure.object.children);
    const file = await new GLTFExporter().parseAsync(scene, { binary: true, animations: [clip], onlyVisible: false });
    figure.object.add(...scene.children); // to be disposed of
    return new Uint8Array(file as ArrayBuffer);
  } finally {
    disposeFigure(figure);
  }
}
