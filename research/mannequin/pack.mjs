// SPDX-License-Identifier: MIT
// Compact encoding of a mesh: triangles in the order of a walk over their edges, vertices in the order of their first
// visit, and each number as the residual of a prediction from the preceding triangle. Its reader is
// src/view/mannequin_pack.ts.

/** The triangles in the order of a walk, their corners by the vertices' new numbers, and the vertices in their new order. */
export function walk(triangles, count) {
  const key = (a, b) => a * count + b;
  const across = new Map();
  triangles.forEach(([a, b, c], t) => across.set(key(a, b), t).set(key(b, c), t).set(key(c, a), t));
  const done = new Set();
  const number = new Map();
  const corners = [];
  for (let seed = 0; seed < triangles.length; ++seed) {
    const waiting = [[seed, triangles[seed][0]]];
    while (waiting.length > 0) {
      const [t, first] = waiting.pop();
      if (done.has(t)) continue;
      done.add(t);
      const turn = triangles[t].indexOf(first);
      const [a, b, c] = [0, 1, 2].map((k) => triangles[t][(turn + k) % 3]);
      for (const v of [a, b, c]) {
        if (!number.has(v)) number.set(v, number.size);
        corners.push(number.get(v));
      }
      for (const [from, to] of [[a, b], [b, c], [c, a]]) {
        const next = across.get(key(to, from));
        if (next !== undefined && !done.has(next)) waiting.push([next, to]);
      }
    }
  }
  return { corners, order: [...number.keys()] };
}

/** For each vertex those that it is guessed from: the two on its edge and the one behind that, or the one before it. */
function known(corners, count) {
  const behind = new Map();
  const from = [];
  for (let t = 0; t < corners.length; t += 3) {
    for (let k = 0; k < 3; ++k) {
      const [v, a, b] = [0, 1, 2].map((turn) => corners[t + ((k + turn) % 3)]);
      if (from[v] === undefined) {
        const opposite = from[a] && from[b] ? behind.get(b * count + a) : undefined;
        from[v] = opposite === undefined ? [v - 1, v, v] : [a, b, opposite];
      }
    }
    for (let k = 0; k < 3; ++k) behind.set(corners[t + k] * count + corners[t + ((k + 1) % 3)], corners[t + ((k + 2) % 3)]);
  }
  return from;
}

/** Small numbers of either sign as small ones of none, in two planes of bytes. */
const planes = (numbers) => {
  const codes = numbers.map((value) => (value < 0 ? -2 * value - 1 : 2 * value));
  return Buffer.from([...codes.map((code) => code & 255), ...codes.map((code) => code >> 8)]);
};

/** The corners: how far each is behind the newest vertex, 0 for a new one. */
export function packCorners(corners) {
  let newest = 0;
  return planes(corners.map((v) => (v === newest ? (++newest, 0) : newest - v)));
}

/** Whole numbers, so many of each vertex, in the vertices' new order. */
export function packNumbers(corners, rows) {
  const from = known(corners, rows.length);
  const at = (v, k) => (v < 0 ? 0 : rows[v][k]);
  const left = [];
  for (let k = 0; k < rows[0].length; ++k) {
    rows.forEach((row, v) => {
      const [a, b, opposite] = from[v];
      left.push(row[k] - (opposite === v ? at(a, k) : at(a, k) + at(b, k) - at(opposite, k)));
    });
  }
  return planes(left);
}
