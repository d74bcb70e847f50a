// SPDX-License-Identifier: MIT
// The rings about a handle that turn what is selected.
import assert from 'node:assert/strict';
import { handleOf, settled } from './support.mjs';

/** The angle between two rotations, degrees. */
export function angleBetween(a, b) {
  const cosine = Math.abs(a.reduce((sum, value, k) => sum + value * b[k], 0));
  return (360 / Math.PI) * Math.acos(Math.min(cosine, 1));
}

/** Drags rings about a handle until what it is of is turned; finds them by trying, as they lie on the screen as the camera sees them. */
export async function turnByRings(page, handle, rotation) {
  const before = await rotation();
  for (const radius of [50, 60, 40, 70]) {
    for (let turn = 0; turn < 2 * Math.PI; turn += Math.PI / 4) {
      const [x, y] = await handleOf(page, handle);
      const [along, across] = [Math.cos(turn), Math.sin(turn)];
      await page.mouse.move(x + radius * along, y + radius * across);
      await page.mouse.down();
      for (let k = 1; k <= 4; ++k) await page.mouse.move(x + radius * along - 6 * k * across, y + radius * across + 6 * k * along);
      await page.mouse.up();
      await settled(page);
      const turned = angleBetween(before, await rotation());
      if (turned > 3) return turned;
    }
  }
  return assert.fail('no ring was found');
}
