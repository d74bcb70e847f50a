// SPDX-License-Identifier: MIT
// Paint of the mannequin as smooth functions on the skin, m: signed distances inside the darker joints, inside the
// visor, and past the seam at a limb's root.
import { frames, joints, lengths } from './body.mjs';
import { smoothstep } from './field.mjs';
import { armShare, belowGroin, headShare } from './skin.mjs';

const kFar = -0.05;

function waist(x, y, z) {
  const front = smoothstep(-0.04, 0.06, z);
  const side = Math.min(Math.abs(x) / 0.14, 1);
  const ribs = 1.165 + (0.052 * (1 - side * side) - 0.012 * side) * front;
  const rim = 1.03 + 0.022 * side * side - 0.045 * (1 - side * side) * front;
  return Math.min(ribs - y, y - rim);
}

/** Inside of the joints' colour. */
function jointPaint(x, y, z, arm) {
  if (arm > 0.6) {
    const f = frames.arm.local(x, y, z)[1] - lengths.upper_arm;
    return Math.max(0.026 - Math.abs(f), 0.0105 - Math.abs(f - lengths.lower_arm + 0.004));
  }
  if (y < 0.75) {
    const s = frames.leg.local(x, y, z)[1] - lengths.upper_leg;
    return Math.max(0.034 - Math.abs(s + 0.004), 0.014 - Math.abs(s - lengths.lower_leg + 0.03));
  }
  if (y > 1.4) return Math.min(0.054 * (0.44 - headShare(y, z)), y + 0.3 * z - 1.487, 0.13 - x);
  return waist(x, y, z);
}

/** Inside of the visor over the eyes. */
function visorPaint(x, y, z) {
  if (y < 1.56) return kFar;
  const around = Math.atan2(x, z + 0.005);
  const half = 0.0175 - 0.0075 * smoothstep(0.35, 1.25, around);
  const middle = 1.634 + 0.0045 * smoothstep(0.2, 1.2, around);
  const nose = 0.0085 * (1 - smoothstep(0, 0.2, around));
  return Math.min(half - Math.abs(y - middle) - (y < middle ? nose : 0), 0.075 * (1.32 - around));
}

/** Past the seam between trunk and limb, which lies in a plane. */
function seamPaint(parts, x, y, z, arm) {
  if (arm < 0.5 && y < 1.15) return belowGroin(x, y, z) + 0.012;
  const [u, v] = frames.arm.local(x, y, z);
  return parts.trunk(x, y, z) < parts.arm(x, y, z) ? Math.min(v + 0.83 * u - 0.055, -0.02) : v + 0.83 * u - 0.055;
}

function paintAt(parts, [x, y, z]) {
  const arm = y > joints.hips[1] - 0.3 ? armShare(parts, x, y, z) : 0;
  return [jointPaint(x, y, z, arm), visorPaint(x, y, z), seamPaint(parts, x, y, z, arm)];
}

/** Of each vertex three distances. */
export const paintOf = (parts, { positions }) => positions.map((place) => paintAt(parts, place));
