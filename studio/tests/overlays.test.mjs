// SPDX-License-Identifier: MIT
// What is drawn about a motion.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { source } from './source.mjs';

const { Overlays } = await source('view/overlays.ts');

const series = (columns, ...rows) => ({ frames: rows.length, columns, values: Float64Array.from(rows.flat()) });
const candidate = {
  series: { time: series(1, [0], [1]), effectors: series(3, [0.1, 1, 0.2], [0.2, 0.6, 0.5]), centre_of_mass: series(3, [0, 1, 0.02], [0.05, 0.7, 0.09]) },
  summary: { reached: [], reasons: [] },
};

test('the way of the centre of mass lies on the floor, and the figure hides what is behind it', () => {
  const overlays = new Overlays();
  overlays.show(candidate, []);
  overlays.pose(1, true);
  const lines = [];
  overlays.object.traverse((item) => {
    if (item.isLine && item.geometry.attributes.position?.count === 2) lines.push({ material: item.material, points: [...item.geometry.attributes.position.array] });
  });
  const near = (a, b) => a.every((value, k) => Math.abs(value - b[k]) < 1e-6);
  const way = lines.find(({ points: [x, , z, u, , w] }) => near([x, z, u, w], [0, 0.02, 0.05, 0.09]));
  assert.ok(way, 'it is drawn');
  assert.ok(way.material.depthTest);
  for (const height of [way.points[1], way.points[4]]) assert.ok(height > 0 && height < 0.01, `${height} m`);
  assert.ok(lines.some(({ points }) => near(points, [0.1, 1, 0.2, 0.2, 0.6, 0.5])), 'the hand’s path is where the hand goes');
});
