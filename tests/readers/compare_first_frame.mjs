// SPDX-License-Identifier: MIT
// compare_first_frame.mjs SOURCE ANIMATION SECONDS RESULT ANIMATION NODE: how far (in the files'
// units) a vertex of the result's first frame is at most from where the source has it at that time.
// The motion may stand elsewhere and face another way: as much as the NODE, which both have, tells.
import { Vector3 } from 'three';
import { openGlb } from './second_reader.mjs';

const [source, from, seconds, result, to, index] = process.argv.slice(2);
const was = await openGlb(source, from);
was.atTime(Number(seconds));
const is = await openGlb(result, to);
is.at(0);
const [nodeWas, nodeIs] = await Promise.all([was.node(Number(index)), is.node(Number(index))]);
const move = nodeIs.matrixWorld.clone().multiply(nodeWas.matrixWorld.clone().invert());
const before = was.vertices();
const after = is.vertices();
if (before.length !== after.length) throw new Error(`${after.length} numbers of ${before.length}`);
let most = 0;
const at = new Vector3();
for (let i = 0; i < before.length; i += 3) {
  at.fromArray(before, i).applyMatrix4(move);
  most = Math.max(most, at.distanceTo(new Vector3().fromArray(after, i)));
}
console.log(before.length / 3, most);
