// SPDX-License-Identifier: MIT
// What a task says that the body must not pass through: boxes with round edges, spheres and capsules.
import { Group, Mesh, MeshStandardMaterial } from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import type { Palette } from './palette';

interface Obstacle {
  position_m: [number, number, number];
  size_m?: [number, number, number];
  radius_m?: number;
  rotation_xyzw?: [number, number, number, number];
}

export class Obstacles {
  readonly object = new Group();
  private readonly material = new MeshStandardMaterial({ transparent: true, opacity: 0.6, roughness: 0.9 });
  private shown: unknown;

  paint(palette: Palette): void {
    this.material.color = palette.idle;
  }

  /** `obstacles` as a task has them; what is none was refused by the engine. */
  show(obstacles: unknown): void {
    if (obstacles === this.shown) return;
    this.shown = obstacles;
    for (const mesh of [...this.object.children]) {
      (mesh as Mesh).geometry.dispose();
      mesh.removeFromParent();
    }
    for (const { position_m, size_m = [0, 0, 0], radius_m = 0, rotation_xyzw } of Array.isArray(obstacles) ? (obstacles as Obstacle[]) : []) {
      const [x, y, z] = size_m.map((side) => side + 2 * radius_m) as [number, number, number];
      const mesh = new Mesh(new RoundedBoxGeometry(x, y, z, 6, radius_m), this.material);
      mesh.position.set(...position_m);
      if (rotation_xyzw) mesh.quaternion.set(...rotation_xyzw);
      mesh.castShadow = mesh.receiveShadow = true;
      this.object.add(mesh);
    }
  }
}
