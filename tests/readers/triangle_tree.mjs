// SPDX-License-Identifier: MIT
// A tree of boxes over a mesh's triangles that tells whether a point is inside and how deep. Inside is where the generalized
// winding number (Jacobson and others 2013) is over a half, so that meshes may have holes, and clothes lie in layers. What is
// far of the point counts as one dipole (Barill and others 2018).

const kLeaf = 8; // triangles
const kFar = 1.5; // radii of a node from which a dipole does: wrong by 0.07 at most where the node is a cap

export class TriangleTree {
  /** Of `corners`, three places in `points` a triangle; the points may move. */
  constructor(points, corners) {
    const middles = new Float64Array(corners.length);
    for (let i = 0; i < corners.length; ++i) {
      for (let k = 0; k < 3; ++k) middles[i - (i % 3) + k] += points[3 * corners[i] + k] / 3;
    }
    const order = Uint32Array.from({ length: corners.length / 3 }, (_, t) => t);
    const nodes = []; // a node, its left half, its right half: `end` is where the next begins that is not in it
    const split = (from, to) => {
      const node = { from, to };
      nodes.push(node);
      if (to - from > kLeaf) {
        const k = longestAxis(middles, order.subarray(from, to));
        order.subarray(from, to).sort((a, b) => middles[3 * a + k] - middles[3 * b + k]);
        split(from, (from + to) >> 1);
        split((from + to) >> 1, to);
      }
      node.end = nodes.length;
    };
    if (order.length > 0) split(0, order.length);
    this.order = order;
    this.corners = Uint32Array.from(corners, (_, i) => corners[3 * order[Math.floor(i / 3)] + (i % 3)]);
    [this.from, this.to, this.end] = ['from', 'to', 'end'].map((key) => Uint32Array.from(nodes, (node) => node[key]));
    this.low = new Float64Array(3 * nodes.length);
    this.high = new Float64Array(3 * nodes.length);
    this.areas = new Float64Array(3 * nodes.length); // sums of the triangles' area vectors
    this.middles = new Float64Array(3 * nodes.length); // of the areas
    this.radii = new Float64Array(nodes.length); // about them
    this.move(points);
  }

  /** The same triangles, their points elsewhere. */
  move(points) {
    this.points = points;
    const { from, to, end } = this;
    const weights = new Float64Array(end.length);
    for (let n = end.length - 1; n >= 0; --n) {
      this.low.fill(Infinity, 3 * n, 3 * n + 3);
      this.high.fill(-Infinity, 3 * n, 3 * n + 3);
      this.areas.fill(0, 3 * n, 3 * n + 3);
      this.middles.fill(0, 3 * n, 3 * n + 3);
      if (end[n] === n + 1) {
        for (let t = from[n]; t < to[n]; ++t) weights[n] += this.#addTriangle(n, t);
      } else {
        for (const child of [n + 1, end[n + 1]]) weights[n] += this.#addNode(n, child, weights[child]);
      }
      let square = 0;
      for (let k = 3 * n; k < 3 * n + 3; ++k) {
        this.middles[k] = weights[n] > 0 ? this.middles[k] / weights[n] : this.low[k];
        square += Math.max(this.middles[k] - this.low[k], this.high[k] - this.middles[k]) ** 2;
      }
      this.radii[n] = Math.sqrt(square);
    }
  }

