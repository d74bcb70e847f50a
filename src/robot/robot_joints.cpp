// SPDX-License-Identifier: MIT
#include "robot_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "human/landmark_points.hpp"
#include "math/axes.hpp"
#include "robot_freedoms.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

constexpr std::array<const char*, 2> kSideWords{"left_", "right_"};

// Largest distance to the next joint of the same ankle or wrist, as a share of the limb's last
// segment.
constexpr double kOneAnkle = 0.15;
constexpr double kOneWrist = 0.6;
constexpr double kWithinForearm = 1.5;  // … of the upper arm
constexpr double kOneNeck = 0.15;       // … of the way from the chest

// A direction, replaced by a coordinate axis if it is nearly one.
Vec3d snapped(const Vec3d& v) {
  constexpr double kNearly = 0.995;
  for (int k = 0; k < 3; ++k) {
    if (abs(v[k]) < kNearly) continue;
    Vec3d axis{};
    axis[k] = v[k] < 0.0 ? -1.0 : 1.0;
    return axis;
  }
  return v;
}

class JointFinder {
 public:
  JointFinder(const Robot& robot, const HumanoidMap& map, const PlacedRobot& placed)
      : robot_(robot), map_(map), placed_(placed), namer_(robot, placed) {}

  Result<PersonJoints> find() {
    found_.pelvis = map_[Bone::hips];
    depth_.assign(robot_.links.size(), 0);
    for (std::size_t i = 1; i < depth_.size(); ++i) {
      depth_[i] = depth_[index(joint(placed_.carrier[i]).parent)] + 1;
    }
    found_.chest = meet(map_[Bone::left_upper_arm], map_[Bone::right_upper_arm]);
    for (std::size_t side = 0; side < 2; ++side) {
      SHG_TRY(find_leg(side));
      SHG_TRY(find_arm(side));
    }
    found_.spine = turning(found_.pelvis, found_.chest);
    namer_.name_spine(found_.spine);
    const int head = map_[Bone::head] >= 0 ? map_[Bone::head] : map_[Bone::neck];
    if (head >= 0) {
      const double neck = norm(at(head) - at(found_.chest));
      found_.neck = turning(found_.chest, end_of_joint(head, kOneNeck * neck));
    }
    namer_.name_neck(found_.neck);
    SHG_TRY(each_joint_has_one_place());
    return std::move(found_);
  }

 private:
  [[nodiscard]] const Robot::Joint& joint(int j) const { return robot_.joints[index(j)]; }
  [[nodiscard]] const Vec3d& centre(int j) const { return placed_.centre(robot_, j); }
  [[nodiscard]] const Vec3d& at(int link) const { return placed_.links[index(link)].translation; }
  [[nodiscard]] int parent(int link) const {
    const int carrier = placed_.carrier[index(link)];
    return carrier < 0 ? -1 : joint(carrier).parent;
  }

  [[nodiscard]] int meet(int a, int b) const {
    while (a != b) {
      int& deeper = depth_[index(a)] >= depth_[index(b)] ? a : b;
      deeper = parent(deeper);
    }
    return a;
  }

  // All joints between two links, from the first on.
  [[nodiscard]] std::vector<PersonJoint> joints_between(int from, int to) const {
    const int top = meet(from, to);
    std::vector<PersonJoint> joints;
    for (int i = from; i != top; i = parent(i)) {
      joints.push_back({.joint = placed_.carrier[index(i)], .outward = false});
    }
    const std::size_t up = joints.size();
    for (int i = to; i != top; i = parent(i))
      joints.push_back({.joint = placed_.carrier[index(i)]});
    std::reverse(joints.begin() + static_cast<long>(up), joints.end());
    return joints;
  }

  [[nodiscard]] std::vector<PersonJoint> turning(int from, int to) const {
    std::vector<PersonJoint> joints = joints_between(from, to);
    std::erase_if(joints, [&](const PersonJoint& j) { return !joint(j.joint).turns; });
    return joints;
  }

