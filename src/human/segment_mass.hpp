// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body.hpp>

#include "body/anthropometry.hpp"
#include "body/link_mass.hpp"
#include "human_frames.hpp"

namespace shigusa {

// Sole of a leg, or an average sole for that stature (m).
[[nodiscard]] SoleOutline sole_outline(const Landmarks::Leg& leg, double stature);

// Part of that sole ahead of the toes' joint.
[[nodiscard]] SoleOutline forefoot_outline(const Landmarks::Leg& leg, double stature);

// Multiple of an average head length above which a head is not to scale with the body.
inline constexpr double kBigHead = 1.5;
// Stature (m) of an average person with this trunk and these legs; mass and strength are scaled by
// it, so that the big head of a figure of `stature` (m) does not raise them.
[[nodiscard]] double stature_of_limbs(const Landmarks& person, double stature);

// Mass properties of a person's segments (de Leva's fractions on the measured lengths).
class SegmentMasses {
 public:
  SegmentMasses(const Landmarks& person, const HumanFrames& frames, const SegmentTable& table,
                double mass, double stature)
      : person_(person), frames_(frames), table_(table), mass_(mass), stature_(stature) {}

  [[nodiscard]] LinkMass foot(Side side) const;
  // the part of the foot ahead of the toes' joint
  [[nodiscard]] LinkMass forefoot(Side side) const;
  [[nodiscard]] LinkMass shank(Side side) const;
  [[nodiscard]] LinkMass thigh(Side side) const;
  [[nodiscard]] LinkMass trunk_and_head() const;
  // with the neck
  [[nodiscard]] LinkMass head() const;
  // Trunk between two shares (0..1, ascending) of the line from mid-hip to C7.
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
