// SPDX-License-Identifier: MIT
// make.mjs [FILE]: writes the studio's mannequin as one file. Sculpts a person as a smooth field, covers the left half
// with triangles, moves these onto the fields of a woman, a heavy and a light person, and computes the skin weights.
// The output is deterministic. Its reader is src/view/mannequin_file.ts.
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import { kStature, makeBody } from './body.mjs';
import { bones, measures, otherSide } from './bones.mjs';
import { packCorners, packNumbers, walk } from './pack.mjs';
import { paintOf } from './paint.mjs';
import { ontoSurface, Remesher } from './remesh.mjs';
import { wantedEdge } from './size.mjs';
import { skinOf } from './skin.mjs';
import { polygonise } from './surface.mjs';

const kBox = { low: [0, -0.02, -0.2], high: [0.86, 1.77, 0.24] }; // m
const kGrid = 0.0055; // m
const kRounds = 8;
const kMorphs = { female: { female: 1 }, heavy: { fat: 1 }, light: { fat: -1 } };
const kPaint = 0.0002; // m a step
const kStep = 2 ** -13; // m
const kShiftStep = 2 ** -12; // m
const kWeightSum = 85; // a third of 255

const body = makeBody();

function onto(field, place, steps) {
  const on = ontoSurface(field, place, steps);
  on[0] = place[0] === 0 ? 0 : Math.max(on[0], 1e-4);
  return on;
}

function makeMesh() {
  const net = polygonise(body.field, kBox.low, kBox.high, kGrid);
  net.positions = net.positions.map((place) => onto(body.field, place, 2));
  return new Remesher(body.field, wantedEdge, net).run(kRounds);
}

/** From the mesh to another person's field: shifts, smoothed once so that triangles stay even. */
function morph({ positions, triangles }, person) {
  const { field } = makeBody(person);
  const shifts = positions.map((place) => {
    const on = onto(field, place, 12);
    return on.map((value, k) => value - place[k]);
  });
  const around = positions.map(() => []);
  for (const [a, b, c] of triangles) {
    around[a].push(b, c);
    around[b].push(c, a);
    around[c].push(a, b);
  }
  return positions.map((place, v) => {
    const shift = shifts[v].map((own, k) => 0.5 * own + (0.5 * around[v].reduce((sum, other) => sum + shifts[other][k], 0)) / around[v].length);
    const on = onto(field, place[0] === 0 ? [0, place[1] + shift[1], place[2] + shift[2]] : place.map((value, k) => value + shift[k]), 6);
    return on.map((value, k) => value - place[k]);
  });
}

/** m³ that a closed surface holds, of which the mesh is one half. */
function volume({ triangles }, positions) {
  let sum = 0;
  for (const [a, b, c] of triangles) {
    const [p, q, r] = [positions[a], positions[b], positions[c]];
    sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return sum / 3;
}

const rounded = (value) => (typeof value === 'number' ? Number(value.toFixed(6)) : value);

/** Weights whose sum is kWeightSum, in the ratios of those of 255: what rounding leaves goes to the greatest. */
function shared(weights) {
  const parts = weights.map((weight) => Math.round((kWeightSum * weight) / 255));
  const greatest = weights.indexOf(Math.max(...weights));
  parts[greatest] += kWeightSum - parts.reduce((sum, part) => sum + part, 0);
  return parts;
}

/** The file's content, which is written deflated. */
export function makeFile() {
  const mesh = makeMesh();
  const skin = skinOf(body.parts, mesh);
  const morphs = Object.values(kMorphs).map((person) => morph(mesh, person));
  const names = Object.keys(kMorphs);
  const moved = (shifts) => mesh.positions.map((place, v) => place.map((value, k) => value + shifts[v][k]));
  const volumes = { male: volume(mesh, mesh.positions), ...Object.fromEntries(names.map((name, k) => [name, volume(mesh, moved(morphs[k]))])) };
  const count = mesh.positions.length;
  const head = {
    stature: kStature, vertices: count, triangles: mesh.triangles.length, step: kStep, morphs: names, shiftStep: kShiftStep, volumes, weightSum: kWeightSum,
    paint: kPaint, measures, bones, otherSide,
  };
  const json = Buffer.from(JSON.stringify(head, (_, value) => rounded(value)));
  const { corners, order } = walk(mesh.triangles, count);
  const paints = paintOf(body.parts, mesh);
  const weights = skin.map((one) => shared(one.weights));
  const numbers = (row) => packNumbers(corners, order.map(row));
  const size = Buffer.alloc(4);
  size.writeUInt32LE(json.length);
  return Buffer.concat([
    size, json, packCorners(corners),
    numbers((v) => mesh.positions[v].map((value) => Math.round(value / kStep))),
    numbers((v) => morphs.flatMap((one) => one[v].map((value) => Math.round(value / kShiftStep)))),
    numbers((v) => weights[v]),
    numbers((v) => paints[v].map((value) => Math.min(Math.max(Math.round(value / kPaint), -128), 127))),
    // unused entries of a vertex refer to the first bone
    Buffer.from([0, 1, 2, 3].flatMap((k) => order.map((v) => (weights[v][k] > 0 ? skin[v].indices[k] : 0)))),
  ]);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const path = process.argv[2] ?? fileURLToPath(new URL('../../data/mannequin.bin', import.meta.url));
  const file = deflateRawSync(makeFile(), { level: 9 });
  writeFileSync(path, file);
  console.log(`${path}: ${file.length} bytes`);
}
