// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body/anthropometry.hpp>
#include <shigusa/body/body_model.hpp>

#include "human_frames.hpp"

namespace shigusa {

// Mass of one or several segments in the start posture, in world coordinates: sums of segments
// stay exact and are brought into a link's frame at the end.
struct LinkMass {
  double mass = 0.0;                                    // kg
  Vec3d moment{};                                       // kg·m, mass × com
  Mat3d about_origin{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // kg·m², about the world's origin

  // `inertia`: kg·m², about the centre of mass `com` (m)
  [[nodiscard]] static LinkMass of(double mass, const Vec3d& com, const Mat3d& inertia);

  void add(const LinkMass& other);
  // a part of it
  void take_off(const LinkMass& part);
  // the same mass moved by a translation
  [[nodiscard]] LinkMass shifted(const Vec3d& by) const;
  [[nodiscard]] MassProperties in_frame(const Mat3d& frame, const Vec3d& origin) const;
};

// In the frame that the properties are in.
[[nodiscard]] LinkMass link_mass(const MassProperties& mass);
[[nodiscard]] LinkMass point_mass(double mass, const Vec3d& at);

// A leg's own sole, or that of a person of that stature (m).
[[nodiscard]] SoleOutline sole_outline(const Landmarks::Leg& leg, double stature);

// The same of what is ahead of the toes' joint.
[[nodiscard]] SoleOutline forefoot_outline(const Landmarks::Leg& leg, double stature);

// The segments of a person as masses (de Leva's fractions on the measured lengths).
class SegmentMasses {
 public:
  SegmentMasses(const Landmarks& person, const HumanFrames& frames, const SegmentTable& table,
                double mass, double stature)
      : person_(person), frames_(frames), table_(table), mass_(mass), stature_(stature) {}

  [[nodiscard]] LinkMass foot(Side side) const;
  // what of the foot is ahead of the toes' joint
  [[nodiscard]] LinkMass forefoot(Side side) const;
  [[nodiscard]] LinkMass shank(Side side) const;
  [[nodiscard]] LinkMass thigh(Side side) const;
  [[nodiscard]] LinkMass trunk_and_head() const;
  // with the neck
  [[nodiscard]] LinkMass head() const;
  // The trunk between two shares (0..1, rising) of the way from between the hips to C7.
  [[nodiscard]] LinkMass trunk_slice(double from, double to) const;
  [[nodiscard]] LinkMass upper_arm(Side side) const;
  [[nodiscard]] LinkMass forearm(Side side) const;
  [[nodiscard]] LinkMass hand(Side side) const;
  [[nodiscard]] LinkMass forearm_and_hand(Side side) const;
  [[nodiscard]] LinkMass arm(Side side) const;

 private:
  [[nodiscard]] LinkMass segment(const SegmentParameters& p, const Vec3d& from, const Vec3d& to,
                                 const Vec3d& left) const;

  const Landmarks& person_;
  const HumanFrames& frames_;
  const SegmentTable& table_;
  double mass_;
  double stature_;
};

}  // namespace shigusa
