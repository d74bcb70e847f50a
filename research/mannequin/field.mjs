// SPDX-License-Identifier: MIT
// Shapes as signed distance functions: m from the surface, negative inside. They are accurate enough for blending and
// for projection onto the surface; no shape has an edge.

/** The union, its seam rounded over `k` metres. */
export function join(a, b, k) {
  const h = Math.max(k - Math.abs(a - b), 0) / k;
  return Math.min(a, b) - (h * h * h * k) / 6;
}

/** What is in `a` and not in `b`, the edge rounded over `k` metres. */
export function carve(a, b, k) {
  return -join(-a, b, k);
}

export function ellipsoid([cx, cy, cz], [rx, ry, rz]) {
  return (x, y, z) => {
    const a = (x - cx) / rx;
    const b = (y - cy) / ry;
    const c = (z - cz) / rz;
    const k = Math.sqrt(a * a + b * b + c * c);
    const g = Math.sqrt((a / rx) ** 2 + (b / ry) ** 2 + (c / rz) ** 2);
    return g < 1e-9 ? -Math.min(rx, ry, rz) : (k * (k - 1)) / g;
  };
}

/** Between two balls of different size. */
export function cone([ax, ay, az], ra, [bx, by, bz], rb) {
  const [dx, dy, dz] = [bx - ax, by - ay, bz - az];
  const long = dx * dx + dy * dy + dz * dz;
  return (x, y, z) => {
    const t = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy + (z - az) * dz) / long, 0), 1);
    const s = t * t * (3 - 2 * t);
    return Math.hypot(x - ax - t * dx, y - ay - t * dy, z - az - t * dz) - ra - (rb - ra) * s;
  };
}

/** A place's coordinates beside a bone: outwards, along it and ahead. */
export function frameAt(origin, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return {
    origin, angle,
    local: (x, y, z) => {
      const [dx, dy] = [x - origin[0], y - origin[1]];
      return [dx * c + dy * s, dx * s - dy * c, z - origin[2]];
    },
    world: (u, v, w) => [origin[0] + u * c + v * s, origin[1] + u * s - v * c, origin[2] + w],
  };
}

const kSamples = 160;

/** Cubic curves through rows of numbers by their first, sampled evenly. */
function sample(rows) {
  const width = rows[0].length;
  const first = rows[0][0];
  const step = (rows[rows.length - 1][0] - first) / kSamples;
  const table = new Float64Array((kSamples + 2) * width);
  const slope = (k, c) => {
    const [a, b] = [Math.max(k - 1, 0), Math.min(k + 1, rows.length - 1)];
    return (rows[b][c] - rows[a][c]) / (rows[b][0] - rows[a][0]);
  };
  let k = 0;
  for (let i = 0; i <= kSamples + 1; ++i) {
    const v = first + Math.min(i, kSamples) * step;
    while (k < rows.length - 2 && v > rows[k + 1][0]) ++k;
    const span = rows[k + 1][0] - rows[k][0];
    const t = (v - rows[k][0]) / span;
    for (let c = 0; c < width; ++c) {
      const [a, b] = [rows[k][c], rows[k + 1][c]];
      const [p, q] = [slope(k, c) * span, slope(k + 1, c) * span];
      table[i * width + c] = a + t * (p + t * (3 * (b - a) - 2 * p - q + t * (p + q - 2 * (b - a))));
    }
  }
  return { table, width, first, step };
}

/** A limb or a trunk through cross-sections, each [along, out, in, front, back, square, out of line, ahead of line]: the
 *  section's reach to four sides, the exponent of its super-ellipse and where its middle is. Place: (out, along, ahead). */
export function sections(rows) {
  const full = rows.map(([v, out, inn, front, back, square = 2.2, u = 0, w = 0]) => [v, out, inn, front, back, square, u, w]);
  const { table, width, first, step } = sample(full);
  const last = full[full.length - 1][0];
  return (u, v, w) => {
    const at = Math.min(Math.max((v - first) / step, 0), kSamples);
    const i = Math.floor(at);
    const t = at - i;
    const row = i * width;
    const value = (c) => table[row + c] + (table[row + width + c] - table[row + c]) * t;
    const du = u - value(6);
    const dw = w - value(7);
    const ru = du > 0 ? value(1) : value(2);
    const rw = dw > 0 ? value(3) : value(4);
    const n = value(5);
    const k = (Math.abs(du / ru) ** n + Math.abs(dw / rw) ** n) ** (1 / n);
    const across = k < 0.05 ? -Math.min(ru, rw) * (1 - k) : Math.hypot(du, dw) * (1 - 1 / k);
    const beyond = Math.max(first - v, v - last, 0);
    if (beyond === 0) return across;
    return across > 0 ? Math.hypot(across, beyond) : Math.max(across, -0.02) + beyond;
  };
}

export function smoothstep(from, to, x) {
  const t = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return t * t * (3 - 2 * t);
}
