// SPDX-License-Identifier: MIT
// Skin weights of the bones at a place of the skin: smooth over each joint, with helper bones that turn by a part.
import { fingers, frames, lengths } from './body.mjs';
import { boneOf, bones } from './bones.mjs';
import { smoothstep } from './field.mjs';

const mix = (low, high, t) => low + (high - low) * t;

/** How far a place belongs to arm and leg, from 0 to 1. */
export function armShare(parts, x, y, z) {
  const [, v] = frames.arm.local(x, y, z);
  if (x < 0.1) return 0;
  const toArm = parts.arm(x, y, z);
  const beside = smoothstep(-0.012, 0.03, parts.trunk(x, y, z) - toArm);
  return smoothstep(-0.045, 0.085, v) * mix(beside, 1 - smoothstep(0.01, 0.03, toArm), smoothstep(0.09, 0.14, v));
}

/** How far below the groin's line a place is, m. */
export function belowGroin(x, y, z) {
  const [u, v, w] = frames.leg.local(x, y, z);
  return v - 0.008 + 0.42 * u - 0.1 * Math.max(-w, 0);
}

const legShare = (x, y, z) => smoothstep(-0.085, 0.085, belowGroin(x, y, z));

export const headShare = (y, z) => smoothstep(1.532, 1.586, y + 0.75 * z);

/** Shares of the bones before, about and after a joint, by how far it is passed (0 to 1). */
const three = (t) => [(1 - t) ** 2, 2 * t * (1 - t), t * t];

function addTrunk(add, share, x, y, z) {
  const carried = share * smoothstep(0.045, 0.16, x) * smoothstep(1.27, 1.4, y);
  add('shoulder', carried);
  let rest = share - carried;
  const head = headShare(y, z);
  add('head', rest * head);
  rest *= 1 - head;
  const steps = [
    ['neck', smoothstep(1.45, 1.54, y + 0.35 * z)], ['upper_chest', smoothstep(1.265, 1.41, y)], ['chest', smoothstep(1.115, 1.27, y)], ['spine', smoothstep(0.955, 1.085, y)],
  ];
  for (const [bone, t] of steps) {
    add(bone, rest * t);
    rest *= 1 - t;
  }
  add('hips', rest);
}

function addHand(add, share, place) {
  let nearest = null;
  for (const [name, { joints: line, radii }] of Object.entries(fingers)) {
    for (let k = 0; k < 3; ++k) {
      const way = line[k + 1].map((value, c) => value - line[k][c]);
      const long = Math.hypot(...way);
      const off = place.map((value, c) => value - line[k][c]);
      const t = Math.min(Math.max(off.reduce((sum, value, c) => sum + value * way[c], 0) / (long * long), k === 0 ? -1 : 0), 1);
      const distance = Math.hypot(...off.map((value, c) => value - t * way[c])) - radii[k];
      if (nearest === null || distance < nearest.distance) nearest = { name, distance, k, passed: t * long, long };
    }
  }
  const { name, k, passed, long } = nearest;
  const wide = name === 'thumb' && k === 0 ? 0.02 : k === 0 ? 0.013 : 0.0065;
  const joint = ['proximal', 'intermediate', 'distal'];
  const into = smoothstep(-wide, wide, passed);
  const beyond = k < 2 ? smoothstep(-0.0065, 0.0065, passed - long) : 0;
  add(k === 0 ? 'hand' : `${name}_${joint[k - 1]}`, share * (1 - into));
  add(`${name}_${joint[k]}`, share * into * (1 - beyond));
  if (k < 2) add(`${name}_${joint[k + 1]}`, share * into * beyond);
}

/** A limb's upper or lower part, whose turn about itself grows along it. */
function addRolled(add, share, bone, along) {
  add(`${bone}_swing`, share * Math.max(1 - 2 * along, 0));
  add(`${bone}_roll`, share * (1 - Math.abs(2 * along - 1)));
  add(bone, share * Math.max(2 * along - 1, 0));
}

function addArm(add, share, [x, y, z]) {
  const [u, v, w] = frames.arm.local(x, y, z);
  const f = v - lengths.upper_arm;
  const h = f - lengths.lower_arm;
  const [upper, half, lower] = three(smoothstep(-0.045, 0.045, f));
  addRolled(add, share * upper, 'upper_arm', smoothstep(0.02, lengths.upper_arm - 0.03, v));
  add('lower_arm_half', share * half);
  const hand = smoothstep(-0.022, 0.022, h);
  addRolled(add, share * lower * (1 - hand), 'lower_arm', smoothstep(0.02, lengths.lower_arm - 0.02, f));
  if (hand > 0) addHand(add, share * lower * hand, [u, h, w]);
}

function addLeg(add, share, [x, y, z]) {
  const [, v, w] = frames.leg.local(x, y, z);
  const s = v - lengths.upper_leg;
  const a = s - lengths.lower_leg;
  const [upper, half, lower] = three(smoothstep(-0.06, 0.06, s));
  add('upper_leg', share * upper);
  add('lower_leg_half', share * half);
  const foot = smoothstep(-0.05, 0.025, a + 0.25 * w);
  const toes = smoothstep(-0.022, 0.022, w - lengths.foot) * foot;
  add('lower_leg', share * lower * (1 - foot));
  add('foot', share * lower * (foot - toes));
  add('toes', share * lower * toes);
}

/** A row of shares, one for each bone, at a place on the left half. */
function sharesAt(parts, place) {
  const [x, y, z] = place;
  const row = new Float64Array(bones.length);
  const add = (name, share) => {
    if (share > 0) row[boneOf(name)] += share;
  };
  const arm = y > 0.6 ? armShare(parts, x, y, z) : 0;
  const onLeg = arm > 0.5 || y > 1.2 ? 0 : legShare(x, y, z);
  const leg = onLeg * smoothstep(0, 0.035, x);
  const [trunk, shoulder, limb] = three(arm);
  const [pelvis, hip, thigh] = three(leg);
  add('upper_arm_half', shoulder);
  if (limb > 0) addArm(add, limb, place);
  add('upper_leg_half', trunk * hip);
  if (thigh > 0) addLeg(add, trunk * thigh, place);
  addTrunk(add, trunk * pelvis, x, y, z);
  return row;
}

const kRounds = 8;
const kKept = 4;

/** Indices and weights, four to a vertex, of 255 in all. */
export function skinOf(parts, { positions, triangles }) {
  let rows = positions.map((place) => sharesAt(parts, place));
  const around = positions.map(() => new Set());
  for (const [a, b, c] of triangles) {
    around[a].add(b).add(c);
    around[b].add(a).add(c);
    around[c].add(a).add(b);
  }
  for (let round = 0; round < kRounds; ++round) {
    rows = rows.map((row, v) => {
      if (positions[v][0] === 0) return row;
      const [, along] = frames.hand.local(...positions[v]);
      const hand = positions[v][0] > 0.4 && along > 0;
      const pull = hand ? 0.12 : 0.5;
      const next = row.map((share) => share * (1 - pull));
      for (const other of around[v]) rows[other].forEach((share, k) => (next[k] += (pull * share) / around[v].size));
      return next;
    });
  }
  return rows.map((row) => {
    const kept = [...row.keys()].sort((a, b) => row[b] - row[a] || a - b).slice(0, kKept);
    const sum = kept.reduce((total, k) => total + row[k], 0);
    const weights = kept.map((k) => Math.round((255 * row[k]) / sum));
    weights[0] += 255 - weights.reduce((total, weight) => total + weight, 0);
    return { indices: kept.map((k, slot) => (weights[slot] > 0 ? k : 0)), weights };
  });
}

