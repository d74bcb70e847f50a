// SPDX-License-Identifier: MIT
#include <shigusa/human_body.hpp>
#include <shigusa/landmarks.hpp>

#include "body/anthropometry.hpp"
#include "person/measure_person.hpp"
#include "person_measurer.hpp"

namespace shigusa {

Vec3d toes_joint(const Landmarks::Leg& leg) {
  return leg.toes ? *leg.toes : leg.ankle + (leg.toe - leg.ankle) * kToesShare;
}

Vec3d grip_of(const Landmarks::Arm& arm) {
  return arm.grip.value_or(arm.wrist + (arm.fingertip - arm.wrist) * kGripFraction);
}

Vec3d Placement::to_world(const Vec3d& p) const {
  const Vec3d d = (p - origin) * unit;
  return {dot(d, left), dot(d, up), dot(d, ahead)};
}

Result<MeasuredPerson> measure_person(const Skeleton& skeleton,
                                      const std::vector<Transformd>& world, const HumanoidMap& map,
                                      const MeasureSettings& settings) {
  return PersonMeasurer(skeleton, world, map, settings.skin).measure(settings);
}

}  // namespace shigusa