  #addTriangle(n, t) {
    const { points: p, corners } = this;
    const [a, b, c] = [3 * corners[3 * t], 3 * corners[3 * t + 1], 3 * corners[3 * t + 2]];
    const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const [x, y, z] = [(uy * vz - uz * vy) / 2, (uz * vx - ux * vz) / 2, (ux * vy - uy * vx) / 2];
    const weight = Math.sqrt(x * x + y * y + z * z);
    this.areas[3 * n] += x;
    this.areas[3 * n + 1] += y;
    this.areas[3 * n + 2] += z;
    for (let k = 0; k < 3; ++k) {
      this.middles[3 * n + k] += (weight * (p[a + k] + p[b + k] + p[c + k])) / 3;
      this.low[3 * n + k] = Math.min(this.low[3 * n + k], p[a + k], p[b + k], p[c + k]);
      this.high[3 * n + k] = Math.max(this.high[3 * n + k], p[a + k], p[b + k], p[c + k]);
    }
    return weight;
  }

  #addNode(n, child, weight) {
    for (let k = 0; k < 3; ++k) {
      this.areas[3 * n + k] += this.areas[3 * child + k];
      this.middles[3 * n + k] += weight * this.middles[3 * child + k];
      this.low[3 * n + k] = Math.min(this.low[3 * n + k], this.low[3 * child + k]);
      this.high[3 * n + k] = Math.max(this.high[3 * n + k], this.high[3 * child + k]);
    }
    return weight;
  }

  /** How often the mesh goes around a point: 1 inside of a closed one, 0 outside, less sharply where there are holes. */
  winding(x, y, z) {
    const { from, to, end, middles, areas, radii } = this;
    let angle = 0;
    for (let n = 0; n < end.length;) {
      const [dx, dy, dz] = [middles[3 * n] - x, middles[3 * n + 1] - y, middles[3 * n + 2] - z];
      const square = dx * dx + dy * dy + dz * dz;
      if (square > (kFar * radii[n]) ** 2) {
        angle += (dx * areas[3 * n] + dy * areas[3 * n + 1] + dz * areas[3 * n + 2]) / (square * Math.sqrt(square));
        n = end[n];
      } else {
        if (end[n] === n + 1) for (let t = from[n]; t < to[n]; ++t) angle += this.#solidAngle(t, x, y, z);
        ++n;
      }
    }
    return angle / (4 * Math.PI);
  }

  /** Van Oosterom and Strackee 1983. */
  #solidAngle(t, x, y, z) {
    const { points: p, corners } = this;
    const [i, j, k] = [3 * corners[3 * t], 3 * corners[3 * t + 1], 3 * corners[3 * t + 2]];
    const [ax, ay, az] = [p[i] - x, p[i + 1] - y, p[i + 2] - z];
    const [bx, by, bz] = [p[j] - x, p[j + 1] - y, p[j + 2] - z];
    const [cx, cy, cz] = [p[k] - x, p[k + 1] - y, p[k + 2] - z];
    const a = Math.sqrt(ax * ax + ay * ay + az * az);
    const b = Math.sqrt(bx * bx + by * by + bz * bz);
    const c = Math.sqrt(cx * cx + cy * cy + cz * cz);
    const volume = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    return 2 * Math.atan2(volume,
      a * b * c + (ax * bx + ay * by + az * bz) * c + (bx * cx + by * cy + bz * cz) * a + (cx * ax + cy * ay + cz * az) * b);
  }

  /** How far the nearest triangle that `counts` is, by its number among those that the tree was made of. */
  nearest(x, y, z, counts = () => true) {
    const { from, to, end, low, high } = this;
    let [best, triangle] = [Infinity, -1];
    for (let n = 0; n < end.length;) {
      const dx = Math.max(low[3 * n] - x, x - high[3 * n], 0);
      const dy = Math.max(low[3 * n + 1] - y, y - high[3 * n + 1], 0);
      const dz = Math.max(low[3 * n + 2] - z, z - high[3 * n + 2], 0);
      const square = dx * dx + dy * dy + dz * dz;
      if (square >= best) {
        n = end[n];
        continue;
      }
      for (let t = from[n]; end[n] === n + 1 && t < to[n]; ++t) {
        const found = this.#squaredDistance(t, x, y, z);
        if (found < best && counts(this.order[t])) [best, triangle] = [found, this.order[t]];
      }
      ++n;
    }
    return { distance: Math.sqrt(best), triangle };
  }

  /** To the triangle's plane where the foot on it is inside of the triangle, else to the nearest edge. */
  #squaredDistance(t, x, y, z) {
    const { points: p, corners } = this;
    const [i, j, k] = [3 * corners[3 * t], 3 * corners[3 * t + 1], 3 * corners[3 * t + 2]];
    const [ax, ay, az] = [x - p[i], y - p[i + 1], z - p[i + 2]];
    const [ux, uy, uz] = [p[j] - p[i], p[j + 1] - p[i + 1], p[j + 2] - p[i + 2]];
    const [vx, vy, vz] = [p[k] - p[i], p[k + 1] - p[i + 1], p[k + 2] - p[i + 2]];
    const [uu, uv, vv] = [ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz];
    const [au, av, aa] = [ax * ux + ay * uy + az * uz, ax * vx + ay * vy + az * vz, ax * ax + ay * ay + az * az];
    const square = uu * vv - uv * uv;
    const [alongU, alongV] = [vv * au - uv * av, uu * av - uv * au]; // times the square
    if (square > 1e-12 * uu * vv && alongU >= 0 && alongV >= 0 && alongU + alongV <= square) {
      return Math.max(0, aa - (alongU * au + alongV * av) / square);
    }
    const [wu, ww] = [av - au - uv + uu, uu - 2 * uv + vv]; // of the edge from u to v
    return Math.max(0, Math.min(edge(aa, au, uu), edge(aa, av, vv), edge(aa - 2 * au + uu, wu, ww)));
  }
}

/** The square of the distance to an edge from that to its begin, the product with it and its own square. */
function edge(square, along, length) {
  const share = length > 0 ? Math.min(1, Math.max(0, along / length)) : 0;
  return square - share * (2 * along - share * length);
}

/** Along which the middles of these triangles differ most. */
function longestAxis(middles, triangles) {
  const lengths = [0, 1, 2].map((k) => {
    let [low, high] = [Infinity, -Infinity];
    for (const t of triangles) {
      low = Math.min(low, middles[3 * t + k]);
      high = Math.max(high, middles[3 * t + k]);
    }
    return high - low;
  });
  return lengths.indexOf(Math.max(...lengths));
}
