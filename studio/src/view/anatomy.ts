// SPDX-License-Identifier: MIT
// Proportions of the mannequin, in metres at a stature of 1.741 m: how thick what is, and the shapes of trunk,
// head, hands and feet. Shapes are for looks alone; lengths come from the body's own joints.
import { type BufferGeometry, Matrix4, SphereGeometry, Vector3 } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { ball, capsule, loft, type Ring, smoothRings } from './shapes';

export const kStature = 1.741;

export const profiles = {
  upper_leg: [[0, 0.084], [0.12, 0.088], [0.4, 0.077], [0.75, 0.058], [1, 0.05]],
  lower_leg: [[0, 0.049], [0.22, 0.057], [0.38, 0.056], [0.65, 0.043], [0.88, 0.034], [1, 0.034]],
  upper_arm: [[0, 0.05], [0.25, 0.05], [0.6, 0.043], [1, 0.037]],
  lower_arm: [[0, 0.037], [0.2, 0.041], [0.5, 0.035], [0.85, 0.026], [1, 0.025]],
  neck: [[0, 0.056], [0.5, 0.051], [1, 0.05]],
  clavicle: [[0, 0.04], [1, 0.05]],
} as const;

export const joints = { knee: 0.051, elbow: 0.038, shoulder: 0.057, wrist: 0.0265, ankle: 0.036 } as const;

/** From hips (0) to neck (1): the share of that height, half width, half depth and middle, ahead. */
const kTrunk: readonly (readonly [number, number, number, number])[] = [
  [-0.185, 0.03, 0.04, -0.01],
  [-0.16, 0.085, 0.075, -0.008],
  [-0.1, 0.142, 0.104, -0.01],
  [-0.02, 0.163, 0.115, -0.012],
  [0.07, 0.163, 0.112, -0.008],
  [0.18, 0.147, 0.098, 0],
  [0.3, 0.134, 0.09, 0.002],
  [0.42, 0.138, 0.097, 0.004],
  [0.56, 0.155, 0.109, 0.006],
  [0.69, 0.166, 0.113, 0.004],
  [0.79, 0.164, 0.102, -0.002],
  [0.87, 0.138, 0.085, -0.008],
  [0.93, 0.096, 0.066, -0.008],
  [0.98, 0.064, 0.056, -0.004],
  [1.04, 0.052, 0.05, 0],
];

/** The trunk about the hips, +Y up and +Z ahead; `height`: from hips to neck. */
export function trunk(height: number, scale: number): BufferGeometry {
  const rings: Ring[] = kTrunk.map(([share, wide, deep, z]) => ({
    y: share * height, wide: wide * scale, deep: deep * scale, z: z * scale, square: 2.35,
  }));
  return loft(smoothRings(rings, 3));
}

/** The head about the joint below it; `top`: its height above that. */
export function head(top: number, scale: number): BufferGeometry {
  const chin = -0.058 * scale;
  const half = (top - chin) / 2;
  const skull = new SphereGeometry(1, 36, 28);
  const points = skull.getAttribute('position');
  for (let i = 0; i < points.count; ++i) {
    const y = points.getY(i);
    const low = Math.max(-y, 0);
    const jaw = 1 - 0.34 * low ** 1.6; // narrower towards the chin
    const face = points.getZ(i) > 0 ? 1 - 0.06 * (1 - low) : 1 - 0.3 * low ** 1.2;
    points.setXYZ(
      i, points.getX(i) * 0.077 * scale * jaw, chin + half + y * half,
      points.getZ(i) * 0.098 * scale * face + 0.018 * scale + 0.014 * scale * low,
    );
  }
  skull.computeVertexNormals();
  const nose = new SphereGeometry(0.013 * scale, 16, 12);
  nose.scale(0.8, 1.7, 1.25);
  nose.translate(0, chin + half * 0.86, 0.11 * scale);
  const ear = (side: number): BufferGeometry => {
    const shape = new SphereGeometry(0.026 * scale, 16, 12);
    shape.scale(0.35, 1.1, 0.7);
    return shape.translate(side * 0.076 * scale, chin + half * 0.98, 0.006 * scale);
  };
  return mergeGeometries([skull, nose, ear(1), ear(-1)].map(plain));
}

