// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body_model.hpp>
#include <shigusa/criteria.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/transform.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

/// The share of its strength that a joint needs at most, and when.
struct JointLoad {
  int dof = 0;          ///< freedom of the body
  double torque = 0.0;  ///< N·m, then
  double share = 0.0;   ///< of the strength in its direction
  double time = 0.0;    ///< s
};
/// (dofs) the loads of a whole motion.
[[nodiscard]] std::vector<JointLoad> joint_loads(const BodyModel& body, const Motion& motion);

/// A joint that passes its limit during a motion.
struct LimitExcess {
  std::string dof;      ///< name of the freedom
  double excess = 0.0;  ///< rad, the most at any frame
};
/// The joints that pass their limits by more than anyone sees, the worst first.
[[nodiscard]] std::vector<LimitExcess> limit_excess(const BodyModel& body, const Clip& clip);

/// (nodes) X_WN, the place of each node of the body in the world, by its angles: (dofs) rad.
[[nodiscard]] std::vector<Transformd> node_places(const BodyModel& body,
                                                  std::span<const double> angles);

/// (frames) m, on the floor: the centre of pressure of a whole motion that is at rest before and
/// after, of a body on the feet that stand. Where nothing presses, it is that of a force of 1 N.
[[nodiscard]] std::vector<Vec3d> centres_of_pressure(const BodyModel& body, const Motion& motion);

/// How far (m) inside the support polygon something stays at least, less than 0 outside it, and
/// when (s, from the motion's beginning).
struct SupportMargin {
  double distance = 0.0;  ///< m
  double time = 0.0;      ///< s
};

/// Whether a person could stand through a motion: the plumb line of the centre of mass, and the
/// floor's centre of pressure, both against the support polygon. The pressure's is the moment (N·m)
/// by which the body is held from tipping, over its weight: where the floor bears that weight, the
/// distance of the centre of pressure; no floor gives less than 0. Motions faster than gravity let
/// it leave the feet for a moment; a centre of mass that leaves them is a fall or a step.
struct SupportMargins {
  SupportMargin centre_of_mass;  ///< of its plumb line
  SupportMargin pressure;        ///< of the centre of pressure
};

/// Both in one frame (m, inside the support polygon; less than 0 outside).
struct SupportFrame {
  double centre_of_mass = 0.0;  ///< m, of its plumb line
  double pressure = 0.0;        ///< m, of the centre of pressure
};

/// (frames) both in each frame of a whole motion that is at rest before and after. None of a body
/// without feet, or with feet of no size.
[[nodiscard]] std::vector<SupportFrame> support_frames(const BodyModel& body, const Motion& motion);
/// The least of both in such a motion; nothing where support_frames has none.
[[nodiscard]] std::optional<SupportMargins> support_margins(const BodyModel& body,
                                                            const Motion& motion);

/// Flesh gives way by so much (m): less is no collision.
inline constexpr double kCollisionDepth = 0.005;
/// Greater depths in flesh are impossible (m).
inline constexpr double kFleshDepth = 0.02;
/// Greater depths in an obstacle are impossible (m): of both, only the body yields.
inline constexpr double kHardDepth = 0.01;

/// Where a motion collides most.
struct CollisionFound {
  double depth = 0.0;  ///< m, beyond what the start posture has; 0 where nothing collides
  std::string limb;    ///< capsule, "right_forearm"
  std::string other;   ///< capsule, obstacle or "floor"
  double time = 0.0;   ///< s
  bool hard = false;   ///< `other` is an obstacle
};
/// Finds the deepest collision of a body in a clip: arms with the body, any part with obstacles,
/// arms that have a wrist with the floor.
[[nodiscard]] CollisionFound deepest_collision(const BodyModel& body, const Clip& clip,
                                               const CollisionSettings& settings = {});

/// How suddenly a motion changes at most from one of its frames to the next, as if it had 60 of
/// them. A person sees a jolt where the floor's centre of pressure moves by more than 3 cm then, or
/// a torque by more than 30 % of its joint's strength both ways together.
struct Suddenness {
  double pressure = 0.0;  ///< m, by which the centre of pressure moves; 0 of a body without feet
  double torque = 0.0;    ///< share of the strength, by which a torque changes

  /// Whether the motion jolts.
  [[nodiscard]] bool jolts() const;
};
/// Measures a whole motion that is at rest before and after.
[[nodiscard]] Suddenness suddenness(const BodyModel& body, const Motion& motion);

/// The demands of a motion, generated or recorded, on its body.
struct MotionMeasures {
  std::vector<JointLoad> loads;             ///< (dofs)
  std::vector<LimitExcess> over_limit;      ///< the worst first
  std::optional<SupportMargins> support{};  ///< of a body that stands
  CollisionFound collides;  ///< the deepest at any frame, with itself, an obstacle or the floor
  Suddenness sudden;        ///< the most from frame to frame
};
/// Measures a whole motion that is at rest before and after.
[[nodiscard]] MotionMeasures measure_motion(const BodyModel& body, const Motion& motion,
                                            const CollisionSettings& collision);
/// The joint that needs most of its strength; null of a body without joints.
[[nodiscard]] const JointLoad* most_loaded(const MotionMeasures& measures);

}  // namespace shigusa
