// SPDX-License-Identifier: MIT
// Isotropic remeshing of an implicit surface to a target edge length: long edges are split, short ones collapsed, edges
// flipped towards six at each vertex, vertices moved to the centroid of their neighbours and projected onto the surface.
// Vertices in the plane x = 0 stay in it.

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const middle = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];

/** The field's slope. */
export function slopeOf(field, p, step = 4e-4) {
  const [x, y, z] = p;
  const a = field(x + step, y - step, z - step);
  const b = field(x - step, y - step, z + step);
  const c = field(x - step, y + step, z - step);
  const d = field(x + step, y + step, z + step);
  const scale = 1 / (4 * step);
  return [(a - b - c + d) * scale, (c - a - b + d) * scale, (b - a - c + d) * scale];
}

/** The place on the surface that is straight before `p`. */
export function ontoSurface(field, p, steps = 4) {
  let at = p;
  for (let k = 0; k < steps; ++k) {
    const value = field(at[0], at[1], at[2]);
    if (Math.abs(value) < 1e-7) break;
    const slope = slopeOf(field, at);
    const square = Math.max(dot(slope, slope), 0.05);
    const by = Math.min(Math.max(value / square, -0.02), 0.02);
    at = [at[0] - by * slope[0], at[1] - by * slope[1], at[2] - by * slope[2]];
  }
  return at;
}

export class Remesher {
  constructor(field, wanted, { positions, triangles }) {
    this.field = field;
    this.wanted = wanted; // target edge length at a place, m
    this.positions = positions;
    this.triangles = triangles; // null if removed
    this.around = positions.map(() => []); // a vertex's triangles
    triangles.forEach((triangle, t) => triangle.forEach((v) => this.around[v].push(t)));
    this.size = positions.map(wanted);
  }

  onBorder(v) {
    return this.positions[v][0] === 0;
  }

  /** Of the edge from a to b its triangles. */
  sharing(a, b) {
    return this.around[a].filter((t) => this.triangles[t].includes(b));
  }

  neighbours(v) {
    const found = new Set();
    for (const t of this.around[v]) for (const other of this.triangles[t]) if (other !== v) found.add(other);
    return found;
  }

  edges() {
    const found = [];
    this.triangles.forEach((triangle) => {
      if (!triangle) return;
      for (let k = 0; k < 3; ++k) {
        const [a, b] = [triangle[k], triangle[(k + 1) % 3]];
        if (a < b || this.sharing(a, b).length === 1) found.push([a, b]);
      }
    });
    return found;
  }

  target(a, b) {
    return Math.min(this.size[a], this.size[b]);
  }

  normal([a, b, c]) {
    const p = this.positions;
    return cross(minus(p[b], p[a]), minus(p[c], p[a]));
  }

  forget(v, t) {
    const list = this.around[v];
    list.splice(list.indexOf(t), 1);
  }

  replace(t, from, to) {
    this.triangles[t] = this.triangles[t].map((v) => (v === from ? to : v));
  }

  split() {
    let done = 0;
    for (const [a, b] of this.edges()) {
      const tris = this.sharing(a, b);
      if (tris.length === 0 || distance(this.positions[a], this.positions[b]) < (4 / 3) * this.target(a, b)) continue;
      const m = this.positions.length;
      const place = ontoSurface(this.field, middle(this.positions[a], this.positions[b]), 2);
      if (tris.length === 1) place[0] = 0;
      else if (place[0] <= 0) place[0] = 1e-4;
      this.positions.push(place);
      this.around.push([]);
      this.size.push(this.wanted(place));
      for (const t of tris) {
        const fresh = this.triangles.length;
        const third = this.triangles[t].find((v) => v !== a && v !== b);
        this.triangles.push(this.triangles[t].map((v) => (v === a ? m : v)));
        this.replace(t, b, m);
        this.forget(b, t);
        this.around[b].push(fresh);
        this.around[m].push(t, fresh);
        this.around[third].push(fresh);
      }
      ++done;
    }
    return done;
  }

  collapse() {
    let done = 0;
    for (const edge of this.edges()) {
      let [a, b] = edge;
      const tris = this.sharing(a, b);
      if (tris.length === 0 || distance(this.positions[a], this.positions[b]) > 0.8 * this.target(a, b)) continue;
      const [borderA, borderB] = [this.onBorder(a), this.onBorder(b)];
      if (borderA && borderB && tris.length === 2) continue;
      if (borderA && !borderB) [a, b] = [b, a]; // a is removed, b stays
      const ringA = this.neighbours(a);
      const common = [...this.neighbours(b)].filter((v) => ringA.has(v));
      if (common.length !== tris.length) continue;
      if (common.some((v) => this.around[v].length <= (this.onBorder(v) ? 2 : 3))) continue;
      const place = this.onBorder(b) && !(borderA && borderB) ? this.positions[b] : middle(this.positions[a], this.positions[b]);
      if ([...ringA, ...this.neighbours(b)].some((v) => distance(this.positions[v], place) > 1.33 * this.target(v, b))) continue;
      if (this.turnsOver(a, b, place) || this.turnsOver(b, a, place)) continue;
      for (const t of tris) {
        for (const v of this.triangles[t]) this.forget(v, t);
        this.triangles[t] = null;
      }
      for (const t of this.around[a]) {
        this.replace(t, a, b);
        this.around[b].push(t);
      }
      this.around[a] = [];
      this.positions[b] = place;
      ++done;
    }
    return done;
  }

