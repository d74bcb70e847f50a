// SPDX-License-Identifier: MIT
// Uploads of a scene to a graphics card that has let go of the page.
import { type BufferGeometry, type DirectionalLight, type Material, type Object3D, type Skeleton, Texture } from 'three';

type Drawn = Object3D & { geometry?: BufferGeometry; material?: Material | Material[]; skeleton?: Skeleton; shadow?: DirectionalLight['shadow'] };

/** Has three.js forget it now, when deleting is silent; of a context that is back the browser would warn. It is made anew when drawn. */
export function forgetUploads(scene: Object3D): void {
  scene.traverse((object) => {
    const { geometry, material, skeleton, shadow } = object as Drawn;
    geometry?.dispose();
    skeleton?.dispose();
    shadow?.dispose();
    for (const each of [material ?? []].flat()) {
      for (const value of Object.values(each)) if (value instanceof Texture) value.dispose();
      each.dispose();
    }
  });
}
