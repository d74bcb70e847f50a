// SPDX-License-Identifier: MIT
#include "robot_freedoms.hpp"

#include <fmt/format.h>

#include "body/anthropometry.hpp"
#include "core/index.hpp"
#include "math/axes.hpp"

namespace shigusa {

// A degree of freedom of a person's joint: positive angles turn the outer side about sign · axis.
struct PersonFreedom {
  const char* name;
  Axis axis;
  double sign;               // on the left side
  bool sided;                // turned round on the right
  const JointLimits* usual;  // a person's limits
};

using Freedoms = std::array<PersonFreedom, 3>;

namespace {

constexpr std::size_t kRight = 1;
constexpr std::size_t kMiddle = 2;
constexpr std::array<const char*, 3> kSidePrefixes{"left_", "right_", ""};

constexpr JointLimits kHardly{radians(-10), radians(10), 1, 1};
constexpr JointLimits kTrunkBend{radians(-25), radians(40), 1, 1};
constexpr JointLimits kTrunkTurn{radians(-20), radians(20), 1, 1};
constexpr JointLimits kHeadBend{radians(-45), radians(45), 1, 1};
constexpr JointLimits kCollar{radians(-15), radians(30), 1, 1};
constexpr JointLimits kTwist{radians(-80), radians(80), 1, 1};
constexpr JointLimits kWristBend{radians(-70), radians(70), 1, 1};
constexpr JointLimits kInversion{radians(-15), radians(35), 1, 1};

constexpr Freedoms kHip{{{"flexion", Axis::x, -1, false, &kHipFlexion},
                         {"abduction", Axis::z, 1, true, &kHipAbduction},
                         {"rotation", Axis::y, 1, true, &kHipRotation}}};
constexpr Freedoms kKnee{{{"flexion", Axis::x, 1, false, &kKneeFlexion},
                          {"abduction", Axis::z, 1, true, &kHardly},
                          {"rotation", Axis::y, 1, true, &kHardly}}};
constexpr Freedoms kAnkle{{{"flexion", Axis::x, -1, false, &kAnkleFlexion},
                           {"inversion", Axis::z, -1, true, &kInversion},
                           {"rotation", Axis::y, 1, true, &kHardly}}};
constexpr Freedoms kTrunk{{{"flexion", Axis::x, 1, false, &kTrunkBend},
                           {"lateral", Axis::z, -1, false, &kTrunkTurn},
                           {"rotation", Axis::y, 1, false, &kTrunkTurn}}};
constexpr Freedoms kNeck{{{"flexion", Axis::x, 1, false, &kHeadBend},
                          {"lateral", Axis::z, -1, false, &kHeadBend},
                          {"rotation", Axis::y, 1, false, &kHeadBend}}};
constexpr Freedoms kClavicle{{{"rotation", Axis::x, -1, false, &kHardly},
                              {"elevation", Axis::z, 1, true, &kCollar},
                              {"protraction", Axis::y, -1, true, &kCollar}}};
constexpr Freedoms kShoulder{{{"flexion", Axis::x, -1, false, &kShoulderFlexion},
                              {"abduction", Axis::z, 1, true, &kShoulderAbduction},
                              {"rotation", Axis::y, 1, true, &kShoulderRotation}}};
constexpr Freedoms kElbow{{{"flexion", Axis::x, -1, false, &kElbowFlexion},
                           {"abduction", Axis::z, 1, true, &kHardly},
                           {"rotation", Axis::y, 1, true, &kTwist}}};
constexpr Freedoms kWrist{{{"flexion", Axis::z, -1, true, &kWristBend},
                           {"deviation", Axis::x, -1, false, &kWristBend},
                           {"rotation", Axis::y, 1, true, &kHardly}}};

// Shortest rotation from one direction to another.
Mat3d shortest_turn(const Vec3d& from, const Vec3d& to) {
  const Vec3d v = cross(from, to);
  const double c = dot(from, to);
  if (c < -0.999999) return {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const double k = 1.0 / (1.0 + c);
  const auto column = [&](const Vec3d& e) { return e + cross(v, e) + cross(v, cross(v, e)) * k; };
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

}  // namespace

// A part of a limb: joints first … last (exclusive), with axes relative to `frame`.
struct JointNamer::Part {
  std::string name;
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t side = kMiddle;
  const Freedoms& freedoms;
  Mat3d frame{};
};

void JointNamer::name_spine(std::vector<PersonJoint>& joints) const { name_trunk(joints, false); }
void JointNamer::name_neck(std::vector<PersonJoint>& joints) const { name_trunk(joints, true); }

void JointNamer::name_leg(PersonLimb& leg, std::size_t side) const {
  // standing legs point down, with frames parallel to the world's
  name_part(leg.joints, {"hip", 0, leg.begins[1], side, kHip});
  name_part(leg.joints, {"knee", leg.begins[1], leg.begins[2], side, kKnee});
  name_part(leg.joints, {"ankle", leg.begins[2], leg.joints.size(), side, kAnkle});
}

void JointNamer::name_arm(PersonLimb& arm, std::size_t side, const Vec3d& upper_arm,
                          const Vec3d& forearm) const {
  const Vec3d down{0, -1, 0};
  const Mat3d upper_frame = shortest_turn(down, normalized(upper_arm));
  // relative to a hanging arm the forearm is flexed by the elbow, not rotated by the upper arm
  const Vec3d fore_in_upper = transpose_times(upper_frame, normalized(forearm));
  const Mat3d fore_frame = upper_frame * shortest_turn(down, fore_in_upper);
  name_part(arm.joints, {"clavicle", 0, arm.begins[1], side, kClavicle});
  name_part(arm.joints, {"shoulder", arm.begins[1], arm.begins[2], side, kShoulder, upper_frame});
  name_part(arm.joints, {"elbow", arm.begins[2], arm.begins[3], side, kElbow, fore_frame});
  bend_by_hinge(arm);
  name_part(arm.joints, {"wrist", arm.begins[3], arm.joints.size(), side, kWrist, fore_frame});
  // the T pose of a file already includes part of the abduction
  const double out = asin(clamp(abs(upper_arm.x) / norm(upper_arm), 0.0, 1.0));
  for (PersonJoint& j : arm.joints) {
    if (!j.part.ends_with("shoulder") || j.freedom != "abduction" || !j.usual) continue;
    for (double& limit : *j.usual) limit -= out;
  }
}

void JointNamer::name_part(std::vector<PersonJoint>& joints, const Part& part) const {
  for (std::size_t i = part.first; i < part.last; ++i) {
    joints[i].part = kSidePrefixes[part.side] + part.name;
    joints[i].freedom = robot_.joints[index(joints[i].joint)].name;
  }
  std::array<bool, 3> taken{};
  std::vector<bool> named(joints.size(), false);
  for (std::size_t round = 0; round < part.freedoms.size(); ++round) {
    constexpr double kLike = 0.6;
    double best = kLike;
    std::size_t which = 0;
    std::size_t freedom = part.freedoms.size();
    double turn = 1.0;
    for (std::size_t i = part.first; i < part.last; ++i) {
      const double outward = joints[i].outward ? 1.0 : -1.0;
      const Vec3d axis =
          transpose_times(part.frame, placed_.axis[index(joints[i].joint)]) * outward;
      for (std::size_t f = 0; f < part.freedoms.size(); ++f) {
        const double along = axis[static_cast<int>(part.freedoms[f].axis)];
        if (taken[f] || named[i] || abs(along) <= best) continue;
        best = abs(along);
        which = i;
        freedom = f;
        turn = along;
      }
    }
    if (freedom == part.freedoms.size()) return;
    taken[freedom] = true;
    named[which] = true;
    const PersonFreedom& f = part.freedoms[freedom];
    const bool other_way = f.sided && part.side == kRight;
    joints[which].freedom = f.name;
    joints[which].sign = (turn < 0.0 ? -1.0 : 1.0) * f.sign * (other_way ? -1.0 : 1.0);
    joints[which].usual = {f.usual->lower, f.usual->upper};
  }
}

void JointNamer::bend_by_hinge(PersonLimb& arm) const {
  PersonJoint* across = nullptr;
  for (std::size_t i = arm.begins[2]; i < arm.begins[3]; ++i) {
    if (arm.joints[i].freedom == "flexion") return;
    if (arm.joints[i].freedom == "abduction") across = &arm.joints[i];
  }
  if (across == nullptr) return;
  const Robot::Joint& hinge = robot_.joints[index(across->joint)];
  across->freedom = "flexion";
  across->sign = hinge.limited && hinge.upper < -hinge.lower ? -1.0 : 1.0;
  across->usual = {kElbowFlexion.lower, kElbowFlexion.upper};
}

void JointNamer::name_trunk(std::vector<PersonJoint>& joints, bool neck) const {
  const std::vector<std::string> parts =
      neck ? std::vector<std::string>{"neck", "head"}
           : std::vector<std::string>{"spine", "chest", "upper_chest"};
  std::size_t first = 0;
  for (std::size_t part = 0; first < joints.size(); ++part) {
    std::array<bool, 3> seen{};
    std::size_t last = first;
    for (; last < joints.size(); ++last) {
      const std::size_t along = index(main_axis(placed_.axis[index(joints[last].joint)]));
      if (seen[along]) break;
      seen[along] = true;
    }
    const std::string name =
        part < parts.size() ? parts[part] : fmt::format("{}_{}", parts.back(), part + 1);
    name_part(joints, {name, first, last, kMiddle, neck ? kNeck : kTrunk});
    first = last;
  }
}

}  // namespace shigusa
