// SPDX-License-Identifier: MIT
// The feet of a standing person, in one piece or bending at the toes, and the thighs of a seated
// one.
#include <algorithm>

#include "human/at_ease.hpp"
#include "human_builder.hpp"

namespace shigusa {
namespace {

// Share of the distance to the sole's edge that the centre of pressure may reach.
constexpr double kAcrossSole = 0.8;
// Contact area of a thigh on the seat: from behind the hip joint (share of the stature) to a share
// of the thigh's length, and its half breadth (share of the stature).
constexpr double kBehindHip = 0.06;
constexpr double kToKnee = 0.7;
constexpr double kHalfBreadth = 0.045;
// Height (m) above which soles bear no load.
constexpr double kOnTheFloor = 0.02;

}  // namespace

Vec3d HumanBuilder::in_link(const Vec3d& point, const Part& part) {
  return transpose_times(part.frame, point - part.origin);
}

void HumanBuilder::add_foot(Side side, const Part& part) {
  const std::string name = side_prefix(side) + "foot";
  Foot foot{.name = name, .node = name, .link = part.link, .centre = {}, .outline = {}};
  const SoleOutline sole = sole_outline(person_.leg(side), settings_.stature);
  std::vector<Vec3d> corners(sole.begin(), sole.end());
  if (settings_.extent == BodyExtent::half) {
    // the other foot, which is not drawn, carries weight too
    for (const Vec3d& corner : sole) corners.push_back(corner + shift_);
  }
  Vec3d sum{};
  for (const Vec3d& corner : corners) {
    foot.outline.push_back(in_link(corner, part));
    sum += foot.outline.back();
  }
  foot.centre = sum * (1.0 / static_cast<double>(corners.size()));
  if (person_.leg(side).sole) foot.centre += to_below_ankle(sole, side, part);
  if (settings_.heels) {
    foot.node = side_prefix(side) + "toes";
    foot.heel = heel_of(side, part);
  }
  body_.feet.push_back(std::move(foot));
}

// Vector from the middle of a sole, across it, to below the ankle, limited to the sole. Pressure
// there needs no lateral ankle torque.
Vec3d HumanBuilder::to_below_ankle(const SoleOutline& sole, Side side, const Part& part) const {
  const Vec3d middle = (sole[0] + sole[1] + sole[2] + sole[3]) * 0.25;
  const Vec3d half = (sole[0] + sole[1] - sole[2] - sole[3]) * 0.25;
  const double off = dot(person_.leg(side).ankle - middle, half) / dot(half, half);
  return transpose_times(part.frame, half * clamp(off, -kAcrossSole, kAcrossSole));
}

Heel HumanBuilder::heel_of(Side side, const Part& part) const {
  const SoleOutline sole = sole_outline(person_.leg(side), settings_.stature);
  Heel heel;
  heel.toes = freedom(side_prefix(side) + "toes.flexion");
  heel.ankle = freedom(side_prefix(side) + "ankle.flexion");
  heel.back = in_link((sole[1] + sole[2]) * 0.5, part);
  for (const Vec3d& corner : forefoot_outline(person_.leg(side), settings_.stature)) {
    heel.forefoot.push_back(in_link(corner, part));
    heel.forefoot_centre += heel.forefoot.back() * 0.25;
  }
  return heel;
}

void HumanBuilder::add_seat(Side side, const Part& thigh) {
  const Landmarks::Leg& leg = person_.leg(side);
  const double h = settings_.stature;
  const Vec3d to_knee = leg.knee - leg.hip;
  const Vec3d ahead = normalized(Vec3d{to_knee.x, 0.0, to_knee.z}, {0, 0, 1});
  const Vec3d across = Vec3d{ahead.z, 0.0, -ahead.x} * (kHalfBreadth * h);
  const Vec3d down{0.0, -kSeatedHip * h, 0.0};
  const Vec3d behind = leg.hip + down - ahead * (kBehindHip * h);
  const Vec3d front = leg.hip + down + ahead * (kToKnee * dot(to_knee, ahead));
  std::vector<Vec3d> corners{front + across, behind + across, behind - across, front - across};
  Foot seat;
  seat.name = side_prefix(side) + "upper_leg";
  seat.link = thigh.link;
  seat.node = seat.name;
  for (const Vec3d& corner : corners) seat.centre += in_link(corner, thigh) * 0.25;
  const SoleOutline sole = sole_outline(leg, h);
  if (sole[0].y < kOnTheFloor) corners.insert(corners.end(), sole.begin(), sole.end());
  for (const Vec3d& corner : corners) seat.outline.push_back(in_link(corner, thigh));
  body_.feet.push_back(std::move(seat));
}

int HumanBuilder::freedom(const std::string& name) const {
  const auto found = std::find_if(body_.dofs.begin(), body_.dofs.end(),
                                  [&](const Dof& dof) { return dof.name == name; });
  return static_cast<int>(found - body_.dofs.begin());
}

}  // namespace shigusa