  // Outermost link beyond `link` moved by joints of the same ankle or wrist; fingers start with
  // several joints at once or are named, and toes are far away.
  [[nodiscard]] int end_of_joint(int link, double near) const {
    int end = link;
    for (;;) {
      std::vector<int> rigid{end};
      std::vector<int> next;
      for (std::size_t i = 0; i < rigid.size(); ++i) {
        for (const int j : placed_.below[index(rigid[i])]) {
          if (joint(j).turns) {
            if (!is_digit(robot_.links[index(joint(j).child)].name)) next.push_back(joint(j).child);
          } else {
            rigid.push_back(joint(j).child);
          }
        }
      }
      if (next.size() != 1 || norm(at(next[0]) - at(end)) > near) return end;
      end = next[0];
    }
  }

  // Number of turning joints on the chain to a limb's end that precede the one carrying `bone`, or
  // its descendants.
  [[nodiscard]] std::size_t before(const std::vector<PersonJoint>& joints, int from,
                                   int bone) const {
    const std::vector<PersonJoint> all = joints_between(from, bone);
    if (all.empty()) return 0;
    const bool carried = joint(all.back().joint).turns;
    std::size_t count = turning(from, bone).size();
    count = carried && count > 0 ? count - 1 : count;
    return std::min(count, joints.size());
  }

  // Assigns a joint at the start of a part that turns about the preceding segment to that segment:
  // robots have its rotation at its far end.
  void give_back_rotation(const std::vector<PersonJoint>& joints, const Vec3d& segment,
                          std::size_t begin, std::size_t end, std::size_t& boundary) const {
    constexpr double kAlong = 0.85;
    if (boundary + 1 >= end || boundary - begin >= 3) return;
    const Vec3d& axis = placed_.axis[index(joints[boundary].joint)];
    if (abs(dot(axis, normalized(segment))) > kAlong) ++boundary;
  }

  [[nodiscard]] Result<void> check(const PersonLimb& limb, const std::string& name,
                                   std::initializer_list<const char*> parts) const {
    std::size_t k = 0;
    for (const char* part : parts) {
      const std::size_t end = k + 1 < limb.begins.size() ? limb.begins[k + 1] : limb.joints.size();
      const bool needed = std::string_view(part) != "clavicle" && std::string_view(part) != "wrist";
      if (needed && limb.begins[k] >= end) {
        return fail(ErrorCode::unsupported, say("no_turning_joint", name + std::string(part)));
      }
      ++k;
    }
    return {};
  }

  // Fails if a joint belongs to two limbs: in some files the trunk is a child of a leg, or one arm
  // of the other.
  [[nodiscard]] Result<void> each_joint_has_one_place() const {
    std::vector<const char*> place(robot_.joints.size(), nullptr);
    const auto take = [&](const std::vector<PersonJoint>& joints,
                          const char* name) -> Result<void> {
      for (const PersonJoint& j : joints) {
        const char*& taken = place[index(j.joint)];
        if (taken != nullptr) {
          return fail(ErrorCode::unsupported, say("limb_of_two", joint(j.joint).name, taken, name));
        }
        taken = name;
      }
      return {};
    };
    SHG_TRY(take(found_.legs[0].joints, "left leg"));
    SHG_TRY(take(found_.legs[1].joints, "right leg"));
    SHG_TRY(take(found_.spine, "spine"));
    SHG_TRY(take(found_.neck, "neck"));
    SHG_TRY(take(found_.arms[0].joints, "left arm"));
    return take(found_.arms[1].joints, "right arm");
  }

  Result<void> find_leg(std::size_t side) {
    const auto [hip, knee, ankle] = kLimbBones[side];
    PersonLimb& leg = found_.legs[side];
    const double shank = norm(at(map_[ankle]) - at(map_[knee]));
    leg.end = end_of_joint(map_[ankle], kOneAnkle * shank);
    leg.joints = turning(found_.pelvis, leg.end);
    std::size_t to_knee = before(leg.joints, found_.pelvis, map_[knee]);
    std::size_t to_ankle = before(leg.joints, found_.pelvis, map_[ankle]);
    give_back_rotation(leg.joints, at(map_[knee]) - at(map_[hip]), 0, to_ankle, to_knee);
    leg.begins = {0, to_knee, to_ankle};
    SHG_TRY(check(leg, kSideWords[side], {"hip", "knee", "ankle"}));
    namer_.name_leg(leg, side);
    return {};
  }

