// SPDX-License-Identifier: MIT
// The axes of the world as they lie on the screen, along which keys move the selected object.
import type { Vec3 } from '../../../bindings/wasm/src/types';
import type { Look } from '../kept/work';

export type ScreenWay = 'right' | 'up' | 'near';

/** The axis of these, by number, that a direction is nearest to, with its sign. */
function nearest(direction: Vec3, among: readonly number[]): Vec3 {
  const axis = among.reduce((best, next) => (Math.abs(direction[next]!) > Math.abs(direction[best]!) ? next : best));
  const found: Vec3 = [0, 0, 0];
  found[axis] = direction[axis]! < 0 ? -1 : 1;
  return found;
}

/** To the right and up on the screen, and towards the viewer: each along another axis of the world. */
export function screenAxes({ position_m: from, target_m: to }: Look): Record<ScreenWay, Vec3> {
  const back: Vec3 = [from[0] - to[0], from[1] - to[1], from[2] - to[2]];
  const away = Math.hypot(back[0], back[2]);
  const [x, z] = away > 0 ? [back[0] / away, back[2] / away] : [0, 1]; // from straight above, as from the front
  const right = nearest([z, 0, -x], [0, 2]); // a camera does not roll
  const others = [0, 1, 2].filter((axis) => right[axis] === 0);
  const up = nearest([-back[1] * x, away, -back[1] * z], others);
  return { right, up, near: nearest(back, others.filter((axis) => up[axis] === 0)) };
}