/** A hand from the wrist: `out` to the fingertips, `palm` where the palm faces, `thumb` its side. Unit vectors. */
export function hand(wrist: Vector3, length: number, out: Vector3, palm: Vector3, thumb: Vector3): BufferGeometry {
  const at = (along: number, side: number, front: number): Vector3 =>
    wrist.clone().addScaledVector(out, along * length).addScaledVector(thumb, side * length)
      .addScaledVector(palm, front * length);
  const rings: Ring[] = [
    [0.02, 0.13, 0.09], [0.12, 0.17, 0.1], [0.3, 0.215, 0.085], [0.45, 0.225, 0.075], [0.52, 0.21, 0.065], [0.55, 0.15, 0.04],
  ].map(([y, wide, deep]) => ({ y: y! * length, wide: wide! * length, deep: deep! * length, square: 2.6 }));
  const block = loft(smoothRings(rings, 3));
  block.applyMatrix4(new Matrix4().makeBasis(thumb, out, palm).setPosition(wrist));
  if (thumb.clone().cross(out).dot(palm) < 0) flip(block);
  const parts = [block];
  const fingers = [[0.155, 0.4, 0.046], [0.055, 0.45, 0.048], [-0.05, 0.42, 0.045], [-0.15, 0.33, 0.04]] as const;
  for (const [side, reach, radius] of fingers) {
    const root = at(0.5, side, 0);
    const knuckle = at(0.5 + reach * 0.5, side * 1.02, 0.05);
    const tip = at(0.5 + reach * 0.93, side * 0.98, 0.17);
    parts.push(capsule(root, knuckle, radius * length), capsule(knuckle, tip, radius * 0.9 * length));
  }
  parts.push(
    capsule(at(0.16, 0.14, 0.03), at(0.37, 0.3, 0.1), 0.06 * length),
    capsule(at(0.37, 0.3, 0.1), at(0.55, 0.31, 0.17), 0.05 * length),
  );
  return mergeGeometries(parts.map(plain));
}

/** The foot behind the toes' joint, in its own axes: origin on the sole below the ankle, +Y up, +Z to the toes. */
export function foot(ball_z: number, scale: number): BufferGeometry {
  // along the foot (the loft's y): half width, height
  const stations = [
    [-0.066, 0.012, 0.022], [-0.058, 0.026, 0.045], [-0.035, 0.035, 0.07], [0, 0.0365, 0.084], [0.035, 0.0385, 0.083],
    [0.07, 0.042, 0.066], [0.105, 0.047, 0.048], [0.139, 0.049, 0.034], [0.15, 0.04, 0.024],
  ] as const;
  const stretch = ball_z / (0.139 * scale);
  const rings = stations.map(([z, wide, high]): Ring => ({
    y: z * scale * (z > 0 ? stretch : 1), wide: wide * scale, deep: (high / 2) * scale, z: -(high / 2) * scale, square: 2.7,
  }));
  // the loft's +Y becomes ahead and its -Z up
  return loft(smoothRings(rings, 2)).rotateX(Math.PI / 2);
}

/** The toes about their joint, which is `high` above the sole; `inner`: 1 where the big toe is at +X. */
export function toes(high: number, scale: number, inner: number): BufferGeometry {
  const reach = [[0.03, 0.062, 0.0135], [0.01, 0.06, 0.0098], [-0.007, 0.054, 0.0092], [-0.0225, 0.045, 0.0088], [-0.0365, 0.035, 0.0085]] as const;
  const parts = reach.map(([x, long, radius]) => {
    const from = new Vector3(inner * x * 0.94 * scale, -high + (radius + 0.004) * scale, -0.012 * scale);
    const to = new Vector3(inner * x * 1.08 * scale, -high + radius * scale, (long - radius) * scale);
    return capsule(from, to, radius * scale);
  });
  parts.push(ball(new Vector3(inner * 0.026 * scale, -high + 0.018 * scale, 0), 0.018 * scale));
  return mergeGeometries(parts.map(plain));
}

/** Without texture coordinates, so that all kinds can be merged. */
export function plain(geometry: BufferGeometry): BufferGeometry {
  geometry.deleteAttribute('uv');
  return geometry;
}

function flip(geometry: BufferGeometry): void {
  const index = geometry.getIndex()!;
  for (let i = 0; i < index.count; i += 3) {
    const a = index.getX(i);
    index.setX(i, index.getX(i + 2));
    index.setX(i + 2, a);
  }
  geometry.computeVertexNormals();
}
