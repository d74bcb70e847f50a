// SPDX-License-Identifier: MIT
// A ring on the surface that a dragged place has snapped to.
import { DoubleSide, Mesh, MeshBasicMaterial, RingGeometry, Vector3 } from 'three';
import type { Snap } from '../state/snapping';
import type { Palette } from './palette';

const kAhead = new Vector3(0, 0, 1); // that the ring's geometry faces

export class SnapMark {
  private readonly material = new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.9, depthTest: false });
  readonly object = new Mesh(new RingGeometry(0.045, 0.06, 40), this.material);

  constructor() {
    this.object.visible = false;
    this.object.renderOrder = 9;
  }

  paint(palette: Palette): void {
    this.material.color = palette.mass;
  }

  show(snap: Snap | null): void {
    this.object.visible = snap !== null;
    if (!snap) return;
    this.object.position.copy(snap.place);
    this.object.quaternion.setFromUnitVectors(kAhead, snap.normal);
  }
}
