// SPDX-License-Identifier: MIT
// Left half of a body's surface as triangles: surface nets over a grid, with a border in the plane of symmetry.

/** `field` over the box from `low` to `high`, whose first cells lie about x = 0. */
export function polygonise(field, low, high, step) {
  const size = [Math.ceil(high[0] / step) + 2, Math.ceil((high[1] - low[1]) / step) + 1, Math.ceil((high[2] - low[2]) / step) + 1];
  const [nx, ny, nz] = size;
  const value = new Float32Array(nx * ny * nz).fill(1);
  const at = (i, j, k) => (k * ny + j) * nx + i;
  const x = (i) => (i - 0.5) * step;
  const y = (j) => low[1] + j * step;
  const z = (k) => low[2] + k * step;
  const block = 8;
  const far = step * block * 1.2;
  for (let k = 0; k < nz; k += block) {
    for (let j = 0; j < ny; j += block) {
      for (let i = 0; i < nx; i += block) {
        const middle = field(Math.abs(x(i + block / 2)), y(j + block / 2), z(k + block / 2));
        const outside = Math.abs(middle) > far;
        for (let c = k; c < Math.min(k + block, nz); ++c) {
          for (let b = j; b < Math.min(j + block, ny); ++b) {
            for (let a = i; a < Math.min(i + block, nx); ++a) {
              value[at(a, b, c)] = outside ? middle : field(Math.abs(x(a)), y(b), z(c));
            }
          }
        }
      }
    }
  }
  const positions = [];
  const vertexOf = new Map();
  const vertex = (i, j, k) => {
    const key = at(i, j, k);
    const known = vertexOf.get(key);
    if (known !== undefined) return known;
    let [sx, sy, sz, n] = [0, 0, 0, 0];
    const corner = (c) => value[at(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2))];
    for (let a = 0; a < 8; ++a) {
      for (const bit of [1, 2, 4]) {
        if (a & bit) continue;
        const [p, q] = [corner(a), corner(a | bit)];
        if (p < 0 === q < 0) continue;
        const t = p / (p - q);
        sx += (a & 1) + (bit === 1 ? t : 0);
        sy += ((a >> 1) & 1) + (bit === 2 ? t : 0);
        sz += (a >> 2) + (bit === 4 ? t : 0);
        ++n;
      }
    }
    const id = positions.length;
    positions.push([i === 0 ? 0 : x(i) + (sx / n) * step, y(j) + (sy / n) * step, z(k) + (sz / n) * step]);
    vertexOf.set(key, id);
    return id;
  };
  const triangles = [];
  const quad = (inside, a, b, c, d) => {
    if (inside) triangles.push([a, b, c], [a, c, d]);
    else triangles.push([a, c, b], [a, d, c]);
  };
  for (let k = 1; k < nz - 1; ++k) {
    for (let j = 1; j < ny - 1; ++j) {
      for (let i = 0; i < nx - 1; ++i) {
        const here = value[at(i, j, k)] < 0;
        if (here !== value[at(i + 1, j, k)] < 0) quad(here, vertex(i, j - 1, k - 1), vertex(i, j, k - 1), vertex(i, j, k), vertex(i, j - 1, k));
        if (i === 0) continue;
        if (here !== value[at(i, j + 1, k)] < 0) quad(here, vertex(i - 1, j, k - 1), vertex(i - 1, j, k), vertex(i, j, k), vertex(i, j, k - 1));
        if (here !== value[at(i, j, k + 1)] < 0) quad(here, vertex(i - 1, j - 1, k), vertex(i, j - 1, k), vertex(i, j, k), vertex(i - 1, j, k));
      }
    }
  }
  return { positions, triangles };
}
