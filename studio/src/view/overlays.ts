// SPDX-License-Identifier: MIT
// Drawings about a motion: the paths of the effectors, the centre of mass with its plumb line and its way along the floor, the
// polygon that the feet stand on, and how far a goal out of reach remains.
import {
  BufferAttribute, BufferGeometry, CircleGeometry, DoubleSide, Group, Line, LineBasicMaterial, LineDashedMaterial, Mesh,
  MeshBasicMaterial, RingGeometry, SphereGeometry, Vector3,
} from 'three';
import type { Candidate, CharacterDescription, Goal, Series } from '../../../bindings/wasm/src/types';
import { momentAt, valueAt } from './pose';
import type { Palette } from './palette';

const kAboveFloor = 0.004; // m, so that it is seen

class Track {
  readonly line: Line<BufferGeometry, LineBasicMaterial>;
  constructor(opacity: number) {
    this.line = new Line(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity }));
    this.line.frustumCulled = false;
  }
  set(points: Float32Array): void {
    this.line.geometry.dispose();
    this.line.geometry = new BufferGeometry();
    this.line.geometry.setAttribute('position', new BufferAttribute(points, 3));
  }
}

function columnsOf(series: Series, first: number): Float32Array {
  const points = new Float32Array(series.frames * 3);
  for (let f = 0; f < series.frames; ++f) {
    for (let k = 0; k < 3; ++k) points[3 * f + k] = series.values[f * series.columns + first + k] ?? 0;
  }
  return points;
}

/** In the body the way of its mass would stand out as what is not part of it. */
function onFloor(points: Float32Array): Float32Array {
  return points.map((value, k) => (k % 3 === 1 ? kAboveFloor : value));
}

export class Overlays {
  readonly object = new Group();
  private readonly hands = new Group();
  private tracks: Track[] = [];
  private readonly massTrack = new Track(0.5);
  private readonly mass: Mesh<SphereGeometry, MeshBasicMaterial>;
  private readonly plumb: Line<BufferGeometry, LineDashedMaterial>;
  private readonly foot: Mesh<RingGeometry, MeshBasicMaterial>;
  private readonly support = new Group();
  private readonly supportFill = new MeshBasicMaterial({ transparent: true, opacity: 0.13, depthWrite: false, side: DoubleSide });
  private readonly supportEdge = new LineBasicMaterial({ transparent: true, opacity: 0.55 });
  private readonly missing: Line<BufferGeometry, LineDashedMaterial>;
  private readonly missingEnd: Mesh<CircleGeometry, MeshBasicMaterial>;
  private candidate: Candidate | null = null;
  private palette: Palette | null = null;

