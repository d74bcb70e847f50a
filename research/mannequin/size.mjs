// SPDX-License-Identifier: MIT
// Resolution of the mesh: target edge length at a place on the surface, m.
import { frames, joints, lengths } from './body.mjs';
import { smoothstep } from './field.mjs';

const kFine = { finger: 0.005, hand: 0.0085, face: 0.0068, skull: 0.0125, joint: 0.0125, foot: 0.0105, limb: 0.0165, trunk: 0.019 };

export function wantedEdge([x, y, z]) {
  if (y > joints.neck[1]) {
    const face = smoothstep(0.02, 0.06, z) * smoothstep(1.5, 1.52, y) * (1 - smoothstep(1.66, 1.69, y));
    const ear = 1 - smoothstep(0.03, 0.045, Math.hypot(x - 0.078, y - 1.627, z + 0.005));
    return kFine.skull + (kFine.face - kFine.skull) * Math.max(face, ear);
  }
  const [, v] = frames.arm.local(x, y, z);
  const hand = v - lengths.upper_arm - lengths.lower_arm;
  if (x > 0.3 && v > 0.1) {
    const elbow = 1 - smoothstep(0.03, 0.09, Math.abs(v - lengths.upper_arm));
    const limb = kFine.limb - 0.002 + (kFine.joint - kFine.limb + 0.002) * elbow;
    const palm = limb + (kFine.hand - limb) * smoothstep(-0.05, 0.01, hand);
    return palm + (kFine.finger - palm) * smoothstep(0.03, 0.085, hand);
  }
  if (y < 0.86) {
    const down = frames.leg.local(x, y, z)[1];
    const knee = 1 - smoothstep(0.04, 0.11, Math.abs(down - lengths.upper_leg));
    const limb = kFine.limb + (kFine.joint - kFine.limb) * knee;
    return limb + (kFine.foot - limb) * smoothstep(0.72, 0.82, down);
  }
  const shoulder = 1 - smoothstep(0.07, 0.14, Math.hypot(x - 0.2, y - 1.39));
  return kFine.trunk + (0.013 - kFine.trunk) * shoulder;
}
