// SPDX-License-Identifier: MIT
// Which axes of the world lie to the right, up and towards the viewer.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { source } from './source.mjs';

const { screenAxes } = await source('view/screen_axes.ts');
const { directionOf } = await source('view/camera.ts');

/** From a direction about the body, seen from 4 m. */
const seenFrom = ({ x, y, z }) => {
  const { right, up, near } = screenAxes({ position_m: [0.1 + 4 * x, 0.8 + 4 * y, 0.2 + 4 * z], target_m: [0.1, 0.8, 0.2] });
  return [right, up, near];
};

test('the usual sides', () => {
  const usual = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  assert.deepEqual(seenFrom(directionOf('front', 1)), usual);
  assert.deepEqual(seenFrom(directionOf('threeQuarters', 1)), usual);
  assert.deepEqual(seenFrom(directionOf('threeQuarters', -1)), usual);
  assert.deepEqual(seenFrom(directionOf('side', -1)), [[0, 0, 1], [0, 1, 0], [-1, 0, 0]], 'from the body’s right its front is to the right');
  assert.deepEqual(seenFrom(directionOf('side', 1)), [[0, 0, -1], [0, 1, 0], [1, 0, 0]]);
  assert.deepEqual(seenFrom({ x: 0, y: 0, z: -1 }), [[-1, 0, 0], [0, 1, 0], [0, 0, -1]]);
  assert.deepEqual(seenFrom(directionOf('top', 1)), [[1, 0, 0], [0, 0, -1], [0, 1, 0]]);
});

test('from anywhere three axes at right angles, each within 67° of what it is for', () => {
  const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
  for (let turn = 3; turn < 360; turn += 17) {
    for (let rise = -5; rise < 90; rise += 9) {
      const [a, e] = [turn, rise].map((degrees) => (degrees * Math.PI) / 180);
      const back = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
      const truly = [[Math.cos(a), 0, -Math.sin(a)], [-Math.sin(e) * Math.sin(a), Math.cos(e), -Math.sin(e) * Math.cos(a)], back];
      const axes = seenFrom({ x: back[0], y: back[1], z: back[2] });
      for (const [k, axis] of axes.entries()) {
        assert.equal(dot(axis, axis), 1);
        assert.equal(dot(axis, axes[(k + 1) % 3]), 0);
        assert.ok(dot(axis, truly[k]) > 0.39, `${turn}° ${rise}° ${k}: ${axis}`);
      }
    }
  }
});