  constructor() {
    this.mass = new Mesh(new SphereGeometry(0.022, 20, 14), new MeshBasicMaterial({ transparent: true, opacity: 0.85, depthTest: false }));
    this.mass.renderOrder = 5;
    this.plumb = new Line(new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 1, 0)]),
      new LineDashedMaterial({ dashSize: 0.03, gapSize: 0.02, transparent: true, opacity: 0.7, depthTest: false }));
    this.plumb.frustumCulled = false;
    this.plumb.renderOrder = 5;
    this.foot = new Mesh(new RingGeometry(0.014, 0.022, 24).rotateX(-Math.PI / 2), new MeshBasicMaterial());
    this.missing = new Line(new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 1, 0)]),
      new LineDashedMaterial({ dashSize: 0.025, gapSize: 0.015, depthTest: false }));
    this.missing.frustumCulled = false;
    this.missing.renderOrder = 6;
    this.missingEnd = new Mesh(new CircleGeometry(0.012, 20), new MeshBasicMaterial({ depthTest: false, side: DoubleSide }));
    this.missingEnd.renderOrder = 6;
    this.object.add(this.hands, this.massTrack.line, this.mass, this.plumb, this.foot, this.support, this.missing, this.missingEnd);
    this.object.visible = false;
  }

  paint(palette: Palette): void {
    this.palette = palette;
    for (const track of this.tracks) track.line.material.color = palette.path;
    this.massTrack.line.material.color = palette.mass;
    this.colourBalance(palette);
    this.missing.material.color = palette.missing;
    this.missingEnd.material.color = palette.missing;
  }

  /** Red where the pressure would leave the support polygon. */
  private colourBalance(palette: Palette): void {
    const falls = this.candidate?.summary.reasons.some(({ kind }) => kind === 'pressure') === true;
    for (const material of [this.mass.material, this.plumb.material, this.foot.material]) material.color = falls ? palette.missing : palette.mass;
    for (const material of [this.supportFill, this.supportEdge]) material.color = falls ? palette.missing : palette.support;
  }

  setSupport(description: CharacterDescription): void {
    for (const child of [...this.support.children]) {
      (child as Mesh).geometry.dispose();
      child.removeFromParent();
    }
    const corners = description.support_polygon;
    if (corners.length < 3) return;
    const points = [...corners, corners[0]!].map(([x, z]) => new Vector3(x, kAboveFloor, z));
    const area = new BufferGeometry().setFromPoints(points);
    area.setIndex(corners.slice(2).flatMap((_, k) => [0, k + 1, k + 2])); // it is convex
    const fill = new Mesh(area, this.supportFill);
    this.support.add(fill, new Line(new BufferGeometry().setFromPoints(points), this.supportEdge));
  }

  show(candidate: Candidate | null, goals: readonly Goal[]): void {
    if (candidate === this.candidate) return;
    this.candidate = candidate;
    this.object.visible = candidate !== null;
    if (!candidate) return;
    if (this.palette) this.colourBalance(this.palette);
    const { effectors, centre_of_mass: mass } = candidate.series;
    const count = Math.floor(effectors.columns / 3);
    while (this.tracks.length > count) {
      const track = this.tracks.pop()!;
      track.line.removeFromParent();
      track.line.geometry.dispose();
    }
    while (this.tracks.length < count) {
      const track = new Track(0.85);
      if (this.palette) track.line.material.color = this.palette.path;
      this.tracks.push(track);
      this.hands.add(track.line);
    }
    this.tracks.forEach((track, k) => track.set(columnsOf(effectors, 3 * k)));
    if (mass.columns >= 3) this.massTrack.set(onFloor(columnsOf(mass, 0)));
    this.showMissing(candidate, goals);
  }

  /** The line from where the worst effector ends to its goal. */
  private showMissing(candidate: Candidate, goals: readonly Goal[]): void {
    const worst = [...candidate.summary.reached].sort((a, b) => b.error_mm - a.error_mm)[0];
    const far = worst !== undefined && worst.error_mm > 1 && goals.length > 0;
    this.missing.visible = this.missingEnd.visible = far;
    if (!far) return;
    const from = new Vector3(...worst.reached_m);
    const to = new Vector3(...worst.goal_m);
    this.missing.geometry.setFromPoints([from, to]);
    this.missing.computeLineDistances();
    this.missingEnd.position.copy(from);
  }

  /** `details`: false leaves the goal's remainder alone. */
  pose(seconds: number, details: boolean): void {
    const candidate = this.candidate;
    if (!candidate) return;
    const mass = candidate.series.centre_of_mass;
    const known = details && mass.columns >= 3;
    for (const item of [this.hands, this.massTrack.line, this.support]) item.visible = details;
    for (const item of [this.mass, this.plumb, this.foot]) item.visible = known;
    if (!known) return;
    const moment = momentAt(candidate.series.time, seconds);
    this.mass.position.set(valueAt(mass, moment, 0), valueAt(mass, moment, 1), valueAt(mass, moment, 2));
    const floor = this.mass.position.clone().setY(kAboveFloor);
    this.foot.position.copy(floor);
    this.plumb.geometry.setFromPoints([this.mass.position, floor]);
    this.plumb.computeLineDistances();
  }
}
