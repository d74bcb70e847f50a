// SPDX-License-Identifier: MIT
#include "robot_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/body/anthropometry.hpp>

namespace shigusa {
namespace {

using Bone = HumanoidBone;

constexpr std::array<std::array<Bone, 3>, 2> kLegs{
    {{Bone::left_upper_leg, Bone::left_lower_leg, Bone::left_foot},
     {Bone::right_upper_leg, Bone::right_lower_leg, Bone::right_foot}}};
constexpr std::array<std::array<Bone, 3>, 2> kArms{
    {{Bone::left_upper_arm, Bone::left_lower_arm, Bone::left_hand},
     {Bone::right_upper_arm, Bone::right_lower_arm, Bone::right_hand}}};
constexpr std::array<const char*, 2> kSideWords{"left_", "right_"};

// The next joint of an ankle or wrist is no further away than this share of the limb's last
// segment.
constexpr double kOneAnkle = 0.15;
constexpr double kOneWrist = 0.6;
constexpr double kOneNeck = 0.15;  // … of the way from the chest

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The coordinate axis that a direction all but is, else the direction.
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

// A freedom of a person's joint: positive angles turn the outer side about sign · axis.
struct Freedom {
  const char* name;
  Axis axis;
  double sign;               // on the left side
  bool sided;                // the other way round on the right
  const JointLimits* usual;  // nullptr: hardly any
};

constexpr JointLimits kHardly{radians(-10), radians(10), 1, 1};
constexpr JointLimits kTrunkBend{radians(-25), radians(40), 1, 1};
constexpr JointLimits kTrunkTurn{radians(-20), radians(20), 1, 1};
constexpr JointLimits kHeadBend{radians(-45), radians(45), 1, 1};
constexpr JointLimits kCollar{radians(-15), radians(30), 1, 1};
constexpr JointLimits kTwist{radians(-80), radians(80), 1, 1};
constexpr JointLimits kWristBend{radians(-70), radians(70), 1, 1};
constexpr JointLimits kInversion{radians(-15), radians(35), 1, 1};

using Freedoms = std::array<Freedom, 3>;
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

// Whether a link is part of a gripper or a finger, by its name.
bool is_digit(std::string name) {
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const char* word : {"grip", "finger", "thumb", "jaw"}) {
    if (name.find(word) != name.npos) return true;
  }
  return false;
}

// The rotation that takes the direction `from` to `to` by the shortest way.
Mat3d shortest_turn(const Vec3d& from, const Vec3d& to) {
  const Vec3d v = cross(from, to);
  const double c = dot(from, to);
  if (c < -0.999999) return {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const double k = 1.0 / (1.0 + c);
  const auto column = [&](const Vec3d& e) { return e + cross(v, e) + cross(v, cross(v, e)) * k; };
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

class JointFinder {
 public:
  JointFinder(const Robot& robot, const HumanoidMap& map, const PlacedRobot& placed)
      : robot_(robot), map_(map), placed_(placed) {}

  Result<PersonJoints> find() {
    found_.pelvis = map_[Bone::hips];
    depth_.assign(robot_.links.size(), 0);
    for (std::size_t i = 1; i < depth_.size(); ++i) {
      depth_[i] = depth_[index(joint(placed_.carrier[i]).parent)] + 1;
    }
    found_.chest = meet(map_[Bone::left_upper_arm], map_[Bone::right_upper_arm]);
    for (std::size_t side = 0; side < 2; ++side) {
      if (const auto done = find_leg(side); !done) return tl::unexpected(done.error());
      if (const auto done = find_arm(side); !done) return tl::unexpected(done.error());
    }
    found_.spine = turning(found_.pelvis, found_.chest);
    name_trunk(found_.spine, {"spine", "chest", "upper_chest"}, kTrunk);
    const int head = map_[Bone::head] >= 0 ? map_[Bone::head] : map_[Bone::neck];
    if (head >= 0) {
      const double neck = norm(at(head) - at(found_.chest));
      found_.neck = turning(found_.chest, end_of_joint(head, kOneNeck * neck));
    }
    name_trunk(found_.neck, {"neck", "head"}, kNeck);
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

  // All joints on the way between two links, from the first on.
  [[nodiscard]] std::vector<PersonJoint> way(int from, int to) const {
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
    std::vector<PersonJoint> joints = way(from, to);
    std::erase_if(joints, [&](const PersonJoint& j) { return !joint(j.joint).turns; });
    return joints;
  }

  // The outermost link beyond `link` that further joints of the same ankle or wrist move: fingers
  // leave by several joints at once or are called so, toes are far away.
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

  // How many of the turning joints on the way to a limb's end come before the one that carries
  // `bone`, or before what hangs on it.
  [[nodiscard]] std::size_t before(const std::vector<PersonJoint>& joints, int from,
                                   int bone) const {
    const std::vector<PersonJoint> all = way(from, bone);
    if (all.empty()) return 0;
    const bool carried = joint(all.back().joint).turns;
    std::size_t count = turning(from, bone).size();
    count = carried && count > 0 ? count - 1 : count;
    return std::min(count, joints.size());
  }

  // A joint at the start of a part that turns about the segment before it is that segment's own
  // rotation: robots have it at its far end.
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
        return fail(ErrorCode::unsupported,
                    fmt::format("no turning joint is the {}{}; a body needs hips, knees, ankles, "
                                "shoulders and elbows that turn",
                                name, part));
      }
      ++k;
    }
    return {};
  }

  Result<void> find_leg(std::size_t side) {
    const auto [hip, knee, ankle] = kLegs[side];
    PersonLimb& leg = found_.legs[side];
    const double shank = norm(at(map_[ankle]) - at(map_[knee]));
    leg.end = end_of_joint(map_[ankle], kOneAnkle * shank);
    leg.joints = turning(found_.pelvis, leg.end);
    std::size_t to_knee = before(leg.joints, found_.pelvis, map_[knee]);
    std::size_t to_ankle = before(leg.joints, found_.pelvis, map_[ankle]);
    give_back_rotation(leg.joints, at(map_[knee]) - at(map_[hip]), 0, to_ankle, to_knee);
    leg.begins = {0, to_knee, to_ankle};
    if (const auto done = check(leg, kSideWords[side], {"hip", "knee", "ankle"}); !done) {
      return done;
    }
    // legs that stand point down, and their frames are the world's
    name_part(leg.joints, 0, to_knee, side, "hip", kHip, Mat3d{});
    name_part(leg.joints, to_knee, to_ankle, side, "knee", kKnee, Mat3d{});
    name_part(leg.joints, to_ankle, leg.joints.size(), side, "ankle", kAnkle, Mat3d{});
    return {};
  }

  Result<void> find_arm(std::size_t side) {
    const auto [upper, elbow, hand] = kArms[side];
    PersonLimb& arm = found_.arms[side];
    const Vec3d forearm = at(map_[hand]) - at(map_[elbow]);
    arm.end = end_of_joint(map_[hand], kOneWrist * norm(forearm));
    arm.joints = turning(found_.chest, arm.end);
    std::size_t to_elbow = before(arm.joints, found_.chest, map_[elbow]);
    std::size_t to_wrist = before(arm.joints, found_.chest, map_[hand]);
    const Vec3d upper_arm = at(map_[elbow]) - at(map_[upper]);
    give_back_rotation(arm.joints, upper_arm, to_elbow >= 3 ? to_elbow - 3 : 0, to_wrist, to_elbow);
    if (to_wrist > to_elbow) {
      give_back_rotation(arm.joints, forearm, to_elbow, arm.joints.size() + 1, to_wrist);
    }
    to_wrist = std::min(to_wrist, arm.joints.size());
    // the shoulder has three freedoms; what is before them lifts it
    const std::size_t ball = to_elbow >= 3 ? to_elbow - 3 : 0;
    const std::size_t to_shoulder = std::min(before(arm.joints, found_.chest, map_[upper]), ball);
    arm.begins = {0, to_shoulder, to_elbow, to_wrist};
    if (const auto done = check(arm, kSideWords[side], {"clavicle", "shoulder", "elbow", "wrist"});
        !done) {
      return done;
    }
    const Vec3d down{0, -1, 0};
    const Mat3d upper_frame = shortest_turn(down, normalized(upper_arm));
    // from a hanging arm the forearm is lifted by the elbow, not turned with the upper arm
    const Vec3d fore_in_upper = transpose_times(upper_frame, normalized(forearm));
    const Mat3d fore_frame = upper_frame * shortest_turn(down, fore_in_upper);
    name_part(arm.joints, 0, to_shoulder, side, "clavicle", kClavicle, Mat3d{});
    name_part(arm.joints, to_shoulder, to_elbow, side, "shoulder", kShoulder, upper_frame);
    name_part(arm.joints, to_elbow, to_wrist, side, "elbow", kElbow, fore_frame);
    bend_by_hinge(arm.joints, to_elbow, to_wrist);
    name_part(arm.joints, to_wrist, arm.joints.size(), side, "wrist", kWrist, fore_frame);
    // the T of a file has some of the abduction already
    const double out = abs(upper_arm.x) / norm(upper_arm);
    for (PersonJoint& j : arm.joints) {
      if (!j.part.ends_with("shoulder") || j.freedom != "abduction" || !j.usual) continue;
      for (double& limit : *j.usual) limit -= asin(clamp(out, 0.0, 1.0));
    }
    return {};
  }

  // Gives joints first … last (less one) the freedoms that their axes are nearest to, the clearest
  // first; axes are seen in `frame`.
  void name_part(std::vector<PersonJoint>& joints, std::size_t first, std::size_t last,
                 std::size_t side, const std::string& part, const Freedoms& freedoms,
                 const Mat3d& frame) const {
    const std::string name = side < kSideWords.size() ? std::string(kSideWords[side]) + part : part;
    for (std::size_t i = first; i < last; ++i) {
      joints[i].part = name;
      joints[i].freedom = joint(joints[i].joint).name;
    }
    std::array<bool, 3> taken{};
    std::vector<bool> named(last - first, false);
    for (std::size_t round = 0; round < freedoms.size(); ++round) {
      constexpr double kLike = 0.6;
      double best = kLike;
      std::size_t which = 0;
      std::size_t freedom = freedoms.size();
      double turn = 1.0;
      for (std::size_t i = first; i < last; ++i) {
        const double outward = joints[i].outward ? 1.0 : -1.0;
        const Vec3d axis = transpose_times(frame, placed_.axis[index(joints[i].joint)]) * outward;
        for (std::size_t f = 0; f < freedoms.size(); ++f) {
          const double along = axis[static_cast<int>(freedoms[f].axis)];
          if (taken[f] || named[i - first] || abs(along) <= best) continue;
          best = abs(along);
          which = i;
          freedom = f;
          turn = along;
        }
      }
      if (freedom == freedoms.size()) return;
      taken[freedom] = true;
      named[which - first] = true;
      const Freedom& f = freedoms[freedom];
      joints[which].freedom = f.name;
      joints[which].sign = (turn < 0.0 ? -1.0 : 1.0) * f.sign * (f.sided && side == 1 ? -1.0 : 1.0);
      joints[which].usual = {f.usual->lower, f.usual->upper};
    }
  }

  // An elbow that has one axis across the arm bends about it, however the arm lies; which way, its
  // limits tell.
  void bend_by_hinge(std::vector<PersonJoint>& joints, std::size_t first, std::size_t last) const {
    PersonJoint* across = nullptr;
    for (std::size_t i = first; i < last; ++i) {
      if (joints[i].freedom == "flexion") return;
      if (joints[i].freedom == "abduction") across = &joints[i];
    }
    if (across == nullptr) return;
    const Robot::Joint& hinge = joint(across->joint);
    across->freedom = "flexion";
    across->sign = hinge.limited && hinge.upper < -hinge.lower ? -1.0 : 1.0;
    across->usual = {kElbowFlexion.lower, kElbowFlexion.upper};
  }

  // Spine and neck: up to three joints of different freedoms are one part.
  void name_trunk(std::vector<PersonJoint>& joints, const std::vector<std::string>& parts,
                  const Freedoms& freedoms) const {
    std::size_t first = 0;
    std::size_t part = 0;
    while (first < joints.size()) {
      std::array<bool, 3> seen{};
      std::size_t last = first;
      for (; last < joints.size(); ++last) {
        const Vec3d& axis = placed_.axis[index(joints[last].joint)];
        const std::size_t along = abs(axis.x) >= abs(axis.y) && abs(axis.x) >= abs(axis.z) ? 0
                                  : abs(axis.y) >= abs(axis.z)                             ? 1
                                                                                           : 2;
        if (seen[along]) break;
        seen[along] = true;
      }
      const std::string name =
          part < parts.size() ? parts[part] : fmt::format("{}_{}", parts.back(), part + 1);
      name_part(joints, first, last, kSideWords.size(), name, freedoms, Mat3d{});
      first = last;
      ++part;
    }
  }

  const Robot& robot_;
  const HumanoidMap& map_;
  const PlacedRobot& placed_;
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
  int axis = 0;
  for (int k = 1; k < 3; ++k) axis = abs(rise[k]) > abs(rise[axis]) ? k : axis;
  Vec3d up{};
  up[axis] = rise[axis] < 0.0 ? -1.0 : 1.0;
  const Vec3d across = normalized(at(Bone::left_upper_leg) - at(Bone::right_upper_leg), {}) +
                       normalized(at(Bone::left_upper_arm) - at(Bone::right_upper_arm), {});
  const Vec3d level = across - up * dot(across, up);
  if (!(norm(level) > 0.2)) {
    return fail(ErrorCode::invalid_argument,
                "the facing cannot be told: the left hip and shoulder stand at the right ones, or "
                "above or below them");
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
