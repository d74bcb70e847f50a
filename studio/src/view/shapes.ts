// SPDX-License-Identifier: MIT
// Smooth bodies for the mannequin: lofts through rings, limbs of changing thickness, capsules. Metres.
import {
  BufferAttribute, BufferGeometry, CapsuleGeometry, LatheGeometry, Quaternion, SphereGeometry, Vector2, Vector3,
} from 'three';

/** A cross-section of a loft: at height y a rounded ellipse about (x, z). */
export interface Ring {
  y: number;
  x?: number;
  z?: number;
  wide: number; // half, along x
  deep: number; // half, along z
  square?: number; // exponent of the super-ellipse, 2 is round
}

const kAround = 32;

/** A closed surface through rings from below, the ends drawn together; normals are smooth. */
export function loft(rings: readonly Ring[]): BufferGeometry {
  const positions: number[] = [];
  const index: number[] = [];
  for (const ring of rings) {
    const power = 2 / (ring.square ?? 2.3);
    for (let k = 0; k < kAround; ++k) {
      const angle = (2 * Math.PI * k) / kAround;
      const c = Math.cos(angle);
      const s = Math.sin(angle);
      const x = (ring.x ?? 0) + ring.wide * Math.sign(c) * Math.abs(c) ** power;
      const z = (ring.z ?? 0) + ring.deep * Math.sign(s) * Math.abs(s) ** power;
      positions.push(x, ring.y, z);
    }
  }
  for (let r = 0; r + 1 < rings.length; ++r) {
    for (let k = 0; k < kAround; ++k) {
      const a = r * kAround + k;
      const b = r * kAround + ((k + 1) % kAround);
      index.push(a, a + kAround, b, b, a + kAround, b + kAround);
    }
  }
  const cap = (ring: number, up: boolean): void => {
    const { x = 0, y, z = 0 } = rings[ring]!;
    const middle = positions.length / 3;
    positions.push(x, y, z);
    for (let k = 0; k < kAround; ++k) {
      const a = ring * kAround + k;
      const b = ring * kAround + ((k + 1) % kAround);
      if (up) index.push(a, middle, b);
      else index.push(b, middle, a);
    }
  };
  cap(0, false);
  cap(rings.length - 1, true);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setIndex(index);
  geometry.computeVertexNormals();
  return geometry;
}

/** More rings between those given, along smooth curves (Catmull-Rom). */
export function smoothRings(rings: readonly Ring[], between: number): Ring[] {
  const blend = (a: number, b: number, c: number, d: number, t: number): number =>
    0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t * t * t);
  const out: Ring[] = [];
  for (let i = 0; i + 1 < rings.length; ++i) {
    const four = [rings[Math.max(i - 1, 0)]!, rings[i]!, rings[i + 1]!, rings[Math.min(i + 2, rings.length - 1)]!];
    for (let k = 0; k < between; ++k) {
      const t = k / between;
      const at = (pick: (ring: Ring) => number): number =>
        blend(pick(four[0]!), pick(four[1]!), pick(four[2]!), pick(four[3]!), t);
      out.push({
        y: at((r) => r.y),
        x: at((r) => r.x ?? 0),
        z: at((r) => r.z ?? 0),
        wide: Math.max(at((r) => r.wide), 0.001),
        deep: Math.max(at((r) => r.deep), 0.001),
        square: at((r) => r.square ?? 2.3),
      });
    }
  }
  out.push(rings[rings.length - 1]!);
  return out;
}

const kUp = new Vector3(0, 1, 0);

/** Turns what was made along +Y from the origin to lie from a towards b. */
function lay(geometry: BufferGeometry, a: Vector3, b: Vector3): BufferGeometry {
  const way = b.clone().sub(a);
  geometry.applyQuaternion(new Quaternion().setFromUnitVectors(kUp, way.normalize()));
  return geometry.translate(a.x, a.y, a.z);
}

/** A limb from a to b with radius by share of the way; its ends are rounded. */
export function limb(a: Vector3, b: Vector3, profile: readonly (readonly [share: number, radius: number])[]): BufferGeometry {
  const length = a.distanceTo(b);
  const points: Vector2[] = [];
  const first = profile[0]![1];
  const last = profile[profile.length - 1]![1];
  for (let k = 0; k < 6; ++k) {
    const angle = (Math.PI / 2) * (k / 6);
    points.push(new Vector2(first * Math.sin(angle), -first * Math.cos(angle)));
  }
  const fine = smoothRings(profile.map(([share, radius]) => ({ y: share * length, wide: radius, deep: radius })), 3);
  for (const ring of fine) points.push(new Vector2(ring.wide, ring.y));
  for (let k = 1; k <= 6; ++k) {
    const angle = (Math.PI / 2) * (k / 6);
    points.push(new Vector2(Math.max(last * Math.cos(angle), 0), length + last * Math.sin(angle)));
  }
  return lay(new LatheGeometry(points, 22), a, b);
}

export function ball(centre: Vector3, radius: number): BufferGeometry {
  return new SphereGeometry(radius, 18, 14).translate(centre.x, centre.y, centre.z);
}

export function capsule(a: Vector3, b: Vector3, radius: number): BufferGeometry {
  const length = a.distanceTo(b);
  const geometry = new CapsuleGeometry(radius, length, 3, 9).translate(0, length / 2, 0);
  return lay(geometry, a, b);
}
