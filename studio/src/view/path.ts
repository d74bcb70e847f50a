// SPDX-License-Identifier: MIT
// The paths of a motion's effectors as tubes whose colour is the speed there.
import { BufferAttribute, BufferGeometry, Color, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import type { Candidate } from '../../../bindings/wasm/src/types';
import { type EffectorPath, effectorPaths } from '../state/speed';

const kRadius = 0.0065; // m
const kSides = 8;
const kNear = 5e-4; // m: places nearer than this to the last one are left out, as no direction leads from one to the other

/** The colour at a share of a ramp. */
export function colourAt(ramp: readonly Color[], share: number): Color {
  const place = Math.min(Math.max(share, 0), 1) * (ramp.length - 1);
  const first = Math.min(Math.floor(place), ramp.length - 2);
  return ramp[first]!.clone().lerp(ramp[first + 1]!, place - first);
}

export class SpeedPath {
  readonly object = new Group();
  private readonly material = new MeshBasicMaterial({ vertexColors: true });
  private shown: { candidate: Candidate; most: number; ramp: readonly Color[] } | null = null;

  /** `most`: the speed at the upper end of the ramp, m/s. */
  show(candidate: Candidate | null, most: number, ramp: readonly Color[]): void {
    const { shown } = this;
    if (shown && shown.candidate === candidate && shown.most === most && shown.ramp === ramp) return;
    for (const child of [...this.object.children]) {
      (child as Mesh).geometry.dispose();
      child.removeFromParent();
    }
    this.shown = candidate && { candidate, most, ramp };
    if (!candidate) return;
    for (const path of effectorPaths(candidate)) {
      const geometry = tube(path, most, ramp);
      if (geometry) this.object.add(new Mesh(geometry, this.material));
    }
  }
}

/** Null where the effector stays in its place. */
function tube({ axes, speeds }: EffectorPath, most: number, ramp: readonly Color[]): BufferGeometry | null {
  const [xs, ys, zs] = axes as [Float64Array, Float64Array, Float64Array];
  const places: Vector3[] = [];
  const shares: number[] = [];
  for (let f = 0; f < xs.length; ++f) {
    const place = new Vector3(xs[f], ys[f], zs[f]);
    const last = places[places.length - 1];
    if (last && last.distanceTo(place) < kNear) continue;
    places.push(place);
    shares.push(speeds[f]! / most);
  }
  if (places.length < 2) return null;
  const points = new Float32Array(places.length * kSides * 3);
  const colours = new Float32Array(points.length);
  const along = new Vector3();
  const side = new Vector3(0.3, 0.5, 0.8); // any that is not along the path; it then turns with it
  places.forEach((place, k) => {
    along.copy(places[Math.min(k + 1, places.length - 1)]!).sub(places[Math.max(k - 1, 0)]!).normalize();
    side.addScaledVector(along, -side.dot(along)).normalize();
    const other = along.clone().cross(side);
    const colour = colourAt(ramp, shares[k]!);
    for (let j = 0; j < kSides; ++j) {
      const angle = (2 * Math.PI * j) / kSides;
      const at = 3 * (k * kSides + j);
      place.clone().addScaledVector(side, kRadius * Math.cos(angle)).addScaledVector(other, kRadius * Math.sin(angle)).toArray(points, at);
      colour.toArray(colours, at);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(points, 3));
  geometry.setAttribute('color', new BufferAttribute(colours, 3));
  geometry.setIndex(triangles(places.length));
  return geometry;
}

function triangles(rings: number): number[] {
  const indices: number[] = [];
  for (let k = 0; k + 1 < rings; ++k) {
    for (let j = 0; j < kSides; ++j) {
      const next = (j + 1) % kSides;
      const [a, b] = [k * kSides + j, k * kSides + next];
      indices.push(a, b, a + kSides, b, b + kSides, a + kSides);
    }
  }
  return indices;
}
