// SPDX-License-Identifier: MIT
// The camera of small pictures: as near as it may be for the body, from a motion's beginning to its end, to fill them.
import { Box3, MathUtils, Mesh, type PerspectiveCamera, SkinnedMesh, Vector3 } from 'three';
import type { Candidate } from '../../../bindings/wasm/src/types';
import { type Figure, poseFigure } from './figures';

const kMoments = [0, 0.5, 1]; // shares of the duration
const kFilled = 0.96; // of the picture
const kFlesh = 0.045; // statures about a joint
const kFrom = new Vector3(-0.62, 0.22, 1).normalize();

/** The joint on top of a body that stands, and how far its mesh is above that, m: a head with hair and hat. */
interface Top {
  node: number;
  above: number;
}

const tops = new WeakMap<Figure, Top>();

function topOf(figure: Figure): Top {
  const known = tops.get(figure);
  if (known) return known;
  const heights = figure.nodes.map((node) => node?.getWorldPosition(new Vector3()).y ?? -Infinity);
  const node = heights.indexOf(Math.max(...heights));
  const box = new Box3();
  figure.object.traverse((item) => {
    if (!(item instanceof Mesh) || !item.visible) return;
    if (item instanceof SkinnedMesh) item.computeBoundingBox(); // that of its last pose is kept
    box.expandByObject(item);
  });
  const top = { node, above: Math.max(box.max.y - heights[node]!, 0) };
  tops.set(figure, top);
  return top;
}

/** What the picture has to hold; leaves the figure posed at the end. */
function placesOf(figure: Figure, candidate: Candidate): Vector3[] {
  const places = candidate.summary.reached.map(({ reached_m }) => new Vector3(...reached_m));
  for (const share of kMoments) {
    poseFigure(figure, candidate, share * candidate.summary.duration_s);
    figure.object.updateMatrixWorld(true);
    const top = topOf(figure);
    figure.nodes.forEach((node, index) => {
      if (!node) return;
      const place = node.getWorldPosition(new Vector3());
      places.push(place);
      if (index === top.node) places.push(place.clone().setY(place.y + top.above));
    });
  }
  return places;
}

export interface CardView {
  from: Vector3;
  at: Vector3;
}

/** From where a candidate fills a picture of this shape. */
export function cardView(figure: Figure, candidate: Candidate, camera: PerspectiveCamera): CardView {
  const right = new Vector3(0, 1, 0).cross(kFrom).normalize();
  const up = kFrom.clone().cross(right);
  const places = placesOf(figure, candidate);
  const half = Math.tan(MathUtils.degToRad(camera.fov / 2)) * kFilled;
  const flesh = kFlesh * figure.height;
  const middle = (axis: Vector3): number => {
    const along = places.map((place) => place.dot(axis));
    return (Math.min(...along) + Math.max(...along)) / 2;
  };
  const at = right.clone().multiplyScalar(middle(right)).addScaledVector(up, middle(up)).addScaledVector(kFrom, middle(kFrom));
  const away = places.map((place) => {
    const apart = place.clone().sub(at);
    const needed = Math.max((Math.abs(apart.dot(up)) + flesh) / half, (Math.abs(apart.dot(right)) + flesh) / (half * camera.aspect));
    return needed + apart.dot(kFrom);
  });
  return { from: at.clone().addScaledVector(kFrom, Math.max(...away)), at };
}
