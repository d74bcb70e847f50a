// SPDX-License-Identifier: MIT
// sample_animation.mjs GLB ANIMATION RATE NODES: where nodes of the file (indices, commas between
// them) stand as three.js plays the animation, a line of x y z for each frame and node.
import { openGlb, place } from './second_reader.mjs';

const [glb, animation, rate, nodes] = process.argv.slice(2);
const playback = await openGlb(glb, animation);
const found = await Promise.all(nodes.split(',').map((i) => playback.node(Number(i))));
const duration = Math.max(...playback.action.getClip().tracks.map((t) => t.times.at(-1)));
for (let f = 0; f <= duration * rate + 1e-4; ++f) {
  playback.atTime(f / rate);
  for (const node of found) console.log(place(node).toArray().join(' '));
}
