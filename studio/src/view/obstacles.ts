// SPDX-License-Identifier: MIT
// A task's obstacles, through which the body must not pass: boxes with round edges, spheres and capsules.
import { Group, Mesh, MeshStandardMaterial } from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import type { Obstacle } from '../../../bindings/wasm/src/types';
import type { Palette } from './palette';

export class Obstacles {
  readonly object = new Group();
  private readonly material = new MeshStandardMaterial({ transparent: true, opacity: 0.6, roughness: 0.9 });
  private shown: readonly Obstacle[] = [];

  paint(palette: Palette): void {
    this.material.color = palette.idle;
  }

  show(obstacles: readonly Obstacle[]): void {
    if (obstacles === this.shown) return;
    this.shown = obstacles;
    for (const mesh of [...this.object.children]) {
      (mesh as Mesh).geometry.dispose();
      mesh.removeFromParent();
    }
    for (const { position_m, size_m = [0, 0, 0], radius_m = 0, rotation_xyzw } of obstacles) {
      const [x, y, z] = size_m.map((side) => side + 2 * radius_m) as [number, number, number];
      const mesh = new Mesh(new RoundedBoxGeometry(x, y, z, 6, radius_m), this.material);
      mesh.position.set(...position_m);
      if (rotation_xyzw) mesh.quaternion.set(...rotation_xyzw);
      mesh.castShadow = mesh.receiveShadow = true;
      this.object.add(mesh);
    }
  }
}
