// SPDX-License-Identifier: MIT
// The feet of a standing person, in one piece or bending at the toes.
#include <algorithm>

#include "human_builder.hpp"

namespace shigusa {
namespace {

// How far to a sole's edge its pressure goes.
constexpr double kAcrossSole = 0.8;

}  // namespace

Vec3d HumanBuilder::in_link(const Vec3d& point, const Part& part) {
  return transpose_times(part.frame, point - part.origin);
}

void HumanBuilder::set_foot_masses(Side side) {
  const LegParts& parts = legs_[index_of(side)];
  LinkMass foot = masses_.foot(side);
  if (settings_.heels) {
    const LinkMass toes = masses_.forefoot(side);
    foot.take_off(toes);
    set_mass(parts.toes, toes);
  }
  set_mass(parts.foot, foot);
}

// The part beyond the toes' joint from where it is climbed.
HumanBuilder::Part HumanBuilder::add_toes(Side side, const Part& on, double sign) {
  Part part = add_joint(prefix_of(side) + "toes", on, toes_joint(person_.leg(side)), on.frame,
                        {{"flexion", Axis::x, sign, kToesFlexion}});
  body_.dofs.back().give = kToesGive;
  return part;
}

void HumanBuilder::add_foot(Side side, const Part& part) {
  const std::string name = prefix_of(side) + "foot";
  Foot foot{.name = name, .node = name, .link = part.link, .centre = {}, .outline = {}};
  const SoleOutline sole = sole_outline(person_.leg(side), settings_.stature);
  std::vector<Vec3d> corners(sole.begin(), sole.end());
  if (settings_.extent == BodyExtent::half) {
    // the sole of the foot that is not drawn carries weight too
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
    foot.node = prefix_of(side) + "toes";
    foot.heel = heel_of(side, part);
  }
  body_.feet.push_back(std::move(foot));
}

// From the middle of a sole across it to below the ankle, as far as the sole goes: a person presses
// there, where that asks nothing of the ankle.
Vec3d HumanBuilder::to_below_ankle(const SoleOutline& sole, Side side, const Part& part) const {
  const Vec3d middle = (sole[0] + sole[1] + sole[2] + sole[3]) * 0.25;
  const Vec3d half = (sole[0] + sole[1] - sole[2] - sole[3]) * 0.25;
  const double off = dot(person_.leg(side).ankle - middle, half) / dot(half, half);
  return transpose_times(part.frame, half * clamp(off, -kAcrossSole, kAcrossSole));
}

Heel HumanBuilder::heel_of(Side side, const Part& part) const {
  const SoleOutline sole = sole_outline(person_.leg(side), settings_.stature);
  Heel heel;
  heel.toes = freedom(prefix_of(side) + "toes.flexion");
  heel.ankle = freedom(prefix_of(side) + "ankle.flexion");
  heel.back = in_link((sole[1] + sole[2]) * 0.5, part);
  for (const Vec3d& corner : forefoot_outline(person_.leg(side), settings_.stature)) {
    heel.forefoot.push_back(in_link(corner, part));
    heel.forefoot_centre += heel.forefoot.back() * 0.25;
  }
  return heel;
}

int HumanBuilder::freedom(const std::string& name) const {
  const auto found = std::find_if(body_.dofs.begin(), body_.dofs.end(),
                                  [&](const Dof& dof) { return dof.name == name; });
  return static_cast<int>(found - body_.dofs.begin());
}

}  // namespace shigusa
