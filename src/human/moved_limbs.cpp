// SPDX-License-Identifier: MIT
#include "moved_limbs.hpp"

#include "human_frames.hpp"
#include "landmark_points.hpp"

namespace shigusa {

void move_upper_body(Landmarks& person, const Vec3d& by) {
  person.neck += by;
  person.head_top += by;
  for (Vec3d& joint : person.spine) joint += by;
  if (person.head) *person.head += by;
  for (const Side side : kBothSides) {
    Landmarks::Arm& arm = person.arm(side);
    for (Vec3d* p : {&arm.shoulder, &arm.elbow, &arm.wrist, &arm.fingertip}) *p += by;
    if (arm.clavicle) *arm.clavicle += by;
    if (arm.grip) *arm.grip += by;
  }
}

void move_foot(Landmarks::Leg& leg, const Vec3d& was) {
  const Vec3d by = leg.ankle - was;
  leg.toe += by;
  if (leg.toes) *leg.toes += by;
  if (!leg.sole) return;
  for (Vec3d& corner : *leg.sole) corner += by;
}

void lay_arms(Landmarks& person, const Landmarks& before, const Vec3d& upper_arm,
              const Vec3d& forearm, double outwards) {
  const HumanFrames frames = human_frames(before);
  for (const Side side : kBothSides) {
    const Landmarks::Arm& was = before.arm(side);
    Landmarks::Arm& arm = person.arm(side);
    const Mat3d raised = rotation(Axis::z, side_sign(side) * outwards);
    arm.elbow = arm.shoulder + raised * upper_arm * norm(was.elbow - was.shoulder);
    arm.wrist = arm.elbow + raised * forearm * norm(was.wrist - was.elbow);
  }
  const HumanFrames after = human_frames(person);
  for (const Side side : kBothSides) {
    const Landmarks::Arm& was = before.arm(side);
    Landmarks::Arm& arm = person.arm(side);
    const Mat3d turn = along_segment(after.arm(side).forearm, arm.elbow, arm.wrist) *
                       transpose(along_segment(frames.arm(side).forearm, was.elbow, was.wrist));
    arm.fingertip = arm.wrist + turn * (was.fingertip - was.wrist);
    if (was.grip) arm.grip = arm.wrist + turn * (*was.grip - was.wrist);
  }
}

}  // namespace shigusa
