// SPDX-License-Identifier: MIT
// The places that a picture must hold beside the goals: the way of the hands, obstacles, what is looked at, and the head as its mesh has it, from the
// motion's beginning to its end.
import { Box3, Mesh, type Object3D, SkinnedMesh, Vector3 } from 'three';
import type { Candidate, Obstacle, Quat, Vec3 } from '../../../bindings/wasm/src/types';
import type { Document } from '../state/model';
import { lookOf } from '../state/places';
import type { Figure } from './figures';
import { poseNodes } from './pose';

const kMoments = [0, 0.5, 1]; // shares of the duration
const kFarthestCorner = 4; // m: a wall or a floor of obstacles need not be seen to its end

/** How far the drawn head reaches above and around its joint, m, as the figure is posed now: hats, hair and all. */
export function headReach(figure: Figure, head: Object3D): number {
  const joint = head.getWorldPosition(new Vector3());
  const box = new Box3();
  figure.object.traverse((item) => {
    if (!(item instanceof Mesh) || !item.visible) return;
    // the box of a skin is of its last pose, and three keeps it
    if (item instanceof SkinnedMesh) item.computeBoundingBox();
    box.expandByObject(item);
  });
  return box.isEmpty() ? 0 : Math.max(box.max.y - joint.y, 0);
}

function cornersOf({ position_m, size_m = [0, 0, 0], radius_m = 0, rotation_xyzw }: Obstacle): Vector3[] {
  const half = (size: Vec3): Vector3 => new Vector3(...size).multiplyScalar(0.5).addScalar(radius_m);
  const reach = half(size_m);
  const turn = (corner: Vector3, by: Quat | undefined): Vector3 => {
    if (by) {
      const [x, y, z, w] = by;
      const axis = new Vector3(x, y, z);
      const twice = axis.clone().cross(corner).multiplyScalar(2);
      corner.addScaledVector(twice, w).add(axis.cross(twice));
    }
    return corner.add(new Vector3(...position_m));
  };
  const signs = [-1, 1];
  return signs.flatMap((x) => signs.flatMap((y) => signs.map((z) => turn(new Vector3(x, y, z).multiply(reach), rotation_xyzw))))
    .filter((corner) => corner.length() < kFarthestCorner);
}

/** `reach`: of the head above its joint, m. Leaves the figure's nodes posed at the end. */
export function placesToSee(document: Document, candidate: Candidate, figure: Figure, head: Object3D | undefined, reach: number): Vector3[] {
  const places = (document.settings.more.obstacles ?? []).flatMap(cornersOf);
  const look = lookOf(document);
  if (look) places.push(new Vector3(...look));
  const { effectors } = candidate.series;
  for (const share of kMoments) {
    const row = Math.round(share * (effectors.frames - 1)) * effectors.columns;
    for (let k = 0; k + 2 < effectors.columns; k += 3) places.push(new Vector3().fromArray(effectors.values, row + k));
    if (!head) continue;
    poseNodes(figure.nodes, candidate, share * candidate.summary.duration_s);
    figure.object.updateMatrixWorld(true);
    const joint = head.getWorldPosition(new Vector3());
    const side = 0.5 * reach;
    places.push(joint.clone().setY(joint.y + reach), joint.clone().setX(joint.x + side), joint.clone().setX(joint.x - side));
  }
  return places;
}
