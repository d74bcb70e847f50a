// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body.hpp>

#include "body/anthropometry.hpp"
#include "body/link_mass.hpp"
#include "human_frames.hpp"

namespace shigusa {

// A leg's own sole, or that of a person of that stature (m).
[[nodiscard]] SoleOutline sole_outline(const Landmarks::Leg& leg, double stature);

// The part of that sole ahead of the toes' joint.
[[nodiscard]] SoleOutline forefoot_outline(const Landmarks::Leg& leg, double stature);

// A head longer than this many times a person's says nothing of the body below it.
inline constexpr double kBigHead = 1.5;
// The stature (m) of a person whose trunk and legs are these: by it go mass and strength, which the
// big head of a figure of `stature` (m) does not raise.
[[nodiscard]] double stature_of_limbs(const Landmarks& person, double stature);

// The segments of a person as masses (de Leva's fractions on the measured lengths).
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
