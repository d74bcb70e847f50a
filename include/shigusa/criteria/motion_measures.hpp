// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body/body_model.hpp>
#include <shigusa/criteria/collision.hpp>
#include <shigusa/criteria/support_margin.hpp>
#include <shigusa/motion/motion.hpp>
#include <string>
#include <vector>

namespace shigusa {

// What share of its strength a joint needs at most, and when.
struct JointLoad {
  int dof = 0;
  double torque = 0.0;  // N·m, then
  double share = 0.0;   // of the strength in its direction
  double time = 0.0;    // s
};
// (dofs) of a whole motion.
[[nodiscard]] std::vector<JointLoad> joint_loads(const BodyModel& body, const Motion& motion);

// A joint that passes its limit during a motion.
struct LimitExcess {
  std::string dof;
  double excess = 0.0;  // rad, the most at any frame
};
// The joints that pass their limits by more than anyone sees, the worst first.
[[nodiscard]] std::vector<LimitExcess> limit_excess(const BodyModel& body, const Clip& clip);

// What a motion asks of the body, generated or recorded.
struct MotionMeasures {
  std::vector<JointLoad> loads;             // (dofs)
  std::vector<LimitExcess> over_limit;      // the worst first
  std::optional<SupportMargins> support{};  // of a body that stands
  CollisionFound collides;  // the deepest at any frame, with itself, an obstacle or the floor
};
// Of a whole motion that is at rest before and after.
[[nodiscard]] MotionMeasures measure_motion(const BodyModel& body, const Motion& motion,
                                            const CollisionSettings& collision);
// The joint that needs most of its strength; null of a body without joints.
[[nodiscard]] const JointLoad* most_loaded(const MotionMeasures& measures);

}  // namespace shigusa
