// SPDX-License-Identifier: MIT
// The camera's lens and where it stands. One perspective camera is moved, by a person or by the page; a parallel one follows
// it and shows what is at the target in the same size.
import { MathUtils, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import type { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { kUsualFocal_mm, type ViewSettings } from '../state/view_settings';

const kFilm_mm = 24; // height of a full frame
const kNarrow = 0.9; // width over height, below which a picture shows as much of the world's width as at it
const kNearest = 0.8; // m, with the usual lens
const kFarthest = 12; // m
const kSeen = 60; // m beyond the target

export type Preset = 'front' | 'side' | 'top' | 'threeQuarters';
export const presets: readonly Preset[] = ['front', 'side', 'top', 'threeQuarters'];

/** From the target to the camera. Bodies face +Z and have their left at +X; `side`: -1 to see the right one. */
export function directionOf(preset: Preset, side: 1 | -1): Vector3 {
  switch (preset) {
    case 'front':
      return new Vector3(0, 0, 1);
    case 'side':
      return new Vector3(side, 0, 0);
    case 'top':
      return new Vector3(0, 1, 0);
    case 'threeQuarters':
      return new Vector3(0.62 * side, 0.3, 1).normalize();
  }
}

/** Half the height that a lens shows at a distance of 1. */
const opening = (focal_mm: number): number => kFilm_mm / (2 * focal_mm);

export class Lens {
  readonly camera = new PerspectiveCamera(32, 1, 0.05, kSeen);
  private readonly parallel = new OrthographicCamera();
  private orbit: OrbitControls | null = null;
  private focal_mm = kUsualFocal_mm;
  private aspect = 1;
  private orthographic = false;

  /** What is drawn and pointed with. */
  get shown(): PerspectiveCamera | OrthographicCamera {
    return this.orthographic ? this.parallel : this.camera;
  }

  /** How many times as far the camera stands, as if through the usual lens, to see as much. */
  get reach(): number {
    return opening(kUsualFocal_mm) / opening(this.focal_mm);
  }

  /** Scale of objects with a constant size in the picture: parallel projection shows all distances alike. */
  get constantSize(): number {
    return this.orthographic ? this.distance : 1;
  }

  private get distance(): number {
    return this.camera.position.distanceTo(this.orbit?.target ?? new Vector3());
  }

  follow(orbit: OrbitControls): void {
    this.orbit = orbit;
    this.limit();
    orbit.addEventListener('change', () => this.sync());
  }

  /** With another lens the camera moves so that its target keeps its size. */
  set({ orthographic, focal_mm }: ViewSettings): void {
    const { camera, orbit } = this;
    const farther = focal_mm / this.focal_mm;
    this.orthographic = orthographic;
    this.focal_mm = focal_mm;
    this.limit();
    if (orbit && farther !== 1) camera.position.sub(orbit.target).multiplyScalar(farther).add(orbit.target);
    this.resize(this.aspect);
  }

  private limit(): void {
    if (!this.orbit) return;
    this.orbit.minDistance = kNearest * this.reach;
    this.orbit.maxDistance = kFarthest * this.reach;
    this.camera.far = kSeen + this.orbit.maxDistance;
  }

  resize(aspect: number): void {
    this.aspect = aspect;
    this.camera.aspect = aspect;
    this.camera.fov = 2 * MathUtils.radToDeg(Math.atan(opening(this.focal_mm) * Math.max(kNarrow / aspect, 1)));
    this.camera.updateProjectionMatrix();
    this.sync();
  }

  /** The parallel camera goes where the other one is. */
  sync(): void {
    const { camera, parallel } = this;
    const half = this.distance * Math.tan(MathUtils.degToRad(camera.fov / 2));
    parallel.position.copy(camera.position);
    parallel.quaternion.copy(camera.quaternion);
    parallel.top = half;
    parallel.bottom = -half;
    parallel.right = half * this.aspect;
    parallel.left = -parallel.right;
    // parallel light has no eye that things could be behind
    parallel.near = -kSeen;
    parallel.far = camera.far;
    parallel.updateProjectionMatrix();
    parallel.updateMatrixWorld();
    camera.updateMatrixWorld();
  }
}