  /** Whether a triangle of v, but those with `but`, would face another way with v at a place. */
  turnsOver(v, but, place) {
    return this.around[v].some((t) => {
      const triangle = this.triangles[t];
      if (triangle.includes(but)) return false;
      const before = this.normal(triangle);
      const old = this.positions[v];
      this.positions[v] = place;
      const after = this.normal(triangle);
      this.positions[v] = old;
      return dot(before, after) < 0.5 * Math.sqrt(dot(before, before) * dot(after, after));
    });
  }

  flip() {
    let done = 0;
    const wish = (v) => (this.onBorder(v) ? 4 : 6);
    const degree = (v) => this.around[v].length + (this.onBorder(v) ? 1 : 0);
    for (const [a, b] of this.edges()) {
      const tris = this.sharing(a, b);
      if (tris.length !== 2) continue;
      let [s, t] = tris;
      // s has a before b
      if (this.triangles[s][(this.triangles[s].indexOf(a) + 1) % 3] !== b) [s, t] = [t, s];
      const c = this.triangles[s].find((v) => v !== a && v !== b);
      const d = this.triangles[t].find((v) => v !== a && v !== b);
      if (c === d || this.sharing(c, d).length > 0) continue;
      const off = (da, db, dc, dd) => (degree(a) + da - wish(a)) ** 2 + (degree(b) + db - wish(b)) ** 2 + (degree(c) + dc - wish(c)) ** 2 + (degree(d) + dd - wish(d)) ** 2;
      if (off(-1, -1, 1, 1) >= off(0, 0, 0, 0)) continue;
      const [n1, n2] = [this.normal([a, d, c]), this.normal([d, b, c])];
      const [m1, m2] = [this.normal(this.triangles[s]), this.normal(this.triangles[t])];
      const sum = [m1[0] + m2[0], m1[1] + m2[1], m1[2] + m2[2]];
      const enough = (n) => dot(n, sum) > 0.75 * Math.sqrt(dot(n, n) * dot(sum, sum));
      if (!enough(n1) || !enough(n2)) continue;
      this.triangles[s] = [a, d, c];
      this.triangles[t] = [d, b, c];
      this.forget(b, s);
      this.forget(a, t);
      this.around[c].push(t);
      this.around[d].push(s);
      ++done;
    }
    return done;
  }

  relax() {
    const p = this.positions;
    const moved = p.map((place, v) => {
      if (this.around[v].length === 0) return place;
      const border = this.onBorder(v);
      let [x, y, z, n] = [0, 0, 0, 0];
      for (const other of this.neighbours(v)) {
        if (border && !(this.onBorder(other) && this.sharing(v, other).length === 1)) continue;
        const weight = 1 / this.size[other];
        x += weight * p[other][0];
        y += weight * p[other][1];
        z += weight * p[other][2];
        n += weight;
      }
      if (n === 0) return place;
      const by = minus([x / n, y / n, z / n], place);
      const slope = slopeOf(this.field, place);
      const out = dot(by, slope) / Math.max(dot(slope, slope), 1e-6);
      const next = place.map((value, k) => value + 0.6 * (by[k] - out * slope[k]));
      if (border) next[0] = 0;
      else next[0] = Math.max(next[0], 1e-4);
      const on = ontoSurface(this.field, next, 2);
      if (border) on[0] = 0;
      else on[0] = Math.max(on[0], 1e-4);
      return on;
    });
    this.positions = moved;
    this.size = moved.map(this.wanted);
  }

  run(rounds) {
    for (let round = 0; round < rounds; ++round) {
      while (this.split() > 50);
      while (this.collapse() > 50);
      while (this.flip() > 50);
      this.relax();
    }
    for (let k = 0; k < 3; ++k) {
      this.flip();
      this.relax();
    }
    return this.packed();
  }

  /** Without what is gone. */
  packed() {
    const order = new Map();
    const triangles = this.triangles.filter((t) => t !== null);
    for (const triangle of triangles) for (const v of triangle) if (!order.has(v)) order.set(v, order.size);
    const positions = [];
    for (const [v, place] of order) positions[place] = this.positions[v];
    return { positions, triangles: triangles.map((t) => t.map((v) => order.get(v))) };
  }
}
