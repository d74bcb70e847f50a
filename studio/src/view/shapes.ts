// SPDX-License-Identifier: MIT
// Balls and rods of a skeleton's drawing. Metres.
import { type BufferGeometry, CapsuleGeometry, Quaternion, SphereGeometry, Vector3 } from 'three';

const kUp = new Vector3(0, 1, 0);

export function ball(centre: Vector3, radius: number): BufferGeometry {
  return new SphereGeometry(radius, 18, 14).translate(centre.x, centre.y, centre.z);
}

export function capsule(a: Vector3, b: Vector3, radius: number): BufferGeometry {
  const way = b.clone().sub(a);
  const length = way.length();
  const geometry = new CapsuleGeometry(radius, length, 3, 9).translate(0, length / 2, 0);
  geometry.applyQuaternion(new Quaternion().setFromUnitVectors(kUp, way.normalize()));
  return geometry.translate(a.x, a.y, a.z);
}