  Result<void> find_arm(std::size_t side) {
    const auto [upper, elbow, hand] = kLimbBones[2 + side];
    PersonLimb& arm = found_.arms[side];
    const Vec3d forearm = at(map_[hand]) - at(map_[elbow]);
    const Vec3d upper_arm = at(map_[elbow]) - at(map_[upper]);
    // several joints within the forearm may precede the wrist
    arm.end =
        end_of_joint(map_[hand], max(kOneWrist * norm(forearm), kWithinForearm * norm(upper_arm)));
    arm.joints = turning(found_.chest, arm.end);
    std::size_t to_elbow = before(arm.joints, found_.chest, map_[elbow]);
    std::size_t to_wrist = before(arm.joints, found_.chest, map_[hand]);
    give_back_rotation(arm.joints, upper_arm, to_elbow >= 3 ? to_elbow - 3 : 0, to_wrist, to_elbow);
    if (to_wrist > to_elbow) {
      give_back_rotation(arm.joints, forearm, to_elbow, arm.joints.size() + 1, to_wrist);
    }
    to_wrist = std::min(to_wrist, arm.joints.size());
    // the shoulder has three degrees of freedom; joints before them elevate it
    const std::size_t ball = to_elbow >= 3 ? to_elbow - 3 : 0;
    const std::size_t to_shoulder = std::min(before(arm.joints, found_.chest, map_[upper]), ball);
    arm.begins = {0, to_shoulder, to_elbow, to_wrist};
    SHG_TRY(check(arm, kSideWords[side], {"clavicle", "shoulder", "elbow", "wrist"}));
    namer_.name_arm(arm, side, upper_arm, forearm);
    return {};
  }

  const Robot& robot_;
  const HumanoidMap& map_;
  const PlacedRobot& placed_;
  JointNamer namer_;
  std::vector<int> depth_;  // (links)
  PersonJoints found_;
};

}  // namespace

Result<PlacedRobot> place_robot(const Robot& robot, const HumanoidMap& map) {
  const std::vector<Transformd> places = robot_places(robot);
  const auto at = [&](Bone bone) { return places[index(map[bone])].translation; };
  const auto mid = [&](Bone a, Bone b) { return (at(a) + at(b)) * 0.5; };
  const Vec3d ankles = mid(Bone::left_foot, Bone::right_foot);
  const Vec3d rise = mid(Bone::left_upper_arm, Bone::right_upper_arm) - ankles;
  const Vec3d up = nearest_axis(rise);
  const Vec3d across = normalized(at(Bone::left_upper_leg) - at(Bone::right_upper_leg), {}) +
                       normalized(at(Bone::left_upper_arm) - at(Bone::right_upper_arm), {});
  const Vec3d level = across - up * dot(across, up);
  if (!(norm(level) > 0.2)) {
    return fail(ErrorCode::invalid_argument, say("robot_no_facing"));
  }
  const Vec3d left = snapped(normalized(level));
  const Mat3d to_world = transpose(Mat3d{left, up, cross(left, up)});
  PlacedRobot placed;
  for (const Transformd& place : places) {
    placed.links.push_back({to_world * place.rotation, to_world * (place.translation - ankles)});
  }
  placed.carrier.assign(robot.links.size(), -1);
  placed.below.resize(robot.links.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Robot::Joint& joint = robot.joints[j];
    placed.carrier[index(joint.child)] = static_cast<int>(j);
    placed.below[index(joint.parent)].push_back(static_cast<int>(j));
    placed.axis.push_back(placed.links[index(joint.child)].rotation * joint.axis);
  }
  return placed;
}

Result<PersonJoints> person_joints(const Robot& robot, const HumanoidMap& map,
                                   const PlacedRobot& placed) {
  return JointFinder(robot, map, placed).find();
}

}  // namespace shigusa
