// SPDX-License-Identifier: MIT
// read_shard.mjs SHARD: what h5wasm finds in it, a line for each table's lists of names and for each
// column: path, shape and the SHA-256 of its bytes. tests/readers/read_dataset.py prints the same by h5py.
import { createHash } from 'node:crypto';
import { File, Group, ready } from 'h5wasm/node';

const digest = (bytes) => createHash('sha256').update(bytes).digest('hex');
const bytesOf = (value) =>
  ArrayBuffer.isView(value) ? new Uint8Array(value.buffer, value.byteOffset, value.byteLength) : [value].flat().join('\n');
const lines = [];

function show(group) {
  for (const [name, attribute] of Object.entries(group.attrs)) {
    if (Array.isArray(attribute.value)) lines.push(`${group.path}@${name} ${attribute.value.join(' ')}`);
  }
  for (const name of group.keys()) {
    const member = group.get(name);
    if (member instanceof Group) show(member);
    else lines.push(`${member.path} ${member.shape.join('x')} ${digest(bytesOf(member.value))}`);
    if (member.attrs.words) lines.push(`${member.path}@words ${member.attrs.words.value.join(' ')}`);
  }
}

await ready;
const file = new File(process.argv[2], 'r');
show(file);
file.close();
console.log(lines.sort().join('\n'));
